import type { World } from '../world.js';
import { releaseAround } from './contacts/grounds.js';
import { releaseImpacts } from './impacts/impact.js';
import { releaseMeetings } from './impacts/meeting-time.js';

/**
 * Releases, between steps, what has left a world. Lists and objects that are used again would keep it, and everything that users bound to
 * it, until something else takes its place in them.
 */
export function letGo(world: World): void {
  const { cut, cutBefore } = world.pairs;
  // What was cut off is freed only in the next steps.
  world.someLeft = cut.length + cutBefore.length > 0;
  world.stale.release();
  world.toWake.release();
  world.straddling.release();
  world.deep.release();
  world.pairs.release();
  world.movers.release();
  releaseImpacts();
  releaseMeetings();
  releaseAround();
}
