import { phys2D } from 'phys2d';

const world = phys2D.createWorld();
const bead = phys2D.createRigidBody({ position: [1, 0], shapes: [phys2D.createCircleShape({ radius: 0.1 })] });
world.addRigidBody(bead);

// A bead on a wire along y = x²: the error is y − x², and its derivative by the bead's velocities (1 row: x, y, angular).
const wire = phys2D.createCustomConstraint({
  dimension: 1,
  bodies: [bead],
  position(data, index) {
    const [x, y] = bead.getPosition();
    data[index] = y - x * x;
  },
  jacobian(data, index) {
    data[index] = -2 * bead.getPosition()[0];
    data[index + 1] = 1;
    data[index + 2] = 0;
  },
});
world.addConstraint(wire);

for (let i = 1; i <= 60; i += 1) {
  world.step(1 / 60);
  if (i % 20 === 0) {
    const [x, y] = bead.getPosition();
    console.log(`${world.simulatedTime.toFixed(2)} s: the bead is at (${x.toFixed(2)}, ${y.toFixed(2)})`);
  }
}
