import { SPECULATIVE_MARGIN } from '../config.js';
import type { Shape } from '../shape/shape.js';
import type { World } from '../world.js';

const bounds = new Float64Array(4);

/** The bounds of a shape for the broadphase: two shapes within the speculative margin overlap. Dead after the next call. */
export function widened(shape: Shape): Float64Array {
  const tight = shape.bounds;
  bounds[0] = tight[0]! - SPECULATIVE_MARGIN / 2;
  bounds[1] = tight[1]! - SPECULATIVE_MARGIN / 2;
  bounds[2] = tight[2]! + SPECULATIVE_MARGIN / 2;
  bounds[3] = tight[3]! + SPECULATIVE_MARGIN / 2;
  return bounds;
}

/** Brings turned geometry, bounds and broadphase up to date for every body that was moved or reshaped; notes what woke. */
export function refreshMoved(world: World): void {
  const { stale, broadphase } = world;
  for (let i = 0; i < world.staleCount; i += 1) {
    const body = stale[i]!;
    if (body.owner !== world || !body.placeStale) {
      continue;
    }
    body.place();
    body.placeStale = false;
    for (const shape of body.shapes) {
      broadphase.update(shape.handle!, widened(shape), body.asleep);
    }
  }
  world.staleCount = 0;
  world.events.noteWoken(world);
}
