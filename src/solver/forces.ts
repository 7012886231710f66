import type { BodyState } from '../body-state.js';
import { FORCE_CHANGE } from '../config.js';
import type { World } from '../world.js';

/** N, N and N·m, from `findForces`: numbers that are returned might be boxed. */
export const forces = /* @__PURE__ */ new Float64Array(3);

/** Finds what pushes a body in this step, apart from gravity. */
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

/** Wakes what sleeps, if what pushes it now is not what it fell asleep under; also if that pushed it on while it slept, and does no longer. */
export function wakePushed({ pushed }: World, dt: number): void {
  for (const body of pushed) {
    const applied = body.applied!;
    if (body.asleep && (applied.pushes() ? isPushedAnew(body, dt) : applied.isKept)) {
      body.rouse();
    }
  }
}

/** Takes what pushes from all that sleeps on: what woke until now has it already. */
export function passPushed({ pushed }: World): void {
  for (const body of pushed) {
    if (body.asleep && body.applied!.pushes()) body.applied!.stay();
    else pushed.delete(body);
  }
}

/** Whether forces for one step are the first ones, or differ from those of the last one by what sets a body going. Not by how it bobs: what floats in peace has to fall asleep. */
export function isPushedAnew(body: BodyState, dt: number): boolean {
  const { applied } = body;
  if (applied === null || !applied.pushedBefore()) {
    return applied?.pushes() ?? false;
  }
  const { mass, inertia, radius } = body;
  // What cannot be turned has no inertia: to divide by it would make numbers that are none, and hide what pushes.
  const inverseMass = mass > 0 ? 1 / mass : 0;
  const inverseInertia = inertia > 0 ? 1 / inertia : 0;
  const rim = radius > 0 ? radius : 1;
  const ofForces = Math.abs(applied.x - applied.lastX) + Math.abs(applied.y - applied.lastY);
  const change = ofForces * inverseMass + Math.abs(applied.torque - applied.lastTorque) * rim * inverseInertia;
  return change * dt > FORCE_CHANGE;
}
