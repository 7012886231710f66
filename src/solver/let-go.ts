import type { World } from '../world.js';
import { releaseAround } from './contacts/seams.js';
import { releaseImpacts } from './impacts/impact.js';
import { releaseMeetings } from './impacts/meetings.js';

/** Lets go, between steps, of what has left a world: lists and objects that are used again would hold it until something else takes its place in them, and all that users bound to it. */
export function letGo(world: World): void {
  const { cut, cutBefore } = world.pairs;
  // What is cut is freed only in the next steps.
  world.someLeft = cut.length + cutBefore.length > 0;
  world.stale.release();
  world.toWake.release();
  world.straddling.release();
  world.pairs.release();
  world.movers.release();
  releaseImpacts();
  releaseMeetings();
  releaseAround();
}
