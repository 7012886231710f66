// Builds into dist/ what is published, and the examples: node build.mjs
import { execFile, execFileSync } from 'node:child_process';
import { copyFileSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { promisify } from 'node:util';
import { gzipSync } from 'node:zlib';
import { build } from 'esbuild';
import { minify as terser } from 'terser';
import { markedIn, membersIn, patternOf, textOf, wordsOf } from './internal-names.mjs';

const root = fileURLToPath(new URL('.', import.meta.url));
const dist = join(root, 'dist');
// minifySyntax puts the numbers of named constants into the hot loops (a sixth of a step), and leaves the names readable.
const common = { absWorkingDir: root, bundle: true, target: 'es2022', sourcemap: true, minifySyntax: true };

/** For terser: the numbers of constants stand where they are asked for, and nothing else is changed. */
const CONSTANTS = { defaults: false, evaluate: true, reduce_vars: true };

const execFileAsync = promisify(execFile);

// What a game that ships without it does not pay for is a module of its own.
const modules = {
  phys2d: 'src/index.ts',
  debug: 'src/debug/index.ts',
  outline: 'src/outline/index.ts',
  runner: 'src/runner.ts',
  state: 'src/state/index.ts',
  validate: 'src/audit/index.ts',
};

rmSync(dist, { recursive: true, force: true });
buildTypes();
const others = ['debug', 'outline', 'runner', 'state', 'validate'];
await Promise.all(others.map((name) => buildEsm(name, false)));
const internal = internalNames();
// The validator reads nearly everything of a world: its minified bundle has the short names of the engine's.
const { mangleCache } = await buildEsm('phys2d', true);
await Promise.all([
  buildEsm('phys2d', false),
  ...others.map((name) => buildEsm(name, true, mangleCache)),
  buildUmd(false),
  buildUmd(true),
  buildExamples(),
  buildPlayground(),
]);
const published = [...Object.keys(modules), 'phys2d.umd'];
await Promise.all([
  ...published.map(squeeze),
  ...published.map((name) => dropComments(name.endsWith('umd') ? `${name}.cjs` : `${name}.js`)),
]);
copyFileSync(join(dist, 'phys2d.umd.cjs'), join(dist, 'phys2d.umd.js'));
printSizes();

function buildEsm(name, minify, mangleCache = {}) {
  const outfile = minify ? `dist/${name}.min.js` : `dist/${name}.js`;
  const plugins = name === 'phys2d' ? [debugApart(minify)] : [];
  return build({
    ...common,
    entryPoints: [modules[name]],
    outfile,
    format: 'esm',
    plugins,
    ...minified(minify, mangleCache),
  });
}

/** Takes another 3 % off a minified bundle. Constants stay on their side of comparisons: 0.3 kB more of it look alike to gzip. */
function squeeze(name) {
  return rewrite(`${name}.min.js`, { compress: { lhs_constants: false } });
}

/**
 * Leaves out the comments, which are in the types and the source map: with them an import takes longer; and puts the numbers of constants into the code where esbuild, which does so for files without imports alone, has not.
 */
function dropComments(name) {
  const format = { beautify: true, comments: false, preserve_annotations: true, indent_level: 2 };
  return rewrite(name, { compress: CONSTANTS, mangle: false, format });
}

/** With one sign beyond ASCII the whole text would be of twice the width: an import would take a seventh longer. */
async function rewrite(name, { format, ...options }) {
  const file = join(dist, name);
  const sourceMap = {
    content: readFileSync(`${file}.map`, 'utf8'),
    includeSources: true,
    filename: name,
    url: `${name}.map`,
  };
  const { code, map } = await terser(readFileSync(file, 'utf8'), {
    ecma: 2020,
    module: !name.includes('umd'),
    sourceMap,
    format: { ascii_only: true, ...format },
    ...options,
  });
  writeFileSync(file, code);
  writeFileSync(`${file}.map`, map);
}

/** The engine passes debug drawing on from its module: there is one of it, and who does not use it bundles nothing of it. */
function debugApart(minify) {
  const path = minify ? './debug.min.js' : './debug.js';
  return {
    name: 'debug apart',
    setup: ({ onResolve }) =>
      onResolve({ filter: /^\.\/debug\/index\.js$/ }, () => ({ path, external: true, sideEffects: false })),
  };
}

/** Minified bundles have short names for internal members too. */
function minified(minify, mangleCache) {
  return minify ? { minify, mangleProps: patternOf(internal), mangleCache } : {};
}

/**
 * Members whose names appear neither in the published types nor in the language's own objects: those marked internal or private, and all
 * others that neither the bundles beside the engine's nor the kernels in WebAssembly name. What one bundle reads of another's objects that
 * is marked says that it keeps its name. The validator has short names, see above.
 */
function internalNames() {
  // The declarations name private members too, and the files they are in.
  const unpublished = /\/\*[\s\S]*?\*\/|^ *private .*|from '.*'/gm;
  const published = wordsOf(textOf(dist, '.d.ts').replace(unpublished, ''));
  const types = [Object, Function, Array, Float64Array, Int32Array, Map, Set, Math, Number, String, RegExp, DataView];
  const language = [...types, WebAssembly]
    .flatMap((type) => [type, type.prototype, Object.getPrototypeOf(type.prototype ?? {})])
    .flatMap((object) => (object ? Object.getOwnPropertyNames(object) : []));
  const source = textOf(join(root, 'src'), '.ts');
  const beside = others
    .filter((name) => name !== 'validate')
    .map((name) => readFileSync(join(dist, `${name}.js`), 'utf8'));
  const shared = wordsOf([...beside, textOf(join(root, 'simd'), '.ts')].join('\n'));
  const kept = new Set([...published, ...language, 'export', 'constructor']);
  return [...new Set([...markedIn(source), ...membersIn(source).filter((name) => !shared.has(name))])].filter(
    (name) => !kept.has(name),
  );
}

/** One file for CommonJS, AMD and the script tag. esbuild does not know UMD: the bundle is a function's body here. */
function buildUmd(minify) {
  const outfile = minify ? 'dist/phys2d.umd.min.js' : 'dist/phys2d.umd.cjs';
  const head = `(function (root, factory) {
  if (typeof module === 'object' && module.exports) module.exports = factory();
  else if (typeof define === 'function' && define.amd) define([], factory);
  else root.phys2D = factory();
})(typeof globalThis === 'object' ? globalThis : this, function () {`;
  return build({
    ...common,
    entryPoints: ['src/umd.ts'],
    outfile,
    format: 'iife',
    globalName: 'bundle',
    banner: { js: minify ? head.replace(/\s*\n\s*/g, ' ') : head },
    footer: { js: 'return bundle.default;\n});' },
    ...minified(minify, {}),
  });
}

/** The examples, as a user's programs: what they import from 'phys2d' comes from the built bundle beside them. */
function buildExamples() {
  const phys2d = {
    name: 'phys2d',
    setup: ({ onResolve }) =>
      onResolve({ filter: /^phys2d(\/\w+)?$/ }, ({ path }) => ({
        path: `../${path.replace('phys2d/', '')}.js`,
        external: true,
      })),
  };
  const entryPoints = readdirSync(join(root, 'examples'))
    .filter((name) => name.endsWith('.ts'))
    .map((name) => `examples/${name}`);
  return build({ ...common, entryPoints, outdir: 'dist/examples', format: 'esm', platform: 'node', plugins: [phys2d] });
}

/** The playground, as a program of its own. */
function buildPlayground() {
  return execFileAsync(process.execPath, ['playground/build.mjs'], { cwd: root });
}

/** Declarations of the public names: those of the modules and the files they lead to, and `umd.d.cts` for `require`. */
function buildTypes() {
  const all = join(dist, 'types');
  const options = '--ignoreConfig --target es2022 --lib es2022 --module nodenext --strict --exactOptionalPropertyTypes';
  const output = `--declaration --emitDeclarationOnly --stripInternal --rootDir src --outDir ${relative(root, all)}`;
  const command = `node_modules/typescript/bin/tsc ${Object.values(modules).join(' ')} ${options} ${output}`;
  execFileSync(process.execPath, command.split(' '), { cwd: root, stdio: 'inherit' });

  const wanted = new Set(Object.values(modules).map((file) => file.replace('src/', '').replace('.ts', '.d.ts')));
  for (const name of wanted) {
    const text = readFileSync(join(all, name), 'utf8');
    for (const [, target] of text.matchAll(/\b(?:from |import\()'(\.[^']*)\.js'/g)) {
      wanted.add(join(dirname(name), `${target}.d.ts`));
    }
    mkdirSync(dirname(join(dist, name)), { recursive: true });
    writeFileSync(
      join(dist, name),
      hideConstructors(text, readFileSync(join(root, 'src', name.replace('.d.ts', '.ts')), 'utf8')),
    );
  }
  rmSync(all, { recursive: true });

  writeFileSync(join(dist, 'umd.d.cts'), umdTypes());
}

/** Where `stripInternal` took the constructor of a class there would be a public one without arguments: objects are made by the functions for it. */
function hideConstructors(declarations, source) {
  const internal = /class (\w+)(?:(?!^\S)[\s\S])*?@internal[^*]*\*\/\s*constructor\(/gm;
  return [...source.matchAll(internal)].reduce(
    (text, [, name]) => text.replace(new RegExp(`(class ${name}\\b[^{]*\\{\n)`), '$1    protected constructor();\n'),
    declarations,
  );
}

/** Every public name as a member of one namespace: what `require` and the script tag give. */
function umdTypes() {
  const members = new Map();
  for (const [module, file] of [
    ['audit', 'audit/index.d.ts'],
    ['state', 'state/index.d.ts'],
    ['runner', 'runner.d.ts'],
    ['outline', 'outline/index.d.ts'],
    ['debug', 'debug/index.d.ts'],
    ['names', 'index.d.ts'],
  ]) {
    const exported = /export (type )?\{([^}]*)\}|export (?:declare )?(class|interface|function) (\w+)/g;
    for (const [, type, list, kind, single] of readFileSync(join(dist, file), 'utf8').matchAll(exported)) {
      for (const name of (list ?? single).split(',').map((part) => part.trim().replace(/.* as default$/, ''))) {
        // Constants are UPPER_SNAKE.
        const isType = /^[A-Z]\w*[a-z]/.test(name);
        const isValue = type === undefined && kind !== 'interface' && name !== '';
        members.set(name, [
          ...(isType ? [`  type ${name} = ${module}.${name};`] : []),
          ...(isValue ? [`  const ${name}: typeof ${module}.${name};`] : []),
        ]);
      }
    }
  }
  const lines = [...members.keys()].sort().flatMap((name) => members.get(name));
  return `import type * as debug from './debug/index.js' with { 'resolution-mode': 'import' };
import type * as names from './index.js' with { 'resolution-mode': 'import' };
import type * as outline from './outline/index.js' with { 'resolution-mode': 'import' };
import type * as runner from './runner.js' with { 'resolution-mode': 'import' };
import type * as audit from './audit/index.js' with { 'resolution-mode': 'import' };
import type * as state from './state/index.js' with { 'resolution-mode': 'import' };

/** A device that is ready to use, with every public class as a property. */
declare namespace phys2D {
${lines.join('\n')}
  const vendor: names.Physics2DDevice['vendor'];
}
export = phys2D;
export as namespace phys2D;
`;
}

function printSizes() {
  const kB = (bytes) => `${(bytes / 1000).toFixed(1)} kB`.padStart(10);
  const size = (text) => `${kB(text.length)}${kB(gzipSync(text, { level: 9 }).length)}`;
  console.log(
    `${'dist/'.padEnd(18)}${['size', 'gzip', 'minified', 'gzip'].map((title) => title.padStart(10)).join('')}`,
  );
  for (const [name, minified] of [
    ['phys2d.js', 'phys2d.min.js'],
    ['debug.js', 'debug.min.js'],
    ['outline.js', 'outline.min.js'],
    ['runner.js', 'runner.min.js'],
    ['state.js', 'state.min.js'],
    ['validate.js', 'validate.min.js'],
    ['phys2d.umd.cjs', 'phys2d.umd.min.js'],
  ]) {
    console.log(`${name.padEnd(18)}${size(readFileSync(join(dist, name)))}${size(readFileSync(join(dist, minified)))}`);
  }
}
