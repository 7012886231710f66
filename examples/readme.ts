import { phys2D } from 'phys2d';

const world = phys2D.createWorld({ gravity: [0, 10] });
const ground = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(20, 1) });
world.addRigidBody(phys2D.createRigidBody({ type: 'static', position: [0, 0.5], shapes: [ground] }));

const rubber = phys2D.createMaterial({ elasticity: 1 });
const ball = phys2D.createRigidBody({
  position: [0, -3],
  shapes: [phys2D.createCircleShape({ radius: 0.5, material: rubber })],
});
world.addRigidBody(ball);

for (let i = 1; i <= 120; i += 1) {
  world.step(1 / 60);
  if (i % 20 === 0) {
    const [x, y] = ball.getPosition();
    console.log(`${world.simulatedTime.toFixed(2)} s: the ball is at (${x.toFixed(2)}, ${y.toFixed(2)})`);
  }
}
