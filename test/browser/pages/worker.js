import { phys2D } from '/dist/phys2d.js';

const world = phys2D.createWorld({ gravity: [0, 10] });
const body = phys2D.createRigidBody({ shapes: [phys2D.createCircleShape({ radius: 0.5 })] });
world.addRigidBody(body);
for (let i = 0; i < 60; i += 1) {
  world.step(1 / 60);
}
postMessage(body.getPosition());
