// npm run mutation -- geometry solver/sleep: changes the code of folders or files of src in thousands of small ways, and tells which no test minds. Without
// names: the four folders that a step is made of. With --share 0.1 one change in ten is tried, the same ones each time; --seed 2 takes others. Those left
// out are counted as errors. Where the rest of a score hides is listed as "Survived".
import { execFileSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';

const here = import.meta.dirname;
const root = join(here, '../..');
const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    share: { type: 'string', default: '1' },
    seed: { type: 'string', default: '1' },
    concurrency: { type: 'string', default: '1' },
  },
});
const { share, seed, concurrency } = values;
if (!(Number(share) > 0 && Number(share) <= 1)) {
  throw new RangeError(`--share must be a number > 0 and <= 1, got ${share}`);
}
const names = positionals.length > 0 ? positionals : ['geometry', 'collide', 'solver', 'events'];

if (!existsSync(join(here, 'node_modules'))) {
  execFileSync('npm', ['install', '--no-audit', '--no-fund'], { cwd: here, stdio: 'inherit' });
}
const stryker = join(here, 'node_modules/@stryker-mutator/core/bin/stryker.js');
for (const folder of new Set(names.map((name) => name.split('/')[0]))) {
  const own = names.filter((name) => name.split('/')[0] === folder);
  const files = own.map((name) => (name === folder ? `src/${folder}/**/*.ts` : `src/${name}.ts`));
  console.log(`${files.join(', ')}: ${Number(share) * 100} % of the changes, seed ${seed}`);
  const mutate = ['--mutate', files.join(','), '--concurrency', concurrency];
  const args = [stryker, 'run', 'test/mutation/stryker.json', ...mutate];
  const env = { ...process.env, MUTATED: folder, MUTATION_SHARE: share, MUTATION_SEED: seed };
  execFileSync(process.execPath, args, { cwd: root, stdio: 'inherit', env });
}
