import type { RigidBody } from './body.js';

/** Offsets of what `writePose` writes. */
export const X = 0;
export const Y = 1;
export const ANGLE = 2;

/**
 * Writes where a body was when a share of its last step had passed: 0 is the placement before the step, 1 the present one. It goes back
 * along the motion of that step, so a body that was moved by hand since does not fly across the picture. Uses only members of a body that
 * every bundle has.
 */
export function writePose(body: RigidBody, share: number, out: Float64Array): void {
  body.getPosition(out);
  out[ANGLE] = body.getRotation();
  if (share !== 1 && body.world !== null) {
    const rest = 1 - share;
    out[X]! -= rest * body.lastDx;
    out[Y]! -= rest * body.lastDy;
    out[ANGLE]! -= rest * body.lastTurn;
  }
}
