// Prints where Chromium, Firefox and the shell of JavaScriptCore are, for the tests in browsers and all engines: node test/browser/engines.mjs [--install]
// CHROMIUM, FIREFOX and JSC may name them. With --install, what is missing is installed as far as that is possible without asking: by apt-get, as root.
import { execFileSync } from 'node:child_process';
import { accessSync, constants } from 'node:fs';
import { delimiter, join } from 'node:path';
import { pathToFileURL } from 'node:url';

const ENGINES = {
  chromium: {
    variable: 'CHROMIUM',
    names: ['chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable'],
    elsewhere: [
      '/Applications/Chromium.app/Contents/MacOS/Chromium',
      '/Applications/Google Chrome.app/Contents/MacOS/Google Chrome',
      'C:\\Program Files\\Google\\Chrome\\Application\\chrome.exe',
    ],
    packageName: 'chromium',
  },
  firefox: {
    variable: 'FIREFOX',
    names: ['firefox-esr', 'firefox'],
    elsewhere: ['/Applications/Firefox.app/Contents/MacOS/firefox', 'C:\\Program Files\\Mozilla Firefox\\firefox.exe'],
    packageName: 'firefox-esr',
  },
  jsc: {
    variable: 'JSC',
    names: ['jsc'],
    elsewhere: ['/System/Library/Frameworks/JavaScriptCore.framework/Versions/Current/Helpers/jsc'],
    packageName: 'libjavascriptcoregtk-4.0-bin',
  },
};

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

function look({ variable, names, elsewhere }) {
  const named = process.env[variable];
  return (named ? [named] : [...names.flatMap(onPath), ...elsewhere]).find(isProgram);
}

/** Where an engine is. */
export function find(name) {
  const found = look(ENGINES[name]);
  if (found === undefined) {
    const { variable, packageName } = ENGINES[name];
    throw new Error(
      `No ${name} found: the tests run in it. Install it (on Debian: apt-get install ${packageName}), or set ${variable} to its path.`,
    );
  }
  return found;
}

function install(packages) {
  if (process.getuid?.() === 0 && onPath('apt-get').some(isProgram)) {
    const options = { stdio: ['ignore', 2, 2], env: { ...process.env, DEBIAN_FRONTEND: 'noninteractive' } };
    execFileSync('apt-get', ['update'], options);
    execFileSync('apt-get', ['install', '--yes', '--no-install-recommends', ...packages], options);
  }
}

if (process.argv[1] && import.meta.url === pathToFileURL(process.argv[1]).href) {
  const missing = Object.values(ENGINES).filter(
    (engine) => !process.env[engine.variable] && look(engine) === undefined,
  );
  if (process.argv.includes('--install') && missing.length > 0) {
    install(missing.map(({ packageName }) => packageName));
  }
  try {
    for (const name of Object.keys(ENGINES)) {
      console.log(find(name));
    }
  } catch (error) {
    console.error(error.message);
    process.exit(1);
  }
}
