// A world on a server: 60 steps a second, whatever else the process does, and the poses printed twice a second, as a game would send them.
// node server.js [seconds], default 10.
import { phys2D } from 'phys2d';
import { FixedStepRunner } from 'phys2d/runner';

const seconds = Number(process.argv[2] ?? 10);

const world = phys2D.createWorld({ gravity: [0, 10] });
const box = (width, height) => phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, height) });
world.addRigidBody(phys2D.createRigidBody({ type: 'static', position: [0, 0.5], shapes: [box(40, 1)] }));

const rubber = phys2D.createMaterial({ elasticity: 0.8 });
const players = ['ada', 'bob', 'cyd'].map((name, i) => {
  const shape = phys2D.createCircleShape({ radius: 0.5, material: rubber });
  const body = phys2D.createRigidBody({ position: [3 * i, -4 - i], velocity: [1, 0], shapes: [shape], userData: name });
  world.addRigidBody(body);
  return body;
});

/** What goes to the clients: numbers that are short enough to send. */
function poses() {
  return players.map((body) => {
    const [x, y] = body.getPosition();
    return { name: body.userData, x: round(x), y: round(y), angle: round(body.getRotation()) };
  });
}

const round = (value) => Math.round(1000 * value) / 1000;

// Timers are late and uneven; the runner makes as many steps as are due.
const runner = FixedStepRunner.create({ world, deltaTime: 1 / 60, maxSteps: 30 });
let last = performance.now();
let printed = 0;
const timer = setInterval(() => {
  const now = performance.now();
  runner.advance((now - last) / 1000);
  last = now;
  if (world.timeStamp - printed >= 30) {
    printed = world.timeStamp;
    console.log(JSON.stringify({ step: world.timeStamp, poses: poses() }));
  }
  if (world.simulatedTime >= seconds) {
    clearInterval(timer);
  }
}, 1000 / 60);
