// Rollbacks of 8 steps in each of 2,500 frames, many times over, with bodies that come and go, on the built package: how large the heap is after each
// time, code that was compiled aside, and whether the broadphase knows the bodies that there are, once each. node test/state/heap.mjs
import { text } from 'node:stream/consumers';
import { getHeapSnapshot } from 'node:v8';
import { phys2D } from '../../dist/phys2d.js';

const RUNS = 8;
const FRAMES = 2500;

const world = phys2D.createWorld();
const box = (width, height) => phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, height) });
world.addRigidBody(phys2D.createRigidBody({ type: 'static', position: [0, 0.5], shapes: [box(30, 1)] }));
for (let i = 0; i < 12; i += 1) {
  const position = [1.02 * (i % 10) - 5, -0.6 - 1.01 * Math.floor(i / 10)];
  world.addRigidBody(phys2D.createRigidBody({ position, shapes: [box(1, 1)] }));
}
const ring = Array.from({ length: 8 }, () => new ArrayBuffer(40_000));
const pushed = world.rigidBodies[5];
const passing = phys2D.createRigidBody({ shapes: [phys2D.createCircleShape({ radius: 0.4 })] });

function step() {
  if (world.timeStamp % 50 === 10) {
    pushed.setVelocity([1, -5]);
    passing.setPosition([3, -6]);
    world.addRigidBody(passing);
  } else if (world.timeStamp % 50 === 40) {
    world.removeRigidBody(passing);
  }
  world.step(1 / 60);
}

function frame() {
  for (let i = 0; i < 8; i += 1) {
    ring[i] = world.snapshot(ring[i]);
    step();
  }
  world.restore(ring[0]);
  step();
}

/** Types of what a program makes; the others are what the engine that runs it makes of the program: code, its feedback and shapes. */
const MADE = [
  'object',
  'array',
  'number',
  'closure',
  'native',
  'bigint',
  'symbol',
  'concatenated string',
  'sliced string',
];

/** Bytes of all of those that are alive. */
async function bytesAlive() {
  const { snapshot, nodes } = JSON.parse(await text(getHeapSnapshot()));
  const { node_fields: fields, node_types: types } = snapshot.meta;
  const [type, size] = ['type', 'self_size'].map((name) => fields.indexOf(name));
  let bytes = 0;
  for (let i = 0; i < nodes.length; i += fields.length) {
    if (MADE.includes(types[type][nodes[i + type]])) {
      bytes += nodes[i + size];
    }
  }
  return bytes;
}

const sizes = new Float64Array(RUNS);
for (let run = 0; run < RUNS; run += 1) {
  for (let i = 0; i < FRAMES; i += 1) {
    frame();
  }
  sizes[run] = await bytesAlive();
}
const handles = new Set(world.rigidBodies.flatMap(({ shapes }) => shapes.map(({ handle }) => handle))).size;
const found = world.bodyRectangleQuery([-1e6, -1e6, 1e6, 1e6], []);
console.log(JSON.stringify({ sizes: [...sizes], frames: FRAMES, handles, found, bodies: world.rigidBodies.length }));
