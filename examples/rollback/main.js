// The page: both peers as they see the game. A, D, W and S for the left player, arrows for the right one; bots until a key is pressed.
import { CanvasDebugDevice, Physics2DDebugDraw } from 'phys2d/debug';
import { HEIGHT, JUMP, LEFT, RIGHT, THROW, WIDTH } from './game.ts';
import { bot, Match } from './match.ts';

/** Player, and what the key means. */
const KEYS = {
  KeyA: [0, LEFT],
  KeyD: [0, RIGHT],
  KeyW: [0, JUMP],
  KeyS: [0, THROW],
  ArrowLeft: [1, LEFT],
  ArrowRight: [1, RIGHT],
  ArrowUp: [1, JUMP],
  ArrowDown: [1, THROW],
};
const FRAME = 1000 / 60;

const match = new Match();
const held = [0, 0];
const bots = [bot(5), bot(6)];

function hold(event, isDown) {
  const key = KEYS[event.code];
  if (key !== undefined) {
    const [player, bit] = key;
    bots[player] = null;
    held[player] = isDown ? held[player] | bit : held[player] & ~bit;
    event.preventDefault();
  }
}

addEventListener('keydown', (event) => hold(event, true));
addEventListener('keyup', (event) => hold(event, false));

const views = match.peers.map((_, i) => {
  const context = document.querySelectorAll('canvas')[i].getContext('2d');
  const debug = Physics2DDebugDraw.create({ graphicsDevice: CanvasDebugDevice.create({ context }) });
  debug.setPhysics2DViewport([-0.5, -0.5, WIDTH + 0.5, HEIGHT + 0.5]);
  return { context, debug };
});
const text = document.querySelector('p');

let last = performance.now();
function frame(now) {
  // After a pause the game goes on from where it was.
  last = Math.max(last, now - 10 * FRAME);
  for (; now - last >= FRAME; last += FRAME) {
    match.advance(held.map((keys, i) => bots[i]?.() ?? keys));
  }
  views.forEach(({ context, debug }, i) => {
    context.fillStyle = '#14181f';
    context.fillRect(0, 0, context.canvas.width, context.canvas.height);
    debug.begin();
    debug.drawWorld(match.peers[i].game.world);
    debug.end();
  });
  const [a, b] = match.peers;
  const state = match.diverged < 0 ? 'the same to the bit' : `different from frame ${match.diverged} on`;
  text.textContent =
    `${a.game.numbers[0]} : ${a.game.numbers[1]}. ${match.compared} frames compared: ${state}. ` +
    `${a.rollbacks} and ${b.rollbacks} rollbacks, ${a.waits} and ${b.waits} waits.`;
  requestAnimationFrame(frame);
}
requestAnimationFrame(frame);
