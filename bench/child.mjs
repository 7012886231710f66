// One measurement in a process of its own: node child.mjs '{"task":"speed","engine":"phys2d","scene":"pyramid","seconds":3}' prints one
// line of JSON at the end.
import { writeSync } from 'node:fs';
import { Session } from 'node:inspector/promises';
import { getHeapStatistics } from 'node:v8';
import { buildPyramid, scenes as built, DT, pyramidsOf, stateHash } from '../dist/bench/scenes.js';
import { phys2D } from '../dist/phys2d.js';
import { casts, rays } from './casts-scene.mjs';
import { engines } from './engines.mjs';

const scenes = { ...built, rays, casts };
const tasks = { speed, crowd, events, continuous, garbage, memory, hash, snapshot };
const { task, ...params } = JSON.parse(process.argv[2]);
// At once, as Box2D's threads would keep the process.
writeSync(1, `\n${JSON.stringify(await tasks[task](params))}\n`);
process.exit(0);

/** Milliseconds of each of `steps` steps. */
function time(steps, step) {
  const times = new Float64Array(steps);
  for (let i = 0; i < steps; i += 1) {
    const start = performance.now();
    step();
    times[i] = performance.now() - start;
  }
  return [...times];
}

function repeat(count, action) {
  for (let i = 0; i < count; i += 1) {
    action();
  }
}

/** As often, but no longer than so many seconds. */
function repeatFor(seconds, count, action) {
  const end = performance.now() + 1000 * seconds;
  for (let i = 0; i < count && performance.now() < end; i += 1) {
    action();
  }
}

/** One by its name, or a pyramid of any base. */
function sceneOf(name, base) {
  return name === undefined ? pyramidsOf(base, 1) : scenes[name];
}

/**
 * A scene with an engine: milliseconds of its steps, and its quality after them. The warm-up and the
 * measurement end after so many seconds each, where steps are much alike, and else after `most`; but not before five steps.
 */
async function speed({ engine, scene, base, seconds, most = Number.POSITIVE_INFINITY }) {
  const device = await engines[engine].load();
  const { warmUp, steps, steady, start } = sceneOf(scene, base);
  const run = start(device);
  if (run === null) {
    return { unsupported: true };
  }
  const limit = 1000 * (steady ? seconds : most);
  const warm = timeRun(run, 0, warmUp, limit).length;
  const times = timeRun(run, warm, steps, limit);
  const isCut = warm < warmUp || times.length < steps;
  return {
    times,
    isCut,
    quality: run.quality(),
    factors: run.factors?.(),
    profile: device.isPeer ? undefined : profileOf(run, warm + times.length),
  };
}

/** Where the time of a step goes, in phys2d's own words: of each number the median of some more steps, so that a pause of the machine in one of them has no say. */
function profileOf({ world, before }, done) {
  const STEPS = 21;
  world.clock = () => performance.now();
  const values = {};
  for (let i = 0; i < STEPS; i += 1) {
    before?.(done + i);
    world.step(DT);
    for (const [name, value] of Object.entries(world.profile)) {
      values[name] ??= [];
      values[name].push(value);
    }
  }
  const medians = Object.entries(values).map(([name, list]) => [name, list.sort((a, b) => a - b)[STEPS >> 1]]);
  return Object.fromEntries(medians.filter(([name]) => name !== 'last' && name !== 'clock'));
}

/** Milliseconds of each of `steps` steps of a scene, or of fewer if they take longer than `limit` together. */
function timeRun({ world, act = () => world.step(DT), before = () => {} }, first, steps, limit) {
  const times = [];
  let sum = 0;
  for (let i = 0; i < steps && (i < 5 || sum < limit); i += 1) {
    before(first + i);
    const start = performance.now();
    act();
    times.push(performance.now() - start);
    sum += times[i];
  }
  return times;
}

/** Ten stacks of five boxes that are kept awake, alone or amid static and sleeping boxes. */
function crowd({ idle, warmUp, steps }) {
  const world = phys2D.createWorld();
  const box = (params) => {
    const shapes = [phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1, 1) })];
    const body = phys2D.createRigidBody({ ...params, shapes });
    world.addRigidBody(body);
    return body;
  };
  const awake = [];
  for (let stack = 0; stack < 10; stack += 1) {
    box({ type: 'static', position: [3 * stack, 0.5] });
    for (let level = 0; level < 5; level += 1) {
      awake.push(box({ position: [3 * stack, -0.5 - level] }));
    }
  }
  for (let i = 0; i < idle / 2; i += 1) {
    const x = 3 * (i % 100) - 135;
    const y = 10 * (1 + Math.floor(i / 100));
    box({ type: 'static', position: [x, y + 0.5] });
    box({ sleeping: true, position: [x, y - 0.5] });
  }
  const step = () => {
    for (const body of awake) {
      body.wake();
    }
    world.step(DT);
  };
  repeat(warmUp, step);
  return { times: time(steps, step), awake: world.liveDynamics.length, bodies: world.rigidBodies.length };
}

/** Puts a handler for `progress` on every shape. @returns how many calls there were so far, and how many pairs touch. */
function listen(world) {
  const heard = { calls: 0, pairs: () => world.dynamicArbiters.length + world.staticArbiters.length };
  for (const { shapes } of world.rigidBodies) {
    for (const shape of shapes) {
      shape.addEventListener('progress', (arbiter, other) => {
        heard.calls += arbiter.active && other !== shape ? 1 : 0;
      });
    }
  }
  return heard;
}

/** The pyramid with a handler for `progress` on every shape, or none. */
function events({ base, listening, warmUp, steps }) {
  const world = phys2D.createWorld({ allowSleeping: false });
  buildPyramid(phys2D, world, base);
  const heard = listening ? listen(world) : { calls: 0, pairs: () => 0 };
  const step = () => world.step(DT);
  repeat(warmUp, step);
  heard.calls = 0;
  const times = time(steps, step);
  return { times, pairs: heard.pairs(), callsPerStep: heard.calls / steps };
}

/** The share of a step that continuous collision takes where nothing is fast, by the sampling profiler. */
async function continuous({ base, warmUp, steps }) {
  const world = phys2D.createWorld({ allowSleeping: false });
  buildPyramid(phys2D, world, base);
  const step = () => world.step(DT);
  repeat(warmUp, step);
  const session = new Session();
  session.connect();
  await session.post('Profiler.enable');
  await session.post('Profiler.setSamplingInterval', { interval: 100 });
  await session.post('Profiler.start');
  repeat(steps, step);
  const { profile } = await session.post('Profiler.stop');
  const nodes = new Map(profile.nodes.map((node) => [node.id, node]));
  const sum = (ids = [], count) => ids.reduce((total, id) => total + count(nodes.get(id)), 0);
  const samples = (node) => node.hitCount + sum(node.children, samples);
  const within = (names) => (node) =>
    node.callFrame.url.endsWith('phys2d.js') && names.includes(node.callFrame.functionName)
      ? samples(node)
      : sum(node.children, within(names));
  const [root] = profile.nodes;
  return { share: within(['foresee', 'continuous'])(root) / within(['step'])(root) };
}

/** Bytes allocated per warm step of a scene, or of a pyramid with or without handlers. */
async function garbage({ engine, scene, base, listening, warmUp, seconds, steps }) {
  const device = await engines[engine].load();
  const { world, act = () => world.step(DT), before = () => {} } = sceneOf(scene, base).start(device);
  if (listening) {
    listen(world);
  }
  let index = 0;
  const step = () => {
    before(index);
    act();
    index += 1;
  };
  return growthOf(step, warmUp, seconds, steps);
}

/**
 * How much the heap grows in a step, in the mean of those in which nothing was collected, after `warmUp` steps and so many seconds. No collection is
 * forced, as it drops compiled code. The heap is read in the warm-up too, so that all is compiled; what reading allocates itself is taken off.
 */
function growthOf(step, warmUp, seconds, steps) {
  const used = () => getHeapStatistics().used_heap_size;
  const growth = (action) => {
    const before = used();
    action();
    return used() - before;
  };
  const nothing = () => {};
  const end = performance.now() + 1000 * seconds;
  for (let i = 0; i < warmUp || performance.now() < end; i += 1) {
    growth(step);
    growth(nothing);
  }
  const own = Array.from({ length: 999 }, () => growth(nothing)).sort((a, b) => a - b)[499];
  const counted = [];
  repeatFor(seconds, steps, () => {
    const bytes = growth(step);
    if (bytes > 0) {
      counted.push(bytes - own);
    }
  });
  return { bytesPerStep: counted.reduce((sum, bytes) => sum + bytes, 0) / counted.length, steps: counted.length };
}

/** Bytes of the heap and of typed arrays, per body, of bodies with one box each that sleep. */
async function memory({ engine, count }) {
  const device = await engines[engine].load();
  const used = () => {
    // The second one waits until what the first one found is freed.
    globalThis.gc();
    globalThis.gc();
    const { heapUsed, arrayBuffers } = process.memoryUsage();
    return heapUsed + arrayBuffers;
  };
  const world = device.createWorld();
  const box = (i) => {
    const shapes = [device.createPolygonShape({ vertices: device.createBoxVertices(1, 1) })];
    const position = [2 * (i % 100), 2 * Math.floor(i / 100)];
    const body = device.createRigidBody({ shapes, position, sleeping: true });
    world.addRigidBody(body);
  };
  // So that what is made once, as pools and lists of a few, does not count.
  for (let i = 0; i < 100; i += 1) {
    box(i);
  }
  world.step(DT);
  const before = used();
  for (let i = 0; i < count; i += 1) {
    box(100 + i);
  }
  world.step(DT);
  world.step(DT);
  const bytes = used() - before;
  return { bytesPerBody: bytes / count, awake: world.rigidBodies.filter((body) => !body.sleeping).length };
}

/** State hashes of one scene: with either broadphase, and in a second world while another one is stepped in between. */
function hash({ base, steps }) {
  const run = (broadphase, between = () => {}) => {
    const world = phys2D.createWorld({ allowSleeping: false, broadphase });
    buildPyramid(phys2D, world, base);
    repeat(steps, () => {
      world.step(DT);
      between();
    });
    return stateHash(world);
  };
  const other = phys2D.createWorld({ gravity: [1, 9], substeps: 2 });
  buildPyramid(phys2D, other, 7);
  return {
    boxTree: run(phys2D.createBoxTreeBroadphase()),
    sweepAndPrune: run(phys2D.createSweepAndPruneBroadphase()),
    secondWorld: run(undefined, () => other.step(DT)),
  };
}

/**
 * 1,000 boxes in a pile, awake: milliseconds to take a snapshot, and to restore it after four more steps, and its bytes. An engine that cannot restore in
 * place makes a new world, and drops the old one.
 */
async function snapshot({ engine, warmUp, times }) {
  const device = await engines[engine].load();
  const world = device.createWorld({ allowSleeping: false });
  const box = (width, height, params) => {
    const shapes = [device.createPolygonShape({ vertices: device.createBoxVertices(width, height) })];
    world.addRigidBody(device.createRigidBody({ ...params, shapes }));
  };
  box(100, 1, { type: 'static', position: [0, 0.5] });
  for (let i = 0; i < 1000; i += 1) {
    box(1, 1, { position: [1.02 * (i % 40) - 20, -0.5 - 1.01 * Math.floor(i / 40)] });
  }
  repeat(120, () => world.step(DT));
  let taken;
  const run = (count) => {
    const take = [];
    const restore = [];
    repeat(count, () => {
      take.push(
        ...time(1, () => {
          taken = world.snapshot(taken);
        }),
      );
      repeat(4, () => world.step(DT));
      restore.push(...time(1, () => world.restore(taken)));
      world.step(DT);
    });
    return { take, restore };
  };
  run(warmUp);
  return { ...run(times), bytes: world.snapshot().byteLength };
}
