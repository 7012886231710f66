import type { RigidBody } from '../body.js';
import { FAR } from '../config.js';
import type { World } from '../world.js';
import * as d from './layout.js';

// In spite of all checks the numbers of a body may become infinite or NaN: forces and masses are legal up to 1e308, and a custom constraint
// may write what it likes. Such a body is frozen for the step, so that it spoils nothing else.

/** Freezes a body whose packed numbers would overflow, before it can spoil what it touches: in this step nothing moves it. */
export function freezeIfWild(world: World, body: RigidBody): void {
  const at = body.slot * d.BODY_STRIDE;
  const { velocity: v, motion: q, drive: f } = world.solver;
  const speed = Math.abs(v[at + d.VX]!) + Math.abs(v[at + d.VY]!) + Math.abs(v[at + d.W]!);
  const gain = Math.abs(f[at + d.GAIN_X]!) + Math.abs(f[at + d.GAIN_Y]!) + Math.abs(f[at + d.GAIN_W]!);
  if (!(speed + gain + v[at + d.INV_MASS]! + v[at + d.INV_INERTIA]! <= FAR)) {
    for (const numbers of [v, q, f]) numbers.fill(0, at, at + d.BODY_STRIDE);
    f[at + d.REST_RADIUS] = -1;
    world.frozen.add(body);
  }
}

/**
 * Ends the step of the frozen bodies: they stay where they were, velocities and forces are reset, and their joints and contacts forget
 * their impulses.
 */
export function restFrozen(world: World): void {
  for (const body of world.frozen) {
    body.vx = 0;
    body.vy = 0;
    body.w = 0;
    body.fx = 0;
    body.fy = 0;
    body.appliedTorque = 0;
    body.forgetMotion();
    for (const { arbiters } of body.shapes) {
      for (const pair of arbiters) {
        pair.dropPoints();
      }
    }
    for (const constraint of body.constraints) {
      constraint.forget();
      constraint.touch();
    }
    world.events.frozen(world, body);
  }
  world.frozen.clear();
}
