import type { BodyState } from '../body-state.js';
import { FORCE_CHANGE } from '../config.js';
import type { World } from '../world.js';

/** The result of `findForces`: N, N and N·m. An array, as numbers that are returned might be boxed. */
export const forces = /* @__PURE__ */ new Float64Array(3);

/** Finds the forces and the torque on a body in this step, without gravity. */
export function findForces({ fx, fy, appliedTorque, applied }: BodyState): void {
  forces[0] = fx;
  forces[1] = fy;
  forces[2] = appliedTorque;
  if (applied !== null) {
    forces[0] = fx + applied.x;
    forces[1] = fy + applied.y;
    forces[2] = appliedTorque + applied.torque;
  }
}

/**
 * Wakes sleeping bodies if the forces on them for this step are not those that they fell asleep under; also if they had such forces while
 * they slept, and now have none.
 */
export function wakePushed({ pushed }: World, dt: number): void {
  for (const body of pushed) {
    const applied = body.applied!;
    if (body.asleep && (applied.pushes() ? isPushedAnew(body, dt) : applied.isKept)) {
      body.rouse();
    }
  }
}

/** Takes the forces for this step from the bodies that still sleep: those that woke before have them already. */
export function passPushed({ pushed }: World): void {
  for (const body of pushed) {
    if (body.asleep && body.applied!.pushes()) body.applied!.stay();
    else pushed.delete(body);
  }
}

/**
 * Whether forces for one step are the first ones, or differ from those of the step before by enough to set a body going, see FORCE_CHANGE.
 * Not by as much as a body bobs: what floats in peace has to fall asleep.
 */
export function isPushedAnew(body: BodyState, dt: number): boolean {
  const { applied } = body;
  if (applied === null || !applied.pushedBefore()) {
    return applied?.pushes() ?? false;
  }
  const { mass, inertia, radius } = body;
  // What cannot be turned has no inertia: to divide by it would give infinity or NaN, and hide the forces.
  const inverseMass = mass > 0 ? 1 / mass : 0;
  const inverseInertia = inertia > 0 ? 1 / inertia : 0;
  const rim = radius > 0 ? radius : 1;
  const ofForces = Math.abs(applied.x - applied.lastX) + Math.abs(applied.y - applied.lastY);
  const change = ofForces * inverseMass + Math.abs(applied.torque - applied.lastTorque) * rim * inverseInertia;
  return change * dt > FORCE_CHANGE;
}
