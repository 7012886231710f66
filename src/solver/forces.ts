import type { RigidBody } from '../body.js';
import { FORCE_CHANGE } from '../config.js';

/** N, N and N·m, from `findForces`: numbers that are returned might be boxed. */
export const forces = new Float64Array(3);

/** Finds what pushes a body in this step, apart from gravity. */
export function findForces({ fx, fy, appliedTorque, applied }: RigidBody): void {
  forces[0] = fx;
  forces[1] = fy;
  forces[2] = appliedTorque;
  if (applied !== null) {
    forces[0] = fx + applied.x;
    forces[1] = fy + applied.y;
    forces[2] = appliedTorque + applied.torque;
  }
}

/** Whether forces for one step differ from those of the last one by what sets a body going. Not by how it bobs: what floats in peace has to fall asleep. */
export function isPushedAnew(body: RigidBody, dt: number): boolean {
  const { applied } = body;
  if (applied === null) {
    return false;
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
