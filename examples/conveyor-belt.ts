// A belt carries crates into a bin; another one is reversed while a crate sleeps on it.
import { phys2D, type RigidBody } from 'phys2d';

const world = phys2D.createWorld();

// The default friction is that of rubber: with it, crates on a fast belt tip over.
const wood = phys2D.createMaterial({ staticFriction: 0.6, dynamicFriction: 0.5 });

function addWall(x1: number, y1: number, x2: number, y2: number): RigidBody {
  const vertices = phys2D.createRectangleVertices(x1, y1, x2, y2);
  const shape = phys2D.createPolygonShape({ vertices, material: wood });
  const body = phys2D.createRigidBody({ type: 'static', shapes: [shape] });
  world.addRigidBody(body);
  return body;
}

function addBelt(x1: number, x2: number, top: number, speed: number): RigidBody {
  const belt = addWall(x1, top, x2, top + 0.4);
  belt.setSurfaceVelocity([speed, 0]);
  return belt;
}

function addCrate(x: number, y: number): RigidBody {
  const shape = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(0.5, 0.5), material: wood });
  const crate = phys2D.createRigidBody({ position: [x, y], shapes: [shape] });
  world.addRigidBody(crate);
  return crate;
}

function run(seconds: number): void {
  for (let i = 0; i < seconds * 60; i += 1) {
    world.step(1 / 60);
  }
}

const at = (crate: RigidBody) => `(${crate.getPosition().map((value) => value.toFixed(1))})`;

addBelt(0, 6, 0, 1.5);
addWall(6, 3, 10, 3.2);
addWall(6, 1, 6.2, 3);
addWall(9.8, 1, 10, 3);
const crates = [1, 2, 3].map((x) => addCrate(x, -0.25));
run(1);
console.log(`on the belt: ${crates.map((crate) => `${crate.getVelocity()[0].toFixed(2)} m/s`).join(', ')}`);
run(9);
console.log(`in the bin: ${crates.map(at).join(' ')}`);

const belt = addBelt(-20, 0, 5, -1.5);
addWall(-8, 3, -7.8, 5);
const rider = addCrate(-4, 4.75);
run(5);
console.log(`stopped by a wall: ${at(rider)}, ${rider.sleeping ? 'asleep' : 'awake'}`);
belt.setSurfaceVelocity([1.5, 0]);
run(2);
console.log(`reversed: ${at(rider)}, ${rider.getVelocity()[0].toFixed(2)} m/s`);
