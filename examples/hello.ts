// The main job: a pyramid is hit by a heavy ball, then it rains circles and polygons.
import { type Material, phys2D, type Shape, type World } from 'phys2d';
import { stateHash } from '../test/scenes/hash.js';
import { generator } from '../test/scenes/mixed.js';
import { buildPyramid } from '../test/scenes/pyramid.js';

const STEPS = 960;
const DT = 1 / 60;
const FIRST_DROP = 120;
const DROPS = 60;
const STEPS_PER_DROP = 4;

/** Side walls, so that nothing rolls out of the picture. */
function addWalls(world: World): void {
  for (const x of [-12, 12]) {
    const wall = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1, 40) });
    world.addRigidBody(phys2D.createRigidBody({ type: 'static', shapes: [wall], position: [x, -19] }));
  }
}

function throwBall(world: World): void {
  const lead = phys2D.createMaterial({ density: 10 });
  const shape = phys2D.createCircleShape({ radius: 0.8, material: lead });
  world.addRigidBody(phys2D.createRigidBody({ shapes: [shape], position: [-10, -4], velocity: [15, -2] }));
}

/** One drop of rain: a circle, or a regular polygon of three to seven sides. */
function drop(world: World, random: () => number, material: Material): void {
  const size = 0.4 + 0.5 * random();
  const sides = 2 + Math.floor(6 * random());
  const shape: Shape =
    sides === 2
      ? phys2D.createCircleShape({ radius: size / 2, material })
      : phys2D.createPolygonShape({ vertices: phys2D.createRegularPolygonVertices(size, size, sides), material });
  const body = phys2D.createRigidBody({
    shapes: [shape],
    position: [18 * random() - 9, -14 - random()],
    rotation: 6 * random(),
    velocity: [4 * random() - 2, 5],
  });
  world.addRigidBody(body);
}

/** The contacts of the latest step: how many, and the deepest overlap in metres. */
function contactsOf(world: World): { count: number; deepest: number } {
  let count = 0;
  let deepest = 0;
  for (const arbiters of [world.dynamicArbiters, world.staticArbiters]) {
    for (const arbiter of arbiters) {
      for (const contact of arbiter.contacts) {
        if (arbiter.active && contact.active) {
          count += 1;
          deepest = Math.max(deepest, contact.getPenetration());
        }
      }
    }
  }
  return { count, deepest };
}

function showProgress(world: World, step: number): void {
  const done = Math.round((20 * step) / STEPS);
  const bar = `[${'='.repeat(done)}${' '.repeat(20 - done)}]`;
  const awake = `${world.liveDynamics.length} of ${world.rigidBodies.length} bodies awake`;
  const line = `  ${bar} step ${String(step).padStart(3)} of ${STEPS}, ${awake}`;
  if (process.stdout.isTTY) {
    process.stdout.write(`\r${line.padEnd(72)}${step === STEPS ? '\n' : ''}`);
  } else if (step % 120 === 0) {
    console.log(line);
  }
}

function quantile(sorted: readonly number[], share: number): number {
  return sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))]!;
}

console.log(`phys2d: a pyramid of 55 boxes, a heavy ball and rain, in ${STEPS} steps of 1/60 s\n`);

const world = phys2D.createWorld();
buildPyramid(phys2D, world, 10);
addWalls(world);
throwBall(world);

const random = generator(2);
const bouncy = phys2D.createMaterial({ elasticity: 0.3 });
const times: number[] = [];
const depths: number[] = [];
let mostContacts = 0;

for (let step = 1; step <= STEPS; step += 1) {
  const sinceRain = step - FIRST_DROP;
  if (sinceRain >= 0 && sinceRain % STEPS_PER_DROP === 0 && sinceRain < DROPS * STEPS_PER_DROP) {
    drop(world, random, bouncy);
  }
  const start = performance.now();
  world.step(DT);
  times.push(performance.now() - start);
  const { count, deepest } = contactsOf(world);
  depths.push(deepest);
  mostContacts = Math.max(mostContacts, count);
  if (step % 10 === 0) {
    showProgress(world, step);
  }
}

times.sort((a, b) => a - b);
depths.sort((a, b) => a - b);
const mm = (metres: number): string => `${(1000 * metres).toFixed(1)} mm`;
const ms = (milliseconds: number): string => `${milliseconds.toFixed(3)} ms`;
const rows: [string, string][] = [
  ['simulated time', `${world.simulatedTime.toFixed(2)} s`],
  ['bodies', `${world.rigidBodies.length}`],
  ['awake at the end', `${world.liveDynamics.length}`],
  ['most contacts', `${mostContacts}`],
  ['median step', ms(quantile(times, 0.5))],
  ['p95 step', ms(quantile(times, 0.95))],
  ['deepest overlap', `${mm(quantile(depths, 0.5))} in the median step, ${mm(quantile(depths, 0.95))} in 19 of 20`],
  ['state hash', stateHash(world)],
];
console.log(`\n${rows.map(([name, value]) => `  ${name.padEnd(22)}${value}`).join('\n')}\n`);
