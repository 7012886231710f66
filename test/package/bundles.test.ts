import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { type Context, createContext, runInContext } from 'node:vm';
import { gzipSync } from 'node:zlib';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import * as validate from '../../src/audit/index.js';
import * as debug from '../../src/debug/index.js';
import * as source from '../../src/index.js';
import * as outline from '../../src/outline/index.js';
import * as runner from '../../src/runner.js';
import * as state from '../../src/state/index.js';
import { buildGallery, GALLERY } from '../scenes/gallery.js';
import { stateHash } from '../scenes/hash.js';
import { buildPyramid } from '../scenes/pyramid.js';
import { Tangle } from '../scenes/tangle.js';

// The bundles as built, loaded in every way that users load them.

const root = join(import.meta.dirname, '../..');
const dist = join(root, 'dist');
const read = (name: string): string => readFileSync(join(dist, name), 'utf8');
const UMD = ['phys2d.umd.cjs', 'phys2d.umd.js', 'phys2d.umd.min.js'];
const ESM = ['phys2d.js', 'phys2d.min.js'];
const GZIP_LIMITS = {
  'phys2d.min.js': 114_600,
  'debug.min.js': 9_950,
  'outline.min.js': 4_650,
  'runner.min.js': 1_250,
  'state.min.js': 4_950,
  'validate.min.js': 4_000,
};

/** What is imported apart from the engine, so that a game that ships without it pays nothing. */
const APART = { debug, outline, runner, state, validate };

const { default: _, ...engine }: Record<string, unknown> = source;
const names: Record<string, unknown> = { ...engine, ...debug, ...outline, ...runner, ...state, ...validate };

/** Public classes that a script tag user reaches as `phys2D.World` and so on. */
const CLASSES = Object.entries(names)
  .filter(([name, value]) => typeof value === 'function' && /^[A-Z]/.test(name))
  .map(([name]) => name);

type Phys2D = source.Physics2DDevice &
  Omit<typeof source, 'default'> &
  typeof debug &
  typeof outline &
  typeof runner &
  typeof state &
  typeof validate;

const DROP = `
  const world = phys2D.createWorld({ gravity: [0, 10] });
  const body = phys2D.createRigidBody({ shapes: [phys2D.createCircleShape({ radius: 0.5 })] });
  world.addRigidBody(body);
  for (let i = 0; i < 60; i += 1) world.step(1 / 60);
  body.getPosition()[1];
`;

/** State after a pyramid has settled for a while, and of a tangle of constraints of all kinds. */
function simulate(phys2D: source.Physics2DDevice): string {
  const world = phys2D.createWorld({ velocityIterations: 8 });
  buildPyramid(phys2D, world, 6);
  const { world: tangled } = new Tangle(phys2D, phys2D.createWorld(), 3, 30, 40);
  for (let i = 0; i < 120; i += 1) {
    world.step(1 / 60);
    tangled.step(1 / 60);
  }
  return stateHash(world) + stateHash(tangled);
}

/** Runs a bundle as a script tag does: in a context that has the language and nothing else. */
function runAsScript(name: string, globals: object = {}): Context {
  const context = createContext(Object.assign(Object.create(null), globals));
  runInContext(read(name), context, { filename: name });
  return context;
}

async function importBundle(name: string): Promise<typeof source> {
  return (await import(/* @vite-ignore */ pathToFileURL(join(dist, name)).href)) as typeof source;
}

beforeAll(() => {
  if (!existsSync(join(dist, 'umd.d.cts'))) {
    throw new Error('dist is not complete: run `npm run build` first (`npm test` does)');
  }
});

describe.each(UMD)('%s as a script', (name) => {
  it('sets exactly one global, phys2D', () => {
    const globals = 'Object.getOwnPropertyNames(globalThis)';
    const before: string[] = runInContext(globals, createContext(Object.create(null)));
    const after: string[] = runInContext(globals, runAsScript(name));
    expect(after.filter((key) => !before.includes(key))).toEqual(['phys2D']);
  });

  it('works without console, timers or any other API of a host', () => {
    const fallen: number = runInContext(DROP, runAsScript(name));
    expect(fallen).toBeGreaterThan(4.7);
    expect(fallen).toBeLessThan(5.1);
  });

  it('has every public name', () => {
    const phys2D = runAsScript(name).phys2D as Record<string, unknown>;
    expect(CLASSES).toEqual(expect.arrayContaining(['Physics2DDevice', 'Physics2DDebugDraw', 'FixedStepRunner']));
    for (const [key, value] of Object.entries(names)) {
      expect(typeof phys2D[key], key).toBe(typeof value);
    }
    const works = runInContext('phys2D.createWorld() instanceof phys2D.World', runAsScript(name));
    expect(works).toBe(true);
  });

  it('is an anonymous AMD module where there is a loader, and sets no global then', () => {
    const calls: unknown[][] = [];
    const define = Object.assign((...args: unknown[]) => void calls.push(args), { amd: {} });
    const context = runAsScript(name, { define });
    expect(context.phys2D).toBeUndefined();
    expect(calls).toHaveLength(1);
    const [dependencies, factory] = calls[0] as [string[], () => Phys2D];
    expect([...dependencies]).toEqual([]);
    expect(typeof factory().createWorld).toBe('function');
  });
});

describe('the UMD bundle as a CommonJS module', () => {
  const phys2D = createRequire(import.meta.url)(join(dist, 'phys2d.umd.cjs')) as Phys2D;

  it('exports the ready device with every public class', () => {
    expect(phys2D.createWorld()).toBeInstanceOf(phys2D.World);
    expect(phys2D).toBeInstanceOf(phys2D.Physics2DDevice);
    expect(Object.keys(phys2D)).toEqual(expect.arrayContaining(CLASSES));
  });

  it('makes worlds that can be saved', () => {
    const { createWorld } = phys2D;
    const world = createWorld();
    const hash = world.hash();
    const snapshot = world.snapshot();
    world.step(1 / 60);
    expect(world.hash()).not.toBe(hash);
    world.restore(snapshot);
    expect(world.hash()).toBe(hash);
  });

  it('sets no global', () => {
    expect('phys2D' in globalThis).toBe(false);
  });

  it('is served under the name for script tags too', () => {
    expect(read('phys2d.umd.js')).toBe(read('phys2d.umd.cjs'));
  });
});

describe.each(ESM)('%s as a module', (name) => {
  it('exports what the source exports, by name and by default', async () => {
    const bundle = await importBundle(name);
    expect(Object.keys(bundle).sort()).toEqual(Object.keys(source).sort());
    expect(bundle.default).toBe(bundle.phys2D);
    expect(bundle.phys2D).toBeInstanceOf(bundle.Physics2DDevice);
  });
});

describe.each(['debug', 'outline', 'runner', 'state', 'validate'] as const)('%s as a module', (name) => {
  it.each(['js', 'min.js'])('exports what the source exports (.%s), and has nothing of the engine', async (ending) => {
    const bundle = (await import(/* @vite-ignore */ pathToFileURL(join(dist, `${name}.${ending}`)).href)) as object;
    expect(Object.keys(bundle).sort()).toEqual(Object.keys(APART[name]).sort());
    const map = JSON.parse(read(`${name}.${ending}.map`)) as { sources: string[] };
    expect(map.sources).toContain(
      {
        debug: '../src/debug/draw.ts',
        outline: '../src/outline/index.ts',
        runner: '../src/runner.ts',
        state: '../src/state/serialize.ts',
        validate: '../src/audit/index.ts',
      }[name],
    );
    expect(
      map.sources.filter((file) => /(?:solver|collide|contact|constraint|shape)\/|\/(?:body|world)\.ts/.test(file)),
    ).toEqual([]);
  });
});

it.each(ESM)('%s has debug drawing from its module, and nothing of the runner and validation', async (name) => {
  const { sources } = JSON.parse(read(`${name}.map`)) as { sources: string[] };
  expect(sources.filter((file) => /debug\/(?!index)|outline\/|runner|body-pose|audit/.test(file))).toEqual([]);
  const apart = pathToFileURL(join(dist, name.replace('phys2d', 'debug'))).href;
  const { Physics2DDebugDraw } = (await import(/* @vite-ignore */ apart)) as typeof debug;
  expect((await importBundle(name)).Physics2DDebugDraw).toBe(Physics2DDebugDraw);
});

it.each([...ESM, ...UMD])('%s names the class of what is wrong, if its name is there to be told', async (name) => {
  const { phys2D } = UMD.includes(name) ? (runAsScript(name) as { phys2D: Phys2D }) : await importBundle(name);
  const shown = name.includes('min') ? 'an object' : 'an object of class Circle';
  expect(() => phys2D.createWorld().addRigidBody(phys2D.createCircleShape({ radius: 1 }) as never)).toThrow(
    expect.objectContaining({ message: `World.addRigidBody: body must be a RigidBody, got ${shown}` }),
  );
});

it.each([
  ['phys2d.js', 'phys2d.min.js'],
  ['phys2d.min.js', 'phys2d.js'],
  ['phys2d.js', 'phys2d.umd.cjs'],
])('%s refuses worldState of %s', async (name, other) => {
  const { createWorld } = await importBundle(name);
  const { worldState } = await importBundle(other);
  expect(() => createWorld({ state: worldState })).toThrow(
    new TypeError('createWorld: state must be worldState of the same bundle, got an object'),
  );
});

describe('the state', () => {
  it.each([
    ['phys2d.js', 'state.js'],
    ['phys2d.min.js', 'state.min.js'],
    ['phys2d.min.js', 'state.js'],
    ['phys2d.js', 'state.min.js'],
  ])('is kept by %s and %s together', async (engineFile, stateFile) => {
    const load = async (name: string): Promise<unknown> =>
      import(/* @vite-ignore */ pathToFileURL(join(dist, name)).href);
    const { phys2D } = (await load(engineFile)) as typeof source;
    const { deserialize, PoseBuffer, Recorder, replay, serialize } = (await load(stateFile)) as typeof state;
    const world = phys2D.createWorld();
    buildPyramid(phys2D, world, 5);
    const poses = PoseBuffer.create({ capacity: 20 });
    const top = world.rigidBodies[15]!;
    const index = poses.track(top);
    world.poses = poses;
    const recorder = Recorder.create(world);
    recorder.call(top, 'setVelocity', [3, -2]);
    for (let i = 0; i < 30; i += 1) {
      recorder.step(1 / 60);
    }
    const [x] = top.getPosition();
    expect(poses.poses[4 * index]).toBe(Math.fround(x));
    const copy = deserialize(phys2D, JSON.parse(JSON.stringify(serialize(world))) as state.PlainWorld);
    expect(copy.hash()).toBe(world.hash());
    expect(replay(world, recorder.recording)).toBe(-1);
    expect(world.hash()).toBe(copy.hash());
  });
});

describe('one picture', () => {
  /** The gallery, with all details, between two steps: whatever debug drawing reads of the engine's objects is in it. */
  function picture(
    { phys2D }: Pick<typeof source, 'phys2D'>,
    { Physics2DDebugDraw, SVGDebugDevice }: typeof debug,
    { FixedStepRunner }: typeof runner,
  ): string {
    const world = phys2D.createWorld();
    buildGallery(phys2D, world);
    const stepper = FixedStepRunner.create({ world, maxSteps: 30 });
    stepper.advance(24.7 / 60);
    const graphicsDevice = SVGDebugDevice.create({ width: 60 * GALLERY[0], height: 60 * GALLERY[1] });
    const draw = Physics2DDebugDraw.create({ graphicsDevice });
    draw.showBodyDetail = draw.showShapeDetail = draw.showContacts = draw.showContactImpulses = true;
    draw.interpolation = stepper.interpolation;
    draw.begin();
    draw.drawWorld(world);
    draw.end();
    return `${graphicsDevice} ${world.rigidBodies.map((body) => stepper.getPosition(body))}`;
  }
  const expected = picture(source, debug, runner);

  it.each([
    ['phys2d.js', 'debug.js', 'runner.js'],
    ['phys2d.min.js', 'debug.min.js', 'runner.min.js'],
    ['phys2d.min.js', 'debug.js', 'runner.js'],
    ['phys2d.js', 'debug.min.js', 'runner.min.js'],
  ])('is drawn by %s, %s and %s together', async (engineFile, debugFile, runnerFile) => {
    const load = (name: string): Promise<unknown> => import(/* @vite-ignore */ pathToFileURL(join(dist, name)).href);
    const loaded = (await Promise.all([load(engineFile), load(debugFile), load(runnerFile)])) as Parameters<
      typeof picture
    >;
    expect(picture(...loaded)).toBe(expected);
  });

  it.each(UMD)('is drawn by %s', (name) => {
    const phys2D = runAsScript(name).phys2D as Phys2D;
    expect(picture({ phys2D }, phys2D, phys2D)).toBe(expected);
  });
});

describe('validate', () => {
  const load = async (ending: string): Promise<typeof source & typeof validate> => {
    const [engine, apart] = await Promise.all(
      ['phys2d', 'validate'].map(
        (name) => import(/* @vite-ignore */ pathToFileURL(join(dist, `${name}.${ending}`)).href),
      ),
    );
    return { ...engine, validate: apart.validate };
  };
  const check = (phys2D: source.Physics2DDevice, judge: typeof validate.validate): void => {
    const { world } = new Tangle(phys2D, phys2D.createWorld(), 3, 30, 40);
    for (let i = 0; i < 10; i += 1) {
      world.step(1 / 60);
      judge(world);
    }
    world.rigidBodies.reverse();
    expect(() => judge(world)).toThrow('validate: world.rigidBodies[0]: index must be 0');
  };

  it.each(['js', 'min.js'])('works with the engine of the same kind (.%s)', async (ending) => {
    const bundle = await load(ending);
    check(bundle.phys2D, bundle.validate);
  });

  it.each(UMD)('works in %s', (name) => {
    const phys2D = runAsScript(name).phys2D as Phys2D;
    check(phys2D, phys2D.validate);
  });

  it('refuses the world of another kind', async () => {
    const [full, short] = [await load('js'), await load('min.js')];
    expect(() => full.validate(short.phys2D.createWorld())).toThrow('validate: world must be a World of the same kind');
    expect(() => short.validate(full.phys2D.createWorld())).toThrow('validate: world must be a World of the same kind');
  });
});

describe('one simulation', () => {
  const expected = simulate(source.phys2D);

  it.each(ESM)('has the same bits with %s', async (name) => {
    expect(simulate((await importBundle(name)).phys2D)).toBe(expected);
  });

  it.each(UMD)('has the same bits with %s', (name) => {
    expect(simulate(runAsScript(name).phys2D as Phys2D)).toBe(expected);
  });
});

describe('size and maps', () => {
  it.each(Object.entries(GZIP_LIMITS))('%s is at most %d bytes gzipped', (name, limit) => {
    const size = gzipSync(read(name), { level: 9 }).length;
    console.log(`${name}: ${(size / 1000).toFixed(1)} kB gzipped`);
    expect(size).toBeLessThanOrEqual(limit);
  });

  // One sign beyond ASCII makes of the whole text one of twice the width, which takes longer to read and more memory.
  it.each(readdirSync(dist).filter((name) => /js$/.test(name)))(
    '%s is ASCII, and its only comments are for bundlers',
    (name) => {
      const text = read(name);
      expect([...text].filter((sign) => sign > '~')).toEqual([]);
      expect(text.replaceAll('/* @__PURE__ */', '').replaceAll('/*@__PURE__*/', '')).not.toContain('/*');
    },
  );

  it.each([...UMD, ...ESM])('%s has a source map that holds the sources', (name) => {
    const link = /\/\/# sourceMappingURL=(\S+)\s*$/.exec(read(name))?.[1];
    const map = JSON.parse(read(link!)) as { sources: string[]; sourcesContent: string[]; mappings: string };
    expect(map.sources).toContain('../src/world.ts');
    expect(map.sourcesContent[map.sources.indexOf('../src/world.ts')]).toContain('class World');
    expect(map.mappings.length).toBeGreaterThan(1000);
  });
});

describe('the type declarations', () => {
  const files = readdirSync(dist, { recursive: true, encoding: 'utf8' }).filter((name) => /\.d\.c?ts$/.test(name));

  it('cover the public names', () => {
    expect(files).toContain('index.d.ts');
    expect(read('world.d.ts')).toMatch(/\bstep\(deltaTime: number\): void/);
    for (const name of CLASSES) {
      const apart = Object.entries(APART).find(([, exported]) => name in exported && !(name in source));
      const module = apart?.[0] ?? 'names';
      expect(read('umd.d.cts'), name).toContain(`type ${name} = ${module}.${name};`);
    }
    const values = [...read('umd.d.cts').matchAll(/^ {2}const (\w+):/gm)].map(([, name]) => name);
    expect(values.sort()).toEqual([...Object.keys(names), 'vendor'].sort());
  });

  it('show nothing internal', () => {
    expect(files.filter((name) => read(name).includes('@internal'))).toEqual([]);
    expect(files.filter((name) => /^solver\b/.test(name))).toEqual([]);
    const modifiers = '(?:(?:readonly|static|abstract|get|set) )*';
    const marked = new RegExp(`@internal.*\\*\\/\\n\\s*${modifiers}(\\w+)[?:;( ]`, 'g');
    let checked = 0;
    for (const name of files.filter((name) => /declare (?:abstract )?class/.test(read(name)))) {
      const [, classes] = read(name).split(/^export declare (?:abstract )?class/m, 2);
      for (const [, member] of readFileSync(join(root, 'src', name.replace('.d.ts', '.ts')), 'utf8').matchAll(marked)) {
        expect(classes, name).not.toMatch(new RegExp(`^\\s+${modifiers}${member}[?:;(]`, 'm'));
        checked += 1;
      }
    }
    expect(checked).toBeGreaterThan(50);
  });
});

describe('the package, packed and installed', () => {
  const consumer = mkdtempSync(join(tmpdir(), 'phys2d-consumer-'));
  const home = join(consumer, 'node_modules/phys2d');

  const node = (file: string, code: string): string => {
    writeFileSync(join(consumer, file), code);
    return execFileSync(process.execPath, [join(consumer, file)], { encoding: 'utf8' }).trim();
  };

  beforeAll(() => {
    const options = { cwd: root, encoding: 'utf8', shell: process.platform === 'win32', stdio: 'pipe' } as const;
    const [packed] = JSON.parse(
      execFileSync('npm', ['pack', '--json', '--ignore-scripts', '--pack-destination', consumer], options),
    ) as [{ filename: string }];
    mkdirSync(home, { recursive: true });
    execFileSync('tar', ['-xzf', packed.filename, '--strip-components=1', '-C', 'node_modules/phys2d'], {
      cwd: consumer,
    });
  });

  afterAll(() => rmSync(consumer, { recursive: true, force: true }));

  it('has the bundles, types, licence and readme, and neither sources nor examples', () => {
    const files = readdirSync(home, { recursive: true, encoding: 'utf8' }).map((name) => name.replaceAll('\\', '/'));
    expect(files).toEqual(
      expect.arrayContaining([
        'README.md',
        'LICENSE',
        'package.json',
        ...[...UMD, ...ESM, ...Object.keys(GZIP_LIMITS), 'debug.js', 'outline.js', 'runner.js', 'state.js'].map(
          (name) => `dist/${name}`,
        ),
      ]),
    );
    expect(files.filter((name) => /^(src|test|examples|bench)\b|^dist\/examples/.test(name))).toEqual([]);
  });

  it('depends on nothing', () => {
    const manifest = JSON.parse(readFileSync(join(home, 'package.json'), 'utf8')) as Record<string, unknown>;
    expect(manifest.dependencies).toBeUndefined();
    expect(manifest.peerDependencies).toBeUndefined();
  });

  it('is imported by name', () => {
    const code = "import phys2D, { World } from 'phys2d'; console.log(phys2D.createWorld() instanceof World);";
    expect(node('main.mjs', code)).toBe('true');
  });

  it('is required by name', () => {
    const code = "const phys2D = require('phys2d'); console.log(phys2D.createWorld() instanceof phys2D.World);";
    expect(node('main.cjs', code)).toBe('true');
  });

  it('is imported and required in parts', () => {
    const use = `
const world = phys2D.createWorld();
FixedStepRunner.create({ world }).advance(1 / 60);
const graphicsDevice = SVGDebugDevice.create({ width: 10, height: 10 });
const debug = Physics2DDebugDraw.create({ graphicsDevice });
debug.begin();
debug.drawCircle(0, 0, 0.1, [1, 0, 0, 1]);
debug.drawWorld(world);
debug.end();
console.log(String(graphicsDevice).includes('<path'), world.timeStamp);`;
    const imports = `import { phys2D } from 'phys2d';
import { Physics2DDebugDraw, SVGDebugDevice } from 'phys2d/debug';
import { FixedStepRunner } from 'phys2d/runner';`;
    const requires = `const { phys2D } = require('phys2d');
const { Physics2DDebugDraw, SVGDebugDevice } = require('phys2d/debug');
const { FixedStepRunner } = require('phys2d/runner');`;
    expect(node('parts.mjs', imports + use)).toBe('true 1');
    expect(node('parts.cjs', requires + use)).toBe('true 1');
  });

  it('type-checks for users of import and of require', () => {
    const use = `
const world: World = phys2D.createWorld({ gravity: [0, 10], substeps: 2 });
const box: Polygon = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1, 1) });
const body: RigidBody = phys2D.createRigidBody({ shapes: [box], position: new Float32Array(2) });
const added: boolean = world.addRigidBody(body);
const place: [number, number] = body.getPosition();
const into: Float64Array = body.getPosition(new Float64Array(2));
const params: WorldParams = { velocityIterations: 4 };
// @ts-expect-error unknown option
phys2D.createWorld({ grvity: [0, 10] });
// @ts-expect-error internal member
world.stepping;
export const used = [added, place, into, params];
`;
    const names = 'Polygon, RigidBody, World, WorldParams';
    const aliases = names.split(', ').map((name) => `type ${name} = phys2D.${name};`);
    const files: Record<string, string> = {
      'import.mts': `import phys2D, { Physics2DDevice, type ${names.replaceAll(', ', ', type ')} } from 'phys2d';
${use}export const device: Physics2DDevice = new Physics2DDevice();`,
      'require.cts': `import phys2D = require('phys2d');\n${aliases.join('\n')}
${use.replace('export const used', 'const used')}const device = new phys2D.Physics2DDevice();
export = [used, device, phys2D.phys2D];`,
      'default.cts': `import phys2D, { type ${names.replaceAll(', ', ', type ')} } from 'phys2d';\n${use}`,
      'parts.mts': `import { phys2D } from 'phys2d';
import { CanvasDebugDevice, type DebugGraphicsDevice, type DebugLines, Physics2DDebugDraw } from 'phys2d/debug';
import { SVGDebugDevice, WebGLDebugDevice } from 'phys2d/debug';
import { FixedStepRunner } from 'phys2d/runner';
import { validate } from 'phys2d/validate';
validate(phys2D.createWorld());
declare const canvas: HTMLCanvasElement;
declare const offscreen: OffscreenCanvas;
CanvasDebugDevice.create({ context: offscreen.getContext('2d')!, lineWidth: 2 });
WebGLDebugDevice.create({ context: canvas.getContext('webgl2')! });
WebGLDebugDevice.create({ context: offscreen.getContext('webgl2')! });
// @ts-expect-error not a 2D context
CanvasDebugDevice.create({ context: canvas.getContext('webgl2')! });
// @ts-expect-error not a WebGL 2 context
WebGLDebugDevice.create({ context: canvas.getContext('2d')! });
class Recorder implements DebugGraphicsDevice {
  width = 1;
  height = 1;
  drawLines(lines: DebugLines): void {
    console.log(lines.segmentCount);
  }
}
const graphicsDevice = CanvasDebugDevice.create({ context: canvas.getContext('2d')! });
const debug: Physics2DDebugDraw = Physics2DDebugDraw.create({ graphicsDevice });
Physics2DDebugDraw.create({ graphicsDevice: new Recorder() }).showContacts = true;
debug.constraintColorA = [0, 0, 0, 1];
// @ts-expect-error read-only
debug.physics2DToScreen = 1;
// @ts-expect-error internal member
debug.lines;
const runner = FixedStepRunner.create({ world: phys2D.createWorld() });
debug.interpolation = runner.interpolation;
phys2D.createCustomConstraint({
  dimension: 1,
  bodies: [phys2D.createRigidBody()],
  jacobian() {},
  debugDraw(debug, stiff) {
    debug.drawLine(0, 0, stiff ? 1 : 2, this.dimension, [1, 1, 1, 1]);
    // @ts-expect-error no such method
    debug.drawLines();
  },
});
export const text: string = SVGDebugDevice.create({ width: 1, height: 1 }).toString();`,
      'parts.cts': `import { Physics2DDebugDraw, SVGDebugDevice } from 'phys2d/debug';
import { FixedStepRunner } from 'phys2d/runner';
import phys2D = require('phys2d');
const graphicsDevice: SVGDebugDevice = SVGDebugDevice.create({ width: 1, height: 1 });
const debug: phys2D.Physics2DDebugDraw = Physics2DDebugDraw.create({ graphicsDevice });
const same: phys2D.Physics2DDebugDraw = phys2D.Physics2DDebugDraw.create({ graphicsDevice });
const device: phys2D.Physics2DDevice = phys2D;
export const used = [debug, same, device, FixedStepRunner.create({ world: phys2D.createWorld() })];`,
      'script.ts': 'const world: phys2D.World = phys2D.createWorld();\nworld.step(1 / 60);\n',
    };
    for (const [name, code] of Object.entries(files)) {
      writeFileSync(join(consumer, name), code);
    }
    const tsc = (...args: string[]): string => {
      const options = '--noEmit --strict --target es2022 --lib es2022 --esModuleInterop --ignoreConfig'.split(' ');
      try {
        const command = [join(root, 'node_modules/typescript/bin/tsc'), ...options, ...args];
        return execFileSync(process.execPath, command, { cwd: consumer, encoding: 'utf8' });
      } catch (error) {
        return (error as { stdout: string }).stdout;
      }
    };
    expect(tsc('--module', 'nodenext', 'import.mts', 'require.cts', 'default.cts')).toBe('');
    expect(tsc('--module', 'esnext', '--moduleResolution', 'bundler', 'import.mts')).toBe('');
    expect(tsc('--module', 'nodenext', 'parts.cts')).toBe('');
    expect(tsc('--module', 'nodenext', '--lib', 'es2022,dom', 'parts.mts')).toBe('');
    expect(
      tsc('--module', 'nodenext', '--moduleDetection', 'legacy', 'script.ts', 'node_modules/phys2d/dist/umd.d.cts'),
    ).toBe('');
  });
});
