/**
 * A check that a world is consistent.
 *
 * @module phys2d/validate
 */

import type { BroadphaseHandle } from '../broadphase/broadphase.js';
import type { World } from '../world.js';
import { Audit } from './audit.js';
import { auditBodies } from './bodies.js';
import { auditConstraints } from './constraints.js';
import { auditPairs } from './pairs.js';

const EVERYWHERE = [-Infinity, -Infinity, Infinity, Infinity];

/**
 * Checks that a world is consistent: its lists, and what is stored in several places; islands and what sleeps; arbiters and the table of
 * pairs; the handles in the broadphase; constraints; and pools. All numbers must be finite, and contacts may only push. A world is always
 * consistent, whatever calls are made: if it is not, that is a defect of the engine (or of a broadphase of your own), worth a report with
 * this error.
 *
 * Changes nothing. Takes about as long as a step. Call it between steps or in event handlers. The world has to come from a bundle of the
 * same kind: `validate.min.js` goes with `phys2d.min.js` alone.
 *
 * @throws Error that says what is wrong where, such as `validate: world.rigidBodies[3]: velocity x must be a finite number, got NaN`.
 * @throws Error during a step, in `preSolve` handlers and callbacks of constraints.
 * @throws TypeError if it is no world, or one of another bundle.
 */
export function validate(world: World): void {
  if (typeof world?.step !== 'function' || typeof world.gravityX !== 'number') {
    throw new TypeError('validate: world must be a World of the same kind of bundle, minified or not');
  }
  if (world.stepping) {
    throw new Error('validate: must not be called during a step');
  }
  const audit = new Audit(world);
  audit.finite(world, 'gravity x', world.gravityX);
  audit.finite(world, 'gravity y', world.gravityY);
  audit.finite(world, 'simulatedTime', world.simulatedTime);
  audit.demand(world.toWake.count === 0, world, 'what was hit must be woken within the step');
  auditBodies(audit);
  auditHandles(audit);
  auditConstraints(audit);
  auditPairs(audit);
}

/** Checks that the broadphase holds the handles of the shapes, and no others. */
function auditHandles(audit: Audit): void {
  const { world } = audit;
  const found = new Set<BroadphaseHandle>();
  world.broadphase.sample(EVERYWHERE, (handle) => {
    audit.demand(!found.has(handle), world, 'the broadphase reports a handle twice');
    found.add(handle);
  });
  let count = 0;
  for (const body of world.rigidBodies) {
    for (const shape of body.shapes) {
      count += 1;
      audit.demand(found.has(shape.handle!), shape, 'its handle is not in the broadphase');
    }
  }
  audit.demand(found.size === count, world, `the broadphase must have ${count} handles, got ${found.size}`);
}
