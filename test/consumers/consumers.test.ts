import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { PROGRAMS, partsOf } from '../package/bundlers.js';
import { installTools, Project, tool, toolFile } from './project.js';
import { TYPES, USER_DATA } from './types.js';

// The package as npm packs it, installed into a fresh project and used with the compilers and bundlers that users have.

let project: Project;
const home = (...path: string[]): string => join(project.folder, 'node_modules/phys2d', ...path);

beforeAll(() => {
  installTools();
  project = new Project();
  project.write({ ...TYPES, ...USER_DATA });
  project.write(Object.fromEntries(PROGRAMS.map(({ code }, i) => [`bundles/${i}.mjs`, code])));
}, 120_000);

afterAll(() => project?.remove());

describe('checkers', () => {
  it('publint has nothing to say', async () => {
    interface Publint {
      publint(options: { pkgDir: string; strict: boolean; pack: false }): Promise<{ messages: unknown[] }>;
    }
    const { publint } = await tool<Publint>('publint');
    const { messages } = await publint({ pkgDir: home(), strict: true, pack: false });
    expect(messages).toEqual([]);
  });

  it('@arethetypeswrong/cli has nothing to say', async () => {
    const report = await project.node(
      toolFile('@arethetypeswrong/cli/dist/index.js'),
      project.tarball,
      '--format',
      'json',
    );
    const { analysis, problems } = JSON.parse(report) as { analysis: { entrypoints: object }; problems?: object };
    expect(Object.keys(analysis.entrypoints)).toEqual(
      expect.arrayContaining(['.', './debug', './outline', './runner', './state', './validate']),
    );
    expect(problems ?? {}).toEqual({});
  });
});

describe.concurrent('compilers', () => {
  const STRICT =
    '--noEmit --strict --skipDefaultLibCheck --exactOptionalPropertyTypes --noUncheckedIndexedAccess --noPropertyAccessFromIndexSignature --esModuleInterop';
  const options = `${STRICT} --target es2022 --lib es2022,dom --typeRoots none`.split(' ');
  const newest = join(import.meta.dirname, '../../node_modules/typescript/bin/tsc');
  const old = (version: string): string => toolFile(`typescript-${version}/bin/tsc`);
  const files = Object.keys(TYPES);

  // TypeScript tells modules of the two kinds apart in a declaration since 5.3.
  it.each([
    ['5.0', 'node16', ['import.mts']],
    ['5.0', 'bundler', ['import.mts']],
    ['5.3', 'node16', files],
    ['5.9', 'node16', files],
    ['5.9', 'nodenext', files],
    ['5.9', 'bundler', ['import.mts']],
    ['5.9', 'node10', ['named.cts']],
    ['newest', 'node16', files],
    ['newest', 'nodenext', files],
    ['newest', 'bundler', ['import.mts']],
    ['5.0', 'bundler', ['user-data.mts']],
    ['5.9', 'node16', ['user-data.mts']],
    ['newest', 'nodenext', ['user-data.mts']],
  ])('TypeScript %s with moduleResolution %s: %j', async (version, resolution, sources) => {
    const tsc = version === 'newest' ? newest : old(version);
    const module = { bundler: 'esnext', node10: 'commonjs' }[resolution] ?? resolution;
    const command = [tsc, ...options, '--module', module, '--moduleResolution', resolution, ...sources];
    expect(await project.node(...command)).toBe('');
  });

  it('a mistake is one for them', async () => {
    project.write({ 'mistake.mts': "import { World } from 'phys2d';\nexport const name: string = World.name.length;" });
    expect(await project.node(newest, ...options, '--module', 'node16', 'mistake.mts')).toContain('TS2322');
  });

  it('the declarations have no any', () => {
    const declarations = readdirSync(home('dist'), { recursive: true, encoding: 'utf8' }).filter((name) =>
      /\.d\.c?ts$/.test(name),
    );
    expect(declarations.length).toBeGreaterThan(20);
    const found = declarations.filter((name) => {
      const text = readFileSync(home('dist', name), 'utf8').replace(/\/\*[\s\S]*?\*\//g, '');
      return /[:<|,(&=] *any\b/.test(text);
    });
    expect(found).toEqual([]);
  });
});

/** Bundles a file of the project for a browser. */
type Bundle = (file: string) => Promise<string>;

interface RollupOutput {
  output: { code: string }[];
}

const BUNDLERS: Record<string, Bundle> = {
  async vite(file) {
    interface Vite {
      build(options: object): Promise<RollupOutput[]>;
    }
    const { build } = await tool<Vite>('vite');
    const lib = { entry: file, formats: ['es'] };
    const options = { root: project.folder, configFile: false, logLevel: 'silent' };
    const [result] = await build({ ...options, build: { lib, write: false, minify: true } });
    return result!.output[0]!.code;
  },
  async rollup(file) {
    interface Rollup {
      rollup(options: object): Promise<{ generate(options: object): Promise<RollupOutput> }>;
    }
    const { rollup } = await tool<Rollup>('rollup');
    const { nodeResolve } = await tool<{ nodeResolve(): object }>('@rollup/plugin-node-resolve');
    const bundle = await rollup({ input: file, plugins: [nodeResolve()] });
    return (await bundle.generate({ format: 'es' })).output[0]!.code;
  },
  async webpack(file) {
    type Webpack = (options: object, done: (error: Error | null, stats: { hasErrors(): boolean }) => void) => void;
    const { default: webpack } = await tool<{ default: Webpack }>('webpack');
    const output = { path: project.folder, filename: 'webpack.js' };
    const options = { context: project.folder, entry: file, mode: 'production', target: 'web', output };
    await new Promise<void>((resolve, reject) => {
      webpack({ ...options, performance: false }, (error, stats) =>
        error !== null || stats.hasErrors() ? reject(error ?? new Error(String(stats))) : resolve(),
      );
    });
    return readFileSync(join(project.folder, output.filename), 'utf8');
  },
};

const CORE = 'world, circles and a broadphase';
const UNTIED = 'everything but constraints';

it.each([
  ['vite', CORE],
  ['vite', UNTIED],
  ['vite', 'everything, with debug drawing'],
  ['rollup', CORE],
  ['rollup', UNTIED],
  ['webpack', UNTIED],
])(
  '%s bundles %s: what is used and nothing else, and it runs',
  async (bundler, name) => {
    const i = PROGRAMS.findIndex((program) => program.name === name);
    const text = await BUNDLERS[bundler]!(join(project.folder, `bundles/${i}.mjs`));
    expect(partsOf(text).sort()).toEqual([...PROGRAMS[i]!.parts].sort());
    writeFileSync(join(project.folder, 'out.mjs'), text);
    expect(await project.node('out.mjs')).toBe('fell 5');
  },
  60_000,
);

describe('Node', () => {
  it('imports and requires it, and a worker thread does', async () => {
    const fall = `const world = phys2D.createWorld();
const body = phys2D.createRigidBody({ shapes: [phys2D.createCircleShape({ radius: 0.5 })] });
world.addRigidBody(body);
for (let i = 0; i < 60; i += 1) world.step(1 / 60);
console.log(body.getPosition().join());`;
    project.write({
      'run.mjs': `import phys2D from 'phys2d';\n${fall}`,
      'run.cjs': `const phys2D = require('phys2d');\n${fall}`,
      'thread.mjs': "import { Worker } from 'node:worker_threads';\nnew Worker(new URL('run.mjs', import.meta.url));",
    });
    const imported = await project.node('run.mjs');
    expect(imported).toMatch(/^0,4\.\d+$/);
    expect(await project.node('run.cjs')).toBe(imported);
    expect(await project.node('thread.mjs')).toBe(imported);
  });

  it.each(['phys2d.js', 'phys2d.min.js', 'phys2d.umd.cjs'])(
    'an error within %s is traced to the source',
    async (name) => {
      const code = `import phys2D from './node_modules/phys2d/dist/${name}';\nphys2D.createWorld().step(0);`;
      project.write({ 'trace.mjs': code });
      const trace = await project.node('--enable-source-maps', 'trace.mjs');
      expect(trace).toContain('RangeError: World.step: deltaTime');
      const line = Number(/src[/\\]world\.ts:(\d+)/.exec(trace)?.[1]);
      const source = readFileSync(join(import.meta.dirname, '../../src/world.ts'), 'utf8').split('\n');
      expect(source[line - 1]).toContain("positive('World.step'");
    },
  );

  it('each bundle has a map that holds all its sources', () => {
    const bundles = readdirSync(home('dist')).filter((name) => /\.c?js$/.test(name));
    expect(bundles.length).toBeGreaterThan(8);
    for (const name of bundles) {
      const link = /\/\/# sourceMappingURL=(\S+)\s*$/.exec(readFileSync(home('dist', name), 'utf8'))?.[1] ?? '';
      expect(existsSync(home('dist', link)), name).toBe(true);
      const map = JSON.parse(readFileSync(home('dist', link), 'utf8')) as {
        sources: string[];
        sourcesContent: string[];
      };
      expect(map.sourcesContent.filter((text) => typeof text === 'string' && text.length > 0)).toHaveLength(
        map.sources.length,
      );
    }
  });
});
