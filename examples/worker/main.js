// The page draws what the worker writes into memory that both share: no messages, no copies. It knows nothing of physics.
import { COUNT, SIZE, STEPS, STRIDE } from './shared.js';

const poses = new Float32Array(new SharedArrayBuffer(4 * STRIDE * COUNT));
const counts = new Int32Array(new SharedArrayBuffer(4));
const worker = new Worker('worker.js', { type: 'module' });
worker.postMessage({ poses, counts });

const context = document.querySelector('canvas').getContext('2d');
const text = document.querySelector('p');

function frame() {
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.fillStyle = '#14181f';
  context.fillRect(0, 0, 800, 600);
  context.strokeStyle = '#7fb2e5';
  for (let i = 0; i < COUNT; i += 1) {
    const [x, y, cos, sin] = poses.subarray(STRIDE * i, STRIDE * (i + 1));
    context.setTransform(40 * cos, 40 * sin, -40 * sin, 40 * cos, 40 * x, 40 * y);
    context.lineWidth = 1 / 40;
    context.strokeRect(-SIZE / 2, -SIZE / 2, SIZE, SIZE);
  }
  text.textContent = `${Atomics.load(counts, STEPS)} steps`;
  requestAnimationFrame(frame);
}
requestAnimationFrame(frame);
