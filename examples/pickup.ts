// Coins that the player collects by touching them and enemies cannot take; a checkpoint that tells who comes and goes.
import { phys2D, type RigidBody, type Shape } from 'phys2d';

const PLAYER = 1;
const ENEMY = 2;
const GROUND = 4;
const PICKUP = 8;

const world = phys2D.createWorld();
let coins = 0;

function addStatic(shape: Shape, position: [number, number]): RigidBody {
  const body = phys2D.createRigidBody({ type: 'static', position, shapes: [shape] });
  world.addRigidBody(body);
  return body;
}

function addCoin(x: number): void {
  const shape = phys2D.createCircleShape({ radius: 0.2, sensor: true, group: PICKUP, mask: PLAYER });
  const coin = addStatic(shape, [x, -0.9]);
  // A walker has two shapes, and both may touch it in one step: it can be removed only once.
  shape.addEventListener('begin', () => {
    coins += world.removeRigidBody(coin) ? 1 : 0;
  });
}

function addCheckpoint(x: number): void {
  const vertices = phys2D.createBoxVertices(1, 4);
  const shape = phys2D.createPolygonShape({ vertices, sensor: true, group: PICKUP, mask: PLAYER | ENEMY });
  addStatic(shape, [x, -2]);
  // Events are about pairs of shapes. What a body does is found by counting: its first shape enters, its last one leaves.
  const inside = new Map<RigidBody, number>();
  const count = (body: RigidBody, change: number, message: string) => {
    const now = (inside.get(body) ?? 0) + change;
    inside.set(body, now);
    if (now === Math.max(0, change)) {
      console.log(`${body.userData} ${message} the checkpoint`);
    }
  };
  shape.addEventListener('begin', (_arbiter, other) => count(other.body!, 1, 'reaches'));
  shape.addEventListener('end', (_arbiter, other) => count(other.body!, -1, 'leaves'));
}

function addWalker(name: string, group: number): void {
  const ice = phys2D.createMaterial({ staticFriction: 0, dynamicFriction: 0 });
  const common = { group, mask: GROUND | PICKUP, material: ice };
  const torso = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(0.6, 1), ...common });
  const head = phys2D.createCircleShape({ radius: 0.3, origin: [0, -0.6], ...common });
  const body = phys2D.createRigidBody({
    position: [-2, -0.5],
    velocity: [5, 0],
    linearDrag: 0,
    inertia: Infinity,
    shapes: [torso, head],
    userData: name,
  });
  world.addRigidBody(body);
  for (let i = 0; i < 180; i += 1) {
    world.step(1 / 60);
  }
  console.log(`${name} walked to x = ${body.getPosition()[0].toFixed(1)}: ${coins} coins`);
}

addStatic(phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(60, 1), group: GROUND }), [0, 0.5]);
for (let x = 2; x <= 6; x += 1) {
  addCoin(x);
}
addCheckpoint(8);
addWalker('the enemy', ENEMY);
addWalker('the player', PLAYER);
