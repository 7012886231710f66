// npm run mutation -- geometry events: changes the code of folders of src in thousands of small ways, and tells which no test minds. Without names: the four
// that a step is made of. Takes hours. Where the rest of a score hides is listed as "survived".
import { execFileSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join } from 'node:path';

const here = import.meta.dirname;
const root = join(here, '../..');
const folders = process.argv.length > 2 ? process.argv.slice(2) : ['geometry', 'collide', 'solver', 'events'];

if (!existsSync(join(here, 'node_modules'))) {
  execFileSync('npm', ['install', '--no-audit', '--no-fund'], { cwd: here, stdio: 'inherit' });
}
for (const folder of folders) {
  const stryker = join(here, 'node_modules/@stryker-mutator/core/bin/stryker.js');
  const args = [stryker, 'run', 'test/mutation/stryker.json', '--mutate', `src/${folder}/**/*.ts`];
  execFileSync(process.execPath, args, { cwd: root, stdio: 'inherit', env: { ...process.env, MUTATED: folder } });
}
