// A platform that one can jump through from below, stand on, and drop through on demand.
import { type Arbiter, phys2D, type RigidBody, type Shape, type World } from 'phys2d';

const DT = 1 / 60;
const TOP = -2;

interface Player {
  readonly name: string;
  readonly body: RigidBody;
}

const world = phys2D.createWorld();

function addStatic(y1: number, y2: number): Shape {
  const shape = phys2D.createPolygonShape({ vertices: phys2D.createRectangleVertices(-10, y1, 10, y2) });
  world.addRigidBody(phys2D.createRigidBody({ type: 'static', shapes: [shape] }));
  return shape;
}

function addPlayer(to: World, name: string, x: number, shapes: Shape[]): Player {
  const body = phys2D.createRigidBody({ position: [x, -0.8], inertia: Infinity, shapes });
  to.addRigidBody(body);
  return { name, body };
}

/** How fast the part of a body that touches comes down: what tumbles does faster, or slower, than its middle. */
function fallSpeed(body: RigidBody, arbiter: Arbiter): number {
  const [x] = body.getPosition();
  const [, speed] = body.getVelocity();
  const speeds = arbiter.contacts.map((contact) => speed + body.getAngularVelocity() * (contact.getPosition()[0] - x));
  return Math.max(0, ...speeds);
}

/** Bears what was above it a step ago, by the body, as one of several shapes may well be above; decided once, when it touches first, until it leaves. */
function makeOneWay(platform: Shape): Shape {
  platform.addEventListener('preSolve', (arbiter, other) => {
    const body = other.body!;
    arbiter.setAcceptedState(body.computeWorldBounds()[3] - fallSpeed(body, arbiter) * DT <= TOP + 0.02);
    arbiter.setPersistentState(true);
  });
  return platform;
}

/** Lets a body that stands on a platform fall through it. */
function drop(platform: Shape, body: RigidBody): void {
  for (const arbiter of platform.arbiters) {
    if (arbiter.bodyA === body || arbiter.bodyB === body) {
      arbiter.setAcceptedState(false);
    }
  }
}

const box = () => [phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(0.6, 1.6) })];
const capsule = () => [
  phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(0.6, 1) }),
  phys2D.createCircleShape({ radius: 0.3, origin: [0, -0.5] }),
  phys2D.createCircleShape({ radius: 0.3, origin: [0, 0.5] }),
];

const early = addPlayer(world, 'early', -3, box());
addStatic(0, 1);
const platform = makeOneWay(addStatic(TOP, TOP + 0.2));
const late = addPlayer(world, 'late', 0, capsule());
const fast = addPlayer(world, 'fast', 3, box());
const players = [early, late, fast];

function run(seconds: number, what: string): void {
  for (let i = 0; i < seconds * 60; i += 1) {
    world.step(DT);
  }
  const feet = players.map(({ name, body }) => `${name} at ${body.computeWorldBounds()[3].toFixed(2)}`);
  console.log(`${what}: ${feet.join(', ')}`);
}

run(1, 'on the ground');
early.body.setVelocity([0, -8]);
late.body.setVelocity([0, -8]);
fast.body.setVelocity([0, -30]);
run(8, 'after a jump');
for (const { body } of players) {
  drop(platform, body);
}
run(0.25, 'going down');
run(2, 'down again');
