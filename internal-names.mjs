// The names of members that users do not see: minified code has short ones for them.
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

/** Members that are marked internal or private. */
const MARKED =
  /(?:@internal(?![^*]*Keeps its name)(?:[^*]|\*(?!\/))*\*\/\s*|\bprivate )(?:(?:readonly|override|abstract|protected) )*(\w+)/g;

/** The texts of all files of a folder whose names end so. */
export function textOf(folder, ending) {
  return readdirSync(folder, { recursive: true })
    .filter((name) => name.endsWith(ending))
    .map((name) => readFileSync(join(folder, name), 'utf8'))
    .join('\n');
}

export function wordsOf(text) {
  return new Set(text.match(/\w+/g));
}

export function markedIn(source) {
  return [...source.matchAll(MARKED)].map(([, name]) => name);
}

/** For esbuild. */
export function patternOf(names) {
  return new RegExp(`^(${names.join('|')})$`);
}
