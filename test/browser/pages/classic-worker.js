importScripts('/dist/phys2d.umd.min.js');

const world = self.phys2D.createWorld({ gravity: [0, 10] });
const body = self.phys2D.createRigidBody({ shapes: [self.phys2D.createCircleShape({ radius: 0.5 })] });
world.addRigidBody(body);
for (let i = 0; i < 60; i += 1) {
  world.step(1 / 60);
}
postMessage(body.getPosition());
