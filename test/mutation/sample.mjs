import { CheckStatus } from '@stryker-mutator/api/check';
import { declareClassPlugin, PluginKind } from '@stryker-mutator/api/plugin';

const share = Number(process.env.MUTATION_SHARE);
const seed = process.env.MUTATION_SEED;

/** Of a text, evenly spread between 0 and 1: FNV-1a, and the last steps of MurmurHash3. */
function chance(text) {
  let hash = 0x811c9dc5;
  for (const letter of text) {
    hash = Math.imul(hash ^ letter.codePointAt(0), 0x01000193);
  }
  hash = Math.imul(hash ^ (hash >>> 16), 0x85ebca6b);
  hash = Math.imul(hash ^ (hash >>> 13), 0xc2b2ae35);
  return ((hash ^ (hash >>> 16)) >>> 0) / 2 ** 32;
}

/** Leaves out mutants until only a share is left: reported as errors, which do not count in the score. */
class Sample {
  async init() {}

  async check(mutants) {
    return Object.fromEntries(mutants.map((mutant) => [mutant.id, this.judge(mutant)]));
  }

  async group(mutants) {
    return [mutants.map(({ id }) => id)];
  }

  judge({ fileName, location: { start, end }, replacement }) {
    const file = fileName.slice(fileName.lastIndexOf('/src/'));
    const name = [seed, file, start.line, start.column, end.line, end.column, replacement].join(' ');
    return chance(name) < share
      ? { status: CheckStatus.Passed }
      : { status: CheckStatus.CompileError, reason: 'not in the sample' };
  }
}

export const strykerPlugins = [declareClassPlugin(PluginKind.Checker, 'sample', Sample)];
