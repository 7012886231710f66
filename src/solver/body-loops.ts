import { REST_DAMPING, REST_SPEED } from '../config.js';
import { cosSin } from '../math/trig.js';
import type { SolverData } from './data.js';
import * as d from './layout.js';

// Loops over bodies, from one slot to another.

/** Angle, cosine, sine: scratch of `advance`. */
const turned = /* @__PURE__ */ new Float64Array(3);

/** Forces, gravity and drag of one sub-step: v ← (v + a·h) · (1 − drag)^h. */
export function addForces(data: SolverData, from: number, to: number): void {
  const { velocity: v, drive: f } = data;
  for (let k = from; k < to; k += 1) {
    const i = (k * d.BODY_STRIDE) & d.OFFSET;
    const keep = f[i + d.KEEP_LINEAR]!;
    v[i + d.VX] = (v[i + d.VX]! + f[i + d.GAIN_X]!) * keep;
    v[i + d.VY] = (v[i + d.VY]! + f[i + d.GAIN_Y]!) * keep;
    v[i + d.W] = (v[i + d.W]! + f[i + d.GAIN_W]!) * f[i + d.KEEP_ANGULAR]!;
  }
}

/** The motion of one sub-step, q = v·h, after rest damping of slow bodies in contact. */
export function moveOn(data: SolverData, from: number, to: number, h: number): void {
  const { velocity: v, motion: q, drive: f } = data;
  const inverseSquare = 1 / (REST_SPEED * REST_SPEED);
  for (let k = from; k < to; k += 1) {
    const i = (k * d.BODY_STRIDE) & d.OFFSET;
    const radius = f[i + d.REST_RADIUS]!;
    let vx = v[i + d.VX]!;
    let vy = v[i + d.VY]!;
    let w = v[i + d.W]!;
    const share = (vx * vx + vy * vy + radius * w * w) * inverseSquare;
    const damped = 1 - REST_DAMPING * h * (1 - share);
    // No arithmetic in a branch: most bodies take it only late, when compiled code would bail out.
    const keep = radius >= 0 && f[i + d.TOUCHED] === 1 && share < 1 ? damped : 1;
    vx *= keep;
    vy *= keep;
    w *= keep;
    v[i + d.VX] = vx;
    v[i + d.VY] = vy;
    v[i + d.W] = w;
    q[i + d.QX] = vx * h;
    q[i + d.QY] = vy * h;
    q[i + d.QW] = w * h;
  }
}

/**
 * Adds the motion of the sub-step, position corrections included, to that of the step. Of bodies in contact also finds the cosine and sine
 * of how far they have turned in the step.
 */
export function advance(data: SolverData, from: number, to: number): void {
  const { velocity: v, motion: q, drive: f } = data;
  for (let k = from; k < to; k += 1) {
    const i = (k * d.BODY_STRIDE) & d.OFFSET;
    q[i + d.DX] = q[i + d.DX]! + q[i + d.QX]!;
    q[i + d.DY] = q[i + d.DY]! + q[i + d.QY]!;
    const turn = q[i + d.DW]! + q[i + d.QW]!;
    q[i + d.DW] = turn;
    if (f[i + d.TOUCHED] !== 1) {
      continue;
    }
    if (turn < d.SMALL_TURN && turn > -d.SMALL_TURN) {
      const s = turn * turn;
      v[i + d.COS_LESS_ONE] = s * (-1 / 2 + s * (1 / 24 - s * (1 / 720 - s / 40320)));
      v[i + d.SIN] = turn * (1 - s * (1 / 6 - s * (1 / 120 - s * (1 / 5040 - s / 362880))));
    } else {
      turned[0] = turn;
      cosSin(turned);
      v[i + d.COS_LESS_ONE] = turned[1]! - 1;
      v[i + d.SIN] = turned[2]!;
    }
  }
}
