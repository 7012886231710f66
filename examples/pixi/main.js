// PixiJS draws, phys2d moves: one picture for each body, put where the runner says before each frame. Click to add a ball.
import { phys2D } from 'phys2d';
import { FixedStepRunner } from 'phys2d/runner';
import { Application, Graphics } from 'pixi.js';

/** px per m. */
const SCALE = 60;

const app = new Application();
await app.init({ width: 900, height: 600, background: '#14181f', antialias: true });
document.body.append(app.canvas);

const world = phys2D.createWorld({ gravity: [0, 10] });
const runner = FixedStepRunner.create({ world });
/** Body → its picture. */
const pictures = new Map();

function add(body, picture) {
  world.addRigidBody(body);
  picture.position.set(...body.getPosition().map((value) => SCALE * value));
  app.stage.addChild(picture);
  pictures.set(body, picture);
}

function addBox(type, x, y, width, height, color) {
  const shape = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, height) });
  const body = phys2D.createRigidBody({ type, position: [x, y], shapes: [shape] });
  const [w, h] = [width * SCALE, height * SCALE];
  add(body, new Graphics().rect(-w / 2, -h / 2, w, h).fill(color));
}

function addBall(x, y) {
  const radius = 0.2 + 0.2 * Math.random();
  const shape = phys2D.createCircleShape({ radius, material: phys2D.createMaterial({ elasticity: 0.5 }) });
  const body = phys2D.createRigidBody({ position: [x, y], shapes: [shape] });
  const picture = new Graphics().circle(0, 0, radius * SCALE).fill('#4ec9b0');
  add(
    body,
    picture
      .moveTo(0, 0)
      .lineTo(radius * SCALE, 0)
      .stroke({ width: 2, color: '#14181f' }),
  );
}

addBox('static', 7.5, 9.5, 15, 1, '#4a5568');
for (let row = 0; row < 6; row += 1) {
  for (let i = 0; i < 6 - row; i += 1) {
    addBox('dynamic', 5 + i * 0.9 + row * 0.45, 8.6 - 0.8 * row, 0.8, 0.8, '#c98f4e');
  }
}

app.stage.eventMode = 'static';
app.stage.hitArea = app.screen;
app.stage.on('pointerdown', ({ global }) => addBall(global.x / SCALE, global.y / SCALE));

const position = [0, 0];
app.ticker.add(({ elapsedMS }) => {
  runner.advance(elapsedMS / 1000);
  for (const [body, picture] of pictures) {
    const [x, y] = runner.getPosition(body, position);
    picture.position.set(SCALE * x, SCALE * y);
    picture.rotation = runner.getRotation(body);
  }
});

// For the console, and the test.
Object.assign(globalThis, { app, world, runner, pictures, addBall });
