// One measurement in a process of its own: node child.mjs '{"task":"pyramid","engine":"phys2d"}' prints one line of JSON.
import { Session } from 'node:inspector/promises';
import { buildChains, buildJointGrid, buildPyramid, stateHash, worstGap } from '../dist/bench/scenes.js';
import { phys2D } from '../dist/phys2d.js';
import { casters } from './casters.mjs';
import { createField } from './casts-scene.mjs';

const DT = 1 / 60;

const engines = {
  phys2d: () => phys2D,
  planck: async () => (await import('./planck.mjs')).planck,
  'planck, discrete': async () => (await import('./planck.mjs')).planckDiscrete,
};

const tasks = { pyramid, chains, grid, crowd, events, continuous, rays, casts, garbage, hash };
const { task, ...params } = JSON.parse(process.argv[2]);
console.log(JSON.stringify(await tasks[task](params)));

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

/** An awake pyramid: the time of its steps, and how far the box that sank most has sunk. */
async function pyramid({ engine, base, warmUp, steps }) {
  const device = await engines[engine]();
  const world = device.createWorld({ allowSleeping: false, velocityIterations: 8 });
  const boxes = buildPyramid(device, world, base);
  const before = boxes.map((body) => body.getPosition()[1]);
  const step = () => world.step(DT);
  repeat(warmUp, step);
  const times = time(steps, step);
  const sags = boxes.map((body, i) => body.getPosition()[1] - before[i]);
  return { times, sag: Math.max(...sags) };
}

/** Chains that swing, or a net that hangs: the time of a step, and the widest gap of a joint. */
async function jointed({ engine, warmUp, steps }, build) {
  const device = await engines[engine]();
  const world = device.createWorld({ allowSleeping: false, velocityIterations: 8 });
  const { joints } = build(device, world);
  const step = () => world.step(DT);
  repeat(warmUp, step);
  const times = time(steps, step);
  let gap = 0;
  repeat(60, () => {
    step();
    gap = Math.max(gap, worstGap(joints));
  });
  return { times, gap };
}

function chains({ count, links, ...job }) {
  return jointed(job, (device, world) => buildChains(device, world, count, links));
}

function grid({ size, ...job }) {
  return jointed(job, (device, world) => buildJointGrid(device, world, size));
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

/** Rays through a field of bodies: the time of all of them, how many hit, and the sum of their factors. */
async function rays({ engine, warmUp, steps, ...counts }) {
  const { bodies, rays } = createField(counts);
  const caster = await casters[engine](bodies);
  return castAll(rays.map(caster.ray), warmUp, steps);
}

/** The same for boxes. */
async function casts({ engine, warmUp, steps, ...counts }) {
  const { bodies, casts } = createField(counts);
  const caster = await casters[engine](bodies);
  return castAll(casts.map(caster.box), warmUp, steps);
}

function castAll(prepared, warmUp, steps) {
  let hits = 0;
  let factors = 0;
  const step = () => {
    hits = 0;
    factors = 0;
    for (const cast of prepared) {
      const factor = cast();
      if (factor >= 0) {
        hits += 1;
        factors += factor;
      }
    }
  };
  repeat(warmUp, step);
  return { times: time(steps, step), hits, factors };
}

/**
 * Bytes allocated per step. A run begins with a clean heap; it is cut into parts that are too short for a collection of their
 * own, where an engine allocates so much that this is needed.
 */
async function garbage({ engine, base, listening, warmUp, steps }) {
  const ROOM = 32e6;
  const device = await engines[engine]();
  const world = device.createWorld({ allowSleeping: false });
  buildPyramid(device, world, base);
  if (listening) {
    listen(world);
  }
  const step = () => world.step(DT);
  const growth = (count) => {
    globalThis.gc();
    const before = process.memoryUsage().heapUsed;
    repeat(count, step);
    return process.memoryUsage().heapUsed - before;
  };
  repeat(warmUp, step);
  const part = Math.min(steps, Math.ceil((ROOM * 50) / Math.max(1, growth(50))));
  let bytes = 0;
  for (let done = 0; done < steps; done += part) {
    bytes += growth(Math.min(part, steps - done));
  }
  return { bytesPerStep: bytes / steps };
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
