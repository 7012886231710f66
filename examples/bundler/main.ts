// A game loop of one's own drawing: barrels roll down a ramp, and an event counts those that come down.
import { type Circle, phys2D, type RigidBody, type Vec2 } from 'phys2d';
import { FixedStepRunner } from 'phys2d/runner';

/** px per m. */
const SCALE = 60;
const FLOOR = 1;
const BARREL = 2;

const canvas = document.querySelector('canvas')!;
const context = canvas.getContext('2d')!;
const label = document.querySelector('#landed')!;

const world = phys2D.createWorld({ gravity: [0, 10] });
const runner = FixedStepRunner.create({ world, deltaTime: 1 / 60 });
const wood = phys2D.createMaterial({ density: 0.8, staticFriction: 0.8, dynamicFriction: 0.6, elasticity: 0.2 });
let landed = 0;

function addStatic(vertices: Vec2[], group: number): void {
  const shape = phys2D.createPolygonShape({ vertices, group });
  world.addRigidBody(phys2D.createRigidBody({ type: 'static', shapes: [shape] }));
}

function addBarrel(): RigidBody {
  const shape = phys2D.createCircleShape({ radius: 0.35, material: wood, group: BARREL });
  const barrel = phys2D.createRigidBody({ position: [1 + Math.random(), 0.5], shapes: [shape] });
  const count = (): void => {
    landed += 1;
    label.textContent = `${landed} barrels have come down`;
    shape.removeEventListener('begin', count, FLOOR);
  };
  shape.addEventListener('begin', count, FLOOR);
  world.addRigidBody(barrel);
  return barrel;
}

addStatic(phys2D.createRectangleVertices(0, 9, 15, 10), FLOOR);
addStatic(
  [
    [0, 4],
    [9, 6.5],
    [9, 6.8],
    [0, 4.3],
  ],
  4,
);

const barrels: RigidBody[] = [];
const position: Vec2 = [0, 0];

function draw(): void {
  context.clearRect(0, 0, canvas.width, canvas.height);
  context.strokeStyle = '#c98f4e';
  context.lineWidth = 3;
  for (const barrel of barrels) {
    const [x, y] = runner.getPosition(barrel, position);
    const angle = runner.getRotation(barrel);
    const radius = (barrel.shapes[0] as Circle).getRadius() * SCALE;
    context.beginPath();
    context.arc(x * SCALE, y * SCALE, radius, angle, angle + 2 * Math.PI);
    context.lineTo(x * SCALE, y * SCALE);
    context.stroke();
  }
  context.fillStyle = '#4a5568';
  context.fillRect(0, 9 * SCALE, 15 * SCALE, SCALE);
  context.beginPath();
  context.moveTo(0, 4 * SCALE);
  context.lineTo(9 * SCALE, 6.5 * SCALE);
  context.lineTo(9 * SCALE, 6.8 * SCALE);
  context.lineTo(0, 4.3 * SCALE);
  context.fill();
}

let last = performance.now();
function frame(now: number): void {
  runner.advance(Math.max(0, now - last) / 1000, () => {
    if (world.timeStamp % 40 === 0 && barrels.length < 60) {
      barrels.push(addBarrel());
    }
  });
  last = now;
  draw();
  requestAnimationFrame(frame);
}
requestAnimationFrame(frame);
