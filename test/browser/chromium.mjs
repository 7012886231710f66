// Prints where a Chromium is, for the tests in a browser: node test/browser/chromium.mjs [--install]
// CHROMIUM may name one. With --install, one is installed if there is none, as far as that is possible without asking: by apt-get, as root.
import { execFileSync } from 'node:child_process';
import { accessSync, constants } from 'node:fs';
import { delimiter, join } from 'node:path';

const NAMES = ['chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable'];
const ELSEWHERE = [
  '/Applications/Chromium.app/Contents/MacOS/Chromium',
  '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome',
  'C:\\Program Files\\Google\\Chrome\\Application\\chrome.exe',
];

function isProgram(path) {
  try {
    accessSync(path, constants.X_OK);
    return true;
  } catch {
    return false;
  }
}

function onPath(name) {
  return (process.env.PATH ?? '').split(delimiter).map((folder) => join(folder, name));
}

function find() {
  if (process.env.CHROMIUM) {
    return [process.env.CHROMIUM].find(isProgram);
  }
  return [...NAMES.flatMap(onPath), ...ELSEWHERE].find(isProgram);
}

function install() {
  if (process.getuid?.() === 0 && onPath('apt-get').some(isProgram)) {
    const options = { stdio: ['ignore', 2, 2], env: { ...process.env, DEBIAN_FRONTEND: 'noninteractive' } };
    execFileSync('apt-get', ['update'], options);
    execFileSync('apt-get', ['install', '--yes', '--no-install-recommends', 'chromium'], options);
  }
}

if (process.argv.includes('--install') && !process.env.CHROMIUM && find() === undefined) {
  install();
}
const found = find();
if (found === undefined) {
  console.error(
    `No Chromium found: some tests run in one. Install it (on Debian: apt-get install chromium), or set CHROMIUM to its path.`,
  );
  process.exit(1);
}
console.log(found);
