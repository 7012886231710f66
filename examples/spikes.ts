// Spikes kill the player, who comes back at the start; hard landings cost health.
import { phys2D, type RigidBody } from 'phys2d';

const PLAYER = 1;
const GROUND = 2;
const SPIKES = 4;
/** N·s that a landing may have without harm, and health lost for each more. */
const SAFE_IMPULSE = 6;
const DAMAGE = 5;

const world = phys2D.createWorld();
const say = (text: string) => console.log(`${world.simulatedTime.toFixed(1)} s: ${text}`);

function addStatic(x1: number, y1: number, x2: number, y2: number, group: number): void {
  const shape = phys2D.createPolygonShape({ vertices: phys2D.createRectangleVertices(x1, y1, x2, y2), group });
  world.addRigidBody(phys2D.createRigidBody({ type: 'static', shapes: [shape] }));
}

addStatic(-10, 0, 10, 1, GROUND);
addStatic(4, -0.3, 4.5, 0, SPIKES);
addStatic(4.5, -0.3, 5, 0, SPIKES);

let health = 100;
let player = spawn();

function spawn(): RigidBody {
  health = 100;
  const shape = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1, 1), group: PLAYER });
  const body = phys2D.createRigidBody({ position: [0, -0.5], shapes: [shape], inertia: Infinity });
  // What else happened in the step of the death is still told: two spikes may be touched at once. Then the body has no world any more.
  shape.addEventListener(
    'begin',
    () => {
      if (world.removeRigidBody(body)) {
        say('dead');
        player = spawn();
      }
    },
    SPIKES,
  );
  shape.addEventListener(
    'hit',
    (_arbiter, _other, hit) => {
      if (body.world !== null) {
        health -= Math.round(Math.max(0, hit.impulse - SAFE_IMPULSE) * DAMAGE);
        say(`landed at ${hit.approachSpeed.toFixed(1)} m/s, health ${health}`);
      }
    },
    GROUND,
    2,
  );
  world.addRigidBody(body);
  return body;
}

function jump(x: number, y: number, seconds: number): void {
  player.setVelocity([x, y]);
  for (let i = 0; i < seconds * 60; i += 1) {
    world.step(1 / 60);
  }
}

jump(0, -5, 1.5);
jump(0, -10, 2.5);
jump(0, -14, 3.5);
jump(3.2, -7, 2);
say(`health ${health}, ${world.rigidBodies.length} bodies`);
jump(3.2, -7, 2);
say(`health ${health}, ${world.rigidBodies.length} bodies`);
