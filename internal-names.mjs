// The names of members that users do not see: minified code has short ones for them.
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';

/** Members that are marked internal or private. */
const MARKED =
  /(?:@internal(?![^*]*Keeps its name)(?:[^*]|\*(?!\/))*\*\/\s*|\bprivate )(?:(?:readonly|override|abstract|protected) )*(\w+)/g;

/** The bodies of classes and interfaces, and their members. */
const TYPES = /^(?:export )?(?:abstract )?(?:class|interface) [^{]*\{\n([\s\S]*?)^\}/gm;
const MEMBERS = /^ {2}(?:(?:readonly|override|abstract|protected|get|set) )*(\w+)(?=[?!]?:|\(| =|;)/gm;

/** The texts of all files of a folder whose names end so, but for those of a room of it. */
export function textOf(folder, ending, without) {
  return readdirSync(folder, { recursive: true })
    .filter((name) => name.endsWith(ending) && !(without && name.startsWith(without)))
    .map((name) => readFileSync(join(folder, name), 'utf8'))
    .join('\n');
}

export function wordsOf(text) {
  return new Set(text.match(/\w+/g));
}

export function markedIn(source) {
  return [...source.matchAll(MARKED)].map(([, name]) => name);
}

/** All members of classes and interfaces that are not private. */
export function membersIn(source) {
  return [...source.matchAll(TYPES)].flatMap(([, body]) => [...body.matchAll(MEMBERS)].map(([, name]) => name));
}

/** For esbuild. */
export function patternOf(names) {
  return new RegExp(`^(${names.join('|')})$`);
}
