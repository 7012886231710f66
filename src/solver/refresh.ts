import type { RigidBody } from '../body.js';
import type { Shape } from '../shape/shape.js';
import type { World } from '../world.js';
import { growBounds, HALF_MARGIN } from './bounds.js';

const bounds = /* @__PURE__ */ new Float64Array(4);

/**
 * The bounds of a shape for the broadphase: those of two shapes that are closer than the speculative margin overlap. The array is reused by
 * the next call.
 */
export function broadphaseBounds(shape: Shape): Float64Array {
  growBounds(shape, HALF_MARGIN, bounds);
  return bounds;
}

/** Inserts a shape into the broadphase, whose body is in the world and placed. */
export function insertHandle({ broadphase, movers }: World, shape: Shape): void {
  const body = shape.owner!;
  if (body.asleep) movers.space.forget();
  shape.handle = broadphase.insert(shape, broadphaseBounds(shape), body.asleep, body, shape);
}

/** Tells the broadphase where the shapes of a body are, and whether they may move. */
export function updateHandles({ broadphase, movers }: World, { shapes, asleep }: RigidBody): void {
  if (asleep) movers.space.forget();
  for (let i = 0; i < shapes.length; i += 1) {
    broadphase.update(shapes[i]!.handle!, broadphaseBounds(shapes[i]!), asleep);
  }
}

/** Begins a step: brings geometry and broadphase up to date, and tells of what woke since the last step. */
export function refreshMoved(world: World): void {
  refreshBodies(world);
  world.events.noteWoken(world);
  // This loop is the last: where code follows a loop that was compiled while it ran, that code is left by a bailout in every step.
  const { liveDynamics } = world;
  for (let i = 0; i < liveDynamics.length; i += 1) {
    liveDynamics[i]!.refreshMass();
  }
}

/** Brings geometry and broadphase up to date for queries. Within a step they stay as they were when it began. */
export function refreshPlaces(world: World): void {
  if (!world.stepping) {
    refreshBodies(world);
  }
}

/** Whether, within a step, some bodies are not where the broadphase has them, as the step moves them or shows them to callbacks. */
export function isUnderWay({ movers, solver }: World): boolean {
  return movers.count + solver.joints.shown.size > 0;
}

/** Brings turned geometry, bounds and broadphase up to date for every body that was moved or reshaped. */
function refreshBodies(world: World): void {
  const { stale } = world;
  for (let i = 0; i < stale.count; i += 1) {
    const body = stale.items[i]!;
    if (body.owner !== world || !body.placeStale) {
      continue;
    }
    body.place();
    body.placeStale = false;
    body.refreshMass();
    updateHandles(world, body);
  }
  stale.clear();
}
