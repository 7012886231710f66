import type { RigidBody } from '../body.js';
import type { Shape } from '../shape/shape.js';
import type { World } from '../world.js';
import { growBounds, HALF_MARGIN } from './bounds.js';

const bounds = /* @__PURE__ */ new Float64Array(4);

/** The bounds of a shape for the broadphase: two shapes within the speculative margin overlap. Dead after the next call. */
export function broadphaseBounds(shape: Shape): Float64Array {
  growBounds(shape, HALF_MARGIN, bounds);
  return bounds;
}

/** Puts a shape of a body of a world, which is placed, into the broadphase. */
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

/** The beginning of a step: everything is where it is, and what woke since the last one is told. */
export function refreshMoved(world: World): void {
  refreshBodies(world);
  world.events.noteWoken(world);
  // At the end: where more follows a loop that was compiled while it ran, that code is left by a bailout in every step.
  const { liveDynamics } = world;
  for (let i = 0; i < liveDynamics.length; i += 1) {
    liveDynamics[i]!.refreshMass();
  }
}

/** For queries: within a step placements are those that it began with. */
export function refreshPlaces(world: World): void {
  if (!world.stepping) {
    refreshBodies(world);
  }
}

/** Within a step: some bodies are elsewhere than the broadphase has them, as it moves them or shows them to callbacks. */
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
