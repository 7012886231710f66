// npm run soak -- --minutes 60: simulated time with much coming and going. Bodies and joints are made, broken and removed, worlds are made and
// dropped. Prints the heap after collections, the sizes of pools, and the step time of each quarter; the exit code is 1 if the heap grows, pools do,
// steps become slower, or a dropped world is not collected. Run with node --expose-gc.
import { parseArgs } from 'node:util';
import { phys2D } from '../../dist/phys2d.js';
import { validate } from '../../dist/validate.js';

/** Steps per simulated minute. */
const MINUTE = 3600;
/** Standard errors that the slope of the heap may be above 0. */
const NOISE = 2;
/** Of the step time that all but a hundredth of the steps keep, last quarter to first. */
const SLOWER = 1.1;
const BODIES = 150;

const { values } = parseArgs({ options: { minutes: { type: 'string', default: '60' } } });
const minutes = Number(values.minutes);
if (globalThis.gc === undefined || !(minutes >= 8)) {
  throw new Error('soak: needs node --expose-gc, and at least 8 minutes');
}

/** mulberry32. */
let state = 1;
function random() {
  state = (state + 0x6d2b79f5) >>> 0;
  let t = Math.imul(state ^ (state >>> 15), state | 1);
  t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
  return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
}
const span = (from, to) => from + (to - from) * random();
const pick = (list) => list[Math.floor(random() * list.length)];

function makeBin(broadphase) {
  const world = phys2D.createWorld({ broadphase });
  for (const [x, y, width, height] of [
    [0, 0.5, 20, 1],
    [-10, -10, 1, 20],
    [10, -10, 1, 20],
  ]) {
    const shapes = [phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, height) })];
    world.addRigidBody(phys2D.createRigidBody({ type: 'static', position: [x, y], shapes }));
  }
  return world;
}

function spawn(world) {
  const sides = 2 + Math.floor(span(0, 5));
  const size = span(0.3, 0.9);
  const sensor = random() < 0.05;
  const shape =
    sides < 3
      ? phys2D.createCircleShape({ radius: size / 2, sensor })
      : phys2D.createPolygonShape({ vertices: phys2D.createRegularPolygonVertices(size, size, sides), sensor });
  shape.addEventListener('begin', () => {});
  shape.addEventListener('end', () => {});
  const body = phys2D.createRigidBody({ position: [span(-9, 9), span(-15, -5)], shapes: [shape] });
  world.addRigidBody(body);
}

function join(world) {
  const [bodyA, bodyB] = [pick(world.liveDynamics), pick(world.liveDynamics)];
  if (bodyA === undefined || bodyA === bodyB) {
    return;
  }
  const params = { bodyA, bodyB, maxForce: span(10, 300), breakUnderForce: true, removeOnBreak: random() < 0.8 };
  world.addConstraint(
    random() < 0.5
      ? phys2D.createDistanceConstraint({ ...params, lowerBound: 0, upperBound: span(1, 4) })
      : phys2D.createPointConstraint({ ...params, stiff: false, frequency: 3 }),
  );
}

/** What comes and goes in a step. */
function turnOver(world) {
  if (world.rigidBodies.length < BODIES) {
    spawn(world);
  }
  if (random() < 0.1) {
    const dynamic = world.rigidBodies.filter((body) => body.isDynamic());
    for (let i = 0; i < 5 && dynamic.length > 20; i += 1) {
      world.removeRigidBody(pick(dynamic));
    }
  }
  if (random() < 0.2 && world.constraints.length < 40) {
    join(world);
  }
  const idle = world.constraints.find((constraint) => constraint.isDisabled());
  if (idle !== undefined) {
    world.removeConstraint(idle);
  }
  if (random() < 1e-4) {
    const { rigidBodies } = world;
    const walls = rigidBodies.filter((body) => body.isStatic());
    world.clear();
    walls.forEach((body) => void world.addRigidBody(body));
  }
}

let [dropped, collected] = [0, 0];
const registry = new FinalizationRegistry(() => {
  collected += 1;
});

/** A world with bodies, arbiters and joints, of which nothing is kept. */
function dropWorld() {
  const world = makeBin(phys2D.createBoxTreeBroadphase());
  for (let i = 0; i < 10; i += 1) {
    spawn(world);
  }
  world.step(1 / 60);
  join(world);
  world.step(1 / 60);
  registry.register(world);
  dropped += 1;
}

/** What waits in a world to be used again. */
function poolsOf({ pairs, events, solver, stale, broadphase }) {
  const { spare, cut, cutBefore, table } = pairs;
  const notes = events.lists.concat(events.handed).reduce((sum, { all }) => sum + all.length, 0);
  const places = table.arbiters.length + stale.items.length + (broadphase.pairs?.length ?? 0);
  let free = 0;
  for (let pair = pairs.pool; pair !== null; pair = pair.next) {
    free += 1;
  }
  return free + spare.length + cut.length + cutBefore.length + notes + places + solver.two.records.length / 100;
}

async function collect() {
  for (let i = 0; i < 3; i += 1) {
    await new Promise((resolve) => setTimeout(resolve, 0));
    globalThis.gc();
  }
}

const worlds = [makeBin(phys2D.createBoxTreeBroadphase()), makeBin(phys2D.createSweepAndPruneBroadphase())];
const heaps = [];
const pools = [];
const quarters = [[], [], [], []].map(() => new Float64Array((minutes * MINUTE) / 4));
for (let minute = 0; minute < minutes; minute += 1) {
  for (let i = 0; i < MINUTE; i += 1) {
    const began = performance.now();
    for (const world of worlds) {
      world.step(1 / 60);
    }
    const step = minute * MINUTE + i;
    const quarter = quarters[Math.floor((4 * step) / (minutes * MINUTE))];
    quarter[step % quarter.length] = performance.now() - began;
    worlds.forEach(turnOver);
    if (i % 600 === 0) {
      dropWorld();
    }
  }
  worlds.forEach((world) => void validate(world));
  await collect();
  heaps.push(process.memoryUsage().heapUsed);
  pools.push(worlds.reduce((sum, world) => sum + poolsOf(world), 0));
}

/** Slope of the line through the second half of a list, and its standard error (least squares). */
function slope(list) {
  const tail = list.slice(Math.floor(list.length / 2));
  const middle = (tail.length - 1) / 2;
  const mean = tail.reduce((sum, value) => sum + value, 0) / tail.length;
  const spread = tail.reduce((sum, _, i) => sum + (i - middle) ** 2, 0);
  const growth = tail.reduce((sum, value, i) => sum + (i - middle) * (value - mean), 0) / spread;
  const noise = tail.reduce((sum, value, i) => sum + (value - mean - growth * (i - middle)) ** 2, 0);
  return [growth, Math.sqrt(noise / (tail.length - 2) / spread)];
}

/** How much a list grows from its second quarter to its last. */
function growth(list) {
  const quarter = Math.floor(list.length / 4);
  return Math.max(...list.slice(-quarter)) / Math.max(...list.slice(quarter, 2 * quarter));
}

const p99 = quarters.map((times) => times.sort()[Math.floor(0.99 * times.length)]);
const [heapSlope, error] = slope(heaps);
const results = [
  [`heap, bytes a simulated minute (± ${Math.round(error)})`, heapSlope, heapSlope <= NOISE * error],
  ['pools, last quarter to second', growth(pools), growth(pools) <= SLOWER],
  ['p99 of the step time, last quarter to first', p99[3] / p99[0], p99[3] / p99[0] <= SLOWER],
  ['dropped worlds not collected', dropped - collected, collected === dropped],
];
console.log(`${minutes} simulated minutes, ${dropped} worlds dropped, heap ${(heaps.at(-1) / 1e6).toFixed(1)} MB`);
console.log(`heap by minutes, MB: ${heaps.map((bytes) => (bytes / 1e6).toFixed(2)).join(', ')}`);
console.log(`p99 of the step time by quarters, ms: ${p99.map((time) => time.toFixed(2)).join(', ')}`);
for (const [name, value, holds] of results) {
  console.log(`${holds ? 'ok  ' : 'FAIL'} ${name}: ${Number(value.toPrecision(3))}`);
}
process.exitCode = results.every(([, , holds]) => holds) ? 0 : 1;
