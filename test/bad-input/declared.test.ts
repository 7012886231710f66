import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import * as audit from '../../src/audit/index.js';
import * as debug from '../../src/debug/index.js';
import * as engine from '../../src/index.js';
import { phys2D, simdKernels } from '../../src/index.js';
import * as outline from '../../src/outline/index.js';
import * as runner from '../../src/runner.js';
import * as state from '../../src/state/index.js';
import { type Callable, Declarations, type Parameter } from './declarations.js';

// Every parameter of every public function, and every option, as the published types declare them, is given what is no number, of no measure, and of the
// wrong kind. Each is refused with a message that names it, before anything changes, or is legal as documented.

const declared = new Declarations(join(import.meta.dirname, '../../dist'));
const modules: Readonly<Record<string, unknown>> = { ...engine, ...debug, ...outline, ...runner, ...state, ...audit };

/** A world that has everything, and one object of each class. */
function makeStage() {
  const world = phys2D.createWorld();
  const circle = phys2D.createCircleShape({ radius: 0.5 });
  const polygon = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1, 1) });
  const floor = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(9, 1) });
  const one = phys2D.createRigidBody({ shapes: [circle], position: [0, -0.95] });
  const two = phys2D.createRigidBody({ shapes: [polygon], position: [2, -0.99] });
  const base = phys2D.createRigidBody({ type: 'static', shapes: [floor] });
  const bodies = { bodyA: one, bodyB: two };
  const constraints = {
    PointConstraint: phys2D.createPointConstraint(bodies),
    WeldConstraint: phys2D.createWeldConstraint(bodies),
    AngleConstraint: phys2D.createAngleConstraint({ ...bodies, lowerBound: 0, upperBound: 9 }),
    DistanceConstraint: phys2D.createDistanceConstraint({ ...bodies, lowerBound: 0, upperBound: 9 }),
    LineConstraint: phys2D.createLineConstraint({ ...bodies, axis: [1, 0], lowerBound: 0, upperBound: 9 }),
    MotorConstraint: phys2D.createMotorConstraint(bodies),
    PulleyConstraint: phys2D.createPulleyConstraint({
      ...bodies,
      bodyC: one,
      bodyD: base,
      lowerBound: 0,
      upperBound: 9,
    }),
    CustomConstraint: phys2D.createCustomConstraint({ dimension: 1, bodies: [one], jacobian: () => undefined }),
  };
  for (const body of [one, two, base]) {
    world.addRigidBody(body);
  }
  for (const constraint of Object.values(constraints)) {
    world.addConstraint(constraint);
  }
  let hit: engine.Hit | null = null;
  circle.addEventListener('hit', (_arbiter, _other, given) => {
    hit = given;
  });
  world.step(1 / 60);
  const device = debug.SVGDebugDevice.create({ width: 9, height: 9 });
  const draw = debug.Physics2DDebugDraw.create({ graphicsDevice: device });
  draw.begin();
  const boxes = phys2D.createBoxTreeBroadphase();
  const intervals = phys2D.createSweepAndPruneBroadphase();
  const tree = engine.BoxTree.create<engine.BoxTreeExternalNode>(true);
  const node: engine.BoxTreeExternalNode = { boxTreeIndex: undefined };
  tree.add(node, [0, 0, 1, 1]);
  const handles = {
    BoxTreeBroadphase: boxes.insert(null, [0, 0, 1, 1], false),
    SweepAndPrune: intervals.insert(null, [0, 0, 1, 1], false),
  };
  const subjects: Readonly<Record<string, object>> = {
    World: world,
    RigidBody: one,
    Circle: circle,
    Polygon: polygon,
    ...constraints,
    Arbiter: world.staticArbiters[0]!,
    Contact: world.staticArbiters[0]!.contacts[0]!,
    Hit: hit!,
    CollisionUtils: phys2D.createCollisionUtils(),
    Physics2DDevice: phys2D,
    BoxTreeBroadphase: boxes,
    SweepAndPrune: intervals,
    BoxTree: tree,
    Physics2DDebugDraw: draw,
    SVGDebugDevice: device,
    FixedStepRunner: runner.FixedStepRunner.create({ world, deltaTime: 1 / 60 }),
    PoseBuffer: state.PoseBuffer.create({ capacity: 4 }),
    Recorder: state.Recorder.create(world),
  };
  return { world, subjects, circle, polygon, one, two, base, boxes, tree, node, device, handles };
}

type Stage = ReturnType<typeof makeStage>;

/** What is taken all the same, and where that is documented. */
const LEGAL: readonly (readonly [string, RegExp])[] = [
  ['documented: legal infinities', /\.(?:mass|inertia|maxForce|maxError|upperBound) = Infinity$/],
  ['documented: legal infinities', /\.lowerBound = -Infinity$/],
  ['Material, Arbiter: always, or never, bounces', /[.]elasticity = -?Infinity$/],
  ['World.shapeCircleQuery: everything', /CircleQuery\.radius = Infinity$/],
  ['BoxTree: everything', /^BoxTree\.getCircleOverlappingNodes\.radius = Infinity$/],
  ['World.clock, World.poses: none', /^World\.(?:clock|poses)\.value = null$/],
  ['no listener of that type: false', /EventListener\.eventType = /],
  ['Physics2DDebugDraw: all there is', /Viewport\.rectangle = (?:null|undefined)$/],
  ['a getter without a destination makes an array', /\.dst = undefined$/],
  ['Broadphase: any data', /\.insert\.data = /],
  ['PoseBuffer: not tracked', /^PoseBuffer\.(?:untrack|indexOf)\.body = /],
];

const NOT_NUMBERS = ['1', null, {}, true, 1n];
const BAD_NUMBERS = [NaN, Infinity, -Infinity, ...NOT_NUMBERS];
const NO_LIST = [null, 5, 'text', true];
const NO_VECTOR = [...NO_LIST, {}, [1], [NaN, 1], [1, Infinity], [-Infinity, 1], ['1', 2]];
const NO_RECTANGLE = [...NO_LIST, {}, [1, 2, 3], [NaN, 0, 1, 1], [0, 0, 1, '1']];
const NO_OBJECT = [null, 5, 'text', true];
const NO_CALLBACK = [null, 5, 'text', {}];

/** A value that a parameter takes, and some that it must not. */
function valuesOf(stage: Stage, type: string, owner: string): { good: unknown; bad: readonly unknown[] } | null {
  const { world, circle, one, two, boxes, tree, node, handles, device } = stage;
  const strings = /^'(\w+)'(?: \| '\w+')*$/.exec(type);
  if (strings !== null) {
    return { good: strings[1], bad: ['text', 5, null, {}] };
  }
  if (/=>|Handler$|^Clock|^CustomCallback$|^(?:Shape|World)Events/.test(type)) {
    return { good: () => undefined, bad: NO_CALLBACK };
  }
  if (type.startsWith('ArrayLike<Vec2Like>')) {
    const corners = (last: unknown) => [[0, 0], [1, 0], last];
    return { good: corners([0, 1]), bad: [...NO_LIST, {}, [], ...NO_VECTOR.map(corners)] };
  }
  if (type.startsWith('ArrayLike<ArrayLike<Vec2Like>>')) {
    return { good: [], bad: [...NO_LIST, {}, [5], [[]], [[[0, 0]]]] };
  }
  const listed = /^(?:readonly |ArrayLike<|Iterable<)(RigidBody|Shape|BoxTree<N>|Vec3Like)/.exec(type)?.[1];
  if (listed !== undefined) {
    const things = {
      RigidBody: one,
      Shape: phys2D.createCircleShape({ radius: 1 }),
      'BoxTree<N>': tree,
      Vec3Like: [1, 0, 0],
    };
    return { good: [things[listed as keyof typeof things]], bad: [...NO_LIST, [null], [5], [{}], [world]] };
  }
  if (/^[A-Z]\w*\[\]$/.test(type)) {
    return { good: [], bad: NO_LIST };
  }
  const kinds: Readonly<Record<string, { good: unknown; bad: readonly unknown[] }>> = {
    number: { good: 1, bad: BAD_NUMBERS },
    boolean: { good: true, bad: [1, 'true', null, NaN, {}] },
    Vec2Like: { good: [1, 0.5], bad: NO_VECTOR },
    Matrix23Like: { good: [1, 0, 0, 1, 0, 0], bad: [...NO_VECTOR, [1, 0, 0, 1, 0, NaN]] },
    RectLike: { good: [0, 0, 1, 1], bad: NO_RECTANGLE },
    'RectLike | null': { good: [0, 0, 1, 1], bad: [5, 'text', [1, 2, 3], [NaN, 0, 1, 1]] },
    ColorLike: { good: [1, 1, 1, 1], bad: [...NO_LIST, [1, 1, 1], [NaN, 1, 1, 1], [1, 1, 1, '1']] },
    NumberSink: { good: [], bad: NO_LIST },
    T: { BoxTree: { good: node, bad: NO_OBJECT }, Recorder: { good: world, bad: [...NO_OBJECT, {}] } }[owner] ?? {
      good: [],
      bad: NO_LIST,
    },
    'K & string': { good: 'getGravity', bad: ['text', 5, null, {}] },
    'Float32Array | Float64Array': { good: new Float64Array(40), bad: [...NO_OBJECT, {}, [1]] },
    string: { good: 'text', bad: [null, 5, {}, true] },
    'string | string[]': { good: 'text', bad: [] },
    BodyType: { good: 'dynamic', bad: ['text', 5, null, {}] },
    Ray: {
      good: { origin: [0, 0], direction: [1, 0], maxFactor: 1 },
      bad: [
        ...NO_OBJECT,
        {},
        ...NO_VECTOR.map((origin) => ({ origin, direction: [1, 0], maxFactor: 1 })),
        ...NO_VECTOR.map((direction) => ({ origin: [0, 0], direction, maxFactor: 1 })),
        ...[NaN, -1, ...NOT_NUMBERS].map((maxFactor) => ({ origin: [0, 0], direction: [1, 0], maxFactor })),
      ],
    },
    RigidBody: { good: two, bad: [...NO_OBJECT, {}, circle] },
    Shape: { good: circle, bad: [...NO_OBJECT, {}, one] },
    Constraint: { good: world.constraints[0], bad: [...NO_OBJECT, {}, one] },
    Material: { good: phys2D.getDefaultMaterial(), bad: [...NO_OBJECT, {}, one] },
    World: { good: world, bad: [...NO_OBJECT, {}, one] },
    ArrayBuffer: { good: world.snapshot(), bad: [...NO_OBJECT, {}, new Uint8Array(9)] },
    'ArrayBuffer | ArrayBufferView': { good: world.snapshot(), bad: [...NO_OBJECT, {}] },
    'BroadphaseHandle<T>': { good: handles[owner as keyof typeof handles], bad: [...NO_OBJECT, {}] },
    Broadphase: { good: boxes, bad: [...NO_OBJECT, {}] },
    DebugGraphicsDevice: { good: device, bad: [...NO_OBJECT, {}] },
    Kernels: { good: simdKernels, bad: [...NO_OBJECT, {}] },
    PoseUpdate: { good: state.PoseBuffer.create({ capacity: 1 }), bad: [...NO_OBJECT, {}, { update: 5 }] },
    Float64Array: { good: new Float64Array(1), bad: [...NO_OBJECT, {}, [1]] },
    Physics2DDevice: { good: phys2D, bad: [...NO_OBJECT, {}] },
    PlainWorld: { good: state.serialize(phys2D.createWorld()), bad: [...NO_OBJECT, {}] },
    "T extends 'hit' ? number : T extends 'preSolve' ? boolean : undefined": { good: undefined, bad: [] },
    'T[K] extends Overloads<infer A, infer B, unknown, unknown> ? A | B : never': { good: undefined, bad: [] },
    'World | Recorder': { good: world, bad: [...NO_OBJECT, {}, one] },
    'World | RigidBody': { good: world, bad: [...NO_OBJECT, {}, one] },
    RecordedSetting: { good: 'substeps', bad: ['text', 'step', 5, null, {}] },
    'number | boolean': { good: 2, bad: [...BAD_NUMBERS, 0, 1.5] },
    Recording: { good: state.Recorder.create(world).recording, bad: [...NO_OBJECT, {}] },
  };
  if (type.endsWith('EventType')) {
    return { good: 'begin', bad: ['text', 5, null, {}] };
  }
  const found = kinds[type] ?? kinds[type.replace(/ \| null$/, '')];
  if (found === undefined && declared.options.has(type)) {
    const good = Object.fromEntries(
      optionsOf(type)
        .filter(({ optional }) => !optional)
        .map(({ name, type: each }) => [name, valuesOf(stage, each, owner)?.good]),
    );
    return { good, bad: [...NO_OBJECT, [1, 2]] };
  }
  return found ?? null;
}

function optionsOf(type: string): Parameter[] {
  return declared.line(type).flatMap((name) => declared.options.get(name) ?? []);
}

/** Takes anything: user data, what is `this` in callbacks, what callbacks are given back. */
const isFree = ({ type }: Parameter): boolean => type === 'unknown' || type.startsWith('UserDataOf<');

interface Attempt {
  /** Such as `World.step.deltaTime = NaN`. */
  readonly label: string;
  /** What the message has to name. */
  readonly name: string;
  readonly args: (stage: Stage) => unknown[];
}

function show(value: unknown): string {
  if (Array.isArray(value)) {
    return `[${value.map(show).join(', ')}]`;
  }
  if (typeof value !== 'object' || value === null) {
    return typeof value === 'bigint' ? `${value}n` : typeof value === 'string' ? `'${value}'` : String(value);
  }
  if (Object.getPrototypeOf(value) !== Object.prototype) {
    return value.constructor.name;
  }
  const parts = Object.entries(value).map(([name, part]) => `${name}: ${show(part)}`);
  return `{ ${parts.join(', ')} }`;
}

/** The arguments of a call, all of them good. */
const goodArgs = (stage: Stage, { parameters }: Callable, owner: string): unknown[] =>
  parameters.map((each) => (isFree(each) ? undefined : valuesOf(stage, each.type, owner)!.good));

function attemptsOf(callable: Callable, owner: string): Attempt[] {
  const probe = makeStage();
  const { parameters, kind } = callable;
  const where = [owner, callable.name].filter((part) => part !== '').join('.');
  return parameters.flatMap((each, at) => {
    if (isFree(each)) {
      return [];
    }
    const put = (value: (stage: Stage, good: unknown) => unknown) => (stage: Stage) => {
      const args = goodArgs(stage, callable, owner);
      args[at] = value(stage, args[at]);
      return args;
    };
    const { bad } = valuesOf(probe, each.type, owner)!;
    const name = kind === 'setter' ? callable.name : each.name;
    const attempts: Attempt[] = bad.map((value, k) => ({
      label: `${where}.${each.name} = ${show(value)}`,
      name,
      args: put((stage) => valuesOf(stage, each.type, owner)!.bad[k]),
    }));
    if (!each.optional && kind !== 'setter') {
      attempts.push({ label: `${where}.${each.name} = undefined`, name, args: put(() => undefined) });
    }
    const options = /Params$|Config$|Options$/.test(each.type)
      ? optionsOf(each.type).filter((one) => !isFree(one))
      : [];
    for (const option of options) {
      valuesOf(probe, option.type, owner)!.bad.forEach((value, k) => {
        attempts.push({
          label: `${where}.${each.name}.${option.name} = ${show(value)}`,
          name: option.name,
          args: put((stage, good) => ({
            ...(good as object),
            [option.name]: valuesOf(stage, option.type, owner)!.bad[k],
          })),
        });
      });
    }
    return attempts;
  });
}

function call(stage: Stage, { kind, name }: Callable, owner: string, args: unknown[]): void {
  const of = (kind === 'function' ? modules : kind === 'static' ? modules[owner] : stage.subjects[owner]) as never;
  if (kind === 'setter') {
    (of as Record<string, unknown>)[name] = args[0];
  } else {
    (of as Record<string, (...args: unknown[]) => unknown>)[name]!(...args);
  }
}

/** What is wrong with how an attempt ends, or `null`. */
function complaint(stage: Stage, callable: Callable, owner: string, { label, name, args }: Attempt): string | null {
  const given = args(stage);
  const before = stage.world.hash();
  try {
    call(stage, callable, owner, given);
  } catch (error) {
    if (stage.world.hash() !== before) {
      return `${label}: the world has changed`;
    }
    const isRight = error instanceof TypeError || error instanceof RangeError;
    const { message } = error as Error;
    return isRight && message.includes(name) && message.includes(': ') ? null : `${label}: ${message}`;
  }
  return LEGAL.some(([, legal]) => legal.test(label)) ? null : `${label}: is taken`;
}

/** Called by the engine alone, and documented to check nothing; or in need of a canvas, which the tests of the debug drawing have. */
const LEFT_OUT = /^BoxTreeBroadphase\.(?:cast|sampleStatic)$|^(?:Canvas|WebGL)DebugDevice\.|DebugDevice\.drawLines$/;

/** All classes; functions as ''. */
const owners = ['', ...Object.keys(modules).filter((name) => /^[A-Z]/.test(name))];

function callablesOf(owner: string): Callable[] {
  const line = owner === '' ? [''] : declared.line(owner);
  return declared.callables.filter(({ owner: at, name, kind }) => {
    const isThere = kind === 'function' ? name in modules : kind === 'static' || owner in subjects;
    return line.includes(at) && isThere && !LEFT_OUT.test(`${owner}.${name}`);
  });
}

const { subjects } = makeStage();

describe.each(owners.filter((owner) => callablesOf(owner).length > 0))('%s', (owner) => {
  it.each(callablesOf(owner).map((callable) => [callable.name, callable] as const))('%s', (_, callable) => {
    let stage = makeStage();
    const complaints = attemptsOf(callable, owner).flatMap((attempt) => {
      const wrong = complaint(stage, callable, owner, attempt);
      stage = makeStage();
      return wrong ?? [];
    });
    expect(complaints).toEqual([]);
  });
});

it('nothing is left out', () => {
  const covered = Object.keys(subjects).flatMap((owner) => declared.line(owner));
  const left = declared.callables.filter(
    ({ owner, name, kind }) =>
      owner in modules && kind !== 'static' && !covered.includes(owner) && !LEFT_OUT.test(`${owner}.${name}`),
  );
  expect(left).toEqual([]);
});

it('what may be set is checked, but user data', () => {
  // What the engine writes for others to read; settings of the debug drawing, which look plain to the compiler alone.
  const free = /^(?:PairState|Profile|BoxTreeNode|DebugSettings)\.|\.userData$/;
  expect(declared.plain.filter((name) => !free.test(name))).toEqual([]);
  expect(declared.plain).toContain('BodyState.userData');
});
