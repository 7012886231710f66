// A platform that one can jump through from below, stand on, and drop through on demand.
import { phys2D, type RigidBody, type Shape, type World } from 'phys2d';

const DT = 1 / 60;
const TOP = -2;

interface Player {
  readonly name: string;
  readonly body: RigidBody;
  wantsDown: boolean;
}

const world = phys2D.createWorld();

function addStatic(y1: number, y2: number): Shape {
  const shape = phys2D.createPolygonShape({ vertices: phys2D.createRectangleVertices(-10, y1, 10, y2) });
  world.addRigidBody(phys2D.createRigidBody({ type: 'static', shapes: [shape] }));
  return shape;
}

function addPlayer(to: World, name: string, x: number, shapes: Shape[]): Player {
  const body = phys2D.createRigidBody({ position: [x, -0.8], inertia: Infinity, shapes });
  const player = { name, body, wantsDown: false };
  body.userData = player;
  to.addRigidBody(body);
  return player;
}

/** The feet must have been above the platform a step ago. Decided by the body, as one of several shapes may well be above. */
function makeOneWay(platform: Shape): void {
  platform.addEventListener('preSolve', (arbiter, other) => {
    const { body, wantsDown } = other.body!.userData as Player;
    const [, speed] = body.getVelocity();
    const feet = body.computeWorldBounds()[3];
    if (wantsDown || speed < -0.01 || feet - speed * DT > TOP + 0.02) {
      arbiter.setAcceptedState(false);
      arbiter.setPersistentState(true);
    }
  });
}

const box = () => [phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(0.6, 1.6) })];
const capsule = () => [
  phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(0.6, 1) }),
  phys2D.createCircleShape({ radius: 0.3, origin: [0, -0.5] }),
  phys2D.createCircleShape({ radius: 0.3, origin: [0, 0.5] }),
];

const early = addPlayer(world, 'early', -3, box());
addStatic(0, 1);
makeOneWay(addStatic(TOP, TOP + 0.2));
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
for (const player of players) {
  player.wantsDown = true;
  player.body.wake();
}
run(0.25, 'going down');
for (const player of players) {
  player.wantsDown = false;
}
run(2, 'down again');
