import { type HitHandler, phys2D } from 'phys2d';

const world = phys2D.createWorld();
const vertices = phys2D.createBoxVertices(20, 1);
const ground = phys2D.createPolygonShape({ vertices, userData: 'the ground' });
world.addRigidBody(phys2D.createRigidBody({ type: 'static', position: [0, 0.5], shapes: [ground] }));

function drop(name: string, position: [number, number], strength: number): void {
  const shape = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(0.8, 0.8), userData: name });
  const body = phys2D.createRigidBody({ position, shapes: [shape] });
  world.addRigidBody(body);

  // Called for what comes together at 1 m/s or more. What breaks is removed at once: in a handler that is allowed.
  const onHit: HitHandler = (_arbiter, other, hit) => {
    const breaks = hit.impulse > strength;
    console.log(`${name} hits ${other.userData} at ${hit.approachSpeed.toFixed(1)} m/s${breaks ? ' and breaks' : ''}`);
    if (breaks) {
      world.removeRigidBody(body);
    }
  };
  shape.addEventListener('hit', onHit, undefined, 1);
}

drop('a crate', [0, -2], 20);
drop('a vase', [0.2, -4], 3);
for (let i = 0; i < 120; i += 1) {
  world.step(1 / 60);
}
