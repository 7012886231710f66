import type { World } from '../../src/index.js';

/**
 * The state of a world as 16 hex digits: FNV-1a over the bits of the placement and velocity of every body, and whether it
 * sleeps. Equal states of equally built worlds have equal hashes; a difference in the last bit of a number shows.
 */
export function stateHash(world: World): string {
  const numbers = new Float64Array(7);
  const bytes = new Uint8Array(numbers.buffer);
  let low = 0x811c9dc5;
  let high = 0xcbf29ce4;
  for (const body of world.rigidBodies) {
    const [x, y] = body.getPosition();
    const [vx, vy] = body.getVelocity();
    numbers.set([x, y, body.getRotation(), vx, vy, body.getAngularVelocity(), body.sleeping ? 1 : 0]);
    for (const byte of bytes) {
      low = Math.imul(low ^ byte, 0x01000193) >>> 0;
      high = Math.imul(high ^ byte ^ (low >>> 24), 0x01000193) >>> 0;
    }
  }
  return high.toString(16).padStart(8, '0') + low.toString(16).padStart(8, '0');
}
