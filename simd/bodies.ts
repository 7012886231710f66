// The loops over bodies: what `src/solver/body-loops.ts` and `advancePlain` of `src/solver/joints/kernels/pose.ts` do, operation by operation, so that the results are the same to the bit; x and y at once. Those that turn bodies return the
// index of the first that they leave to the loops in TypeScript, as its turn is not small.
import { MAX_SPEED, REST_DAMPING, REST_SPEED } from '../src/config';
import { ANGLE, COS, X } from '../src/constraint/layout';
import {
  BODY_STRIDE,
  COS_LESS_ONE,
  DW,
  DX,
  GAIN_W,
  GAIN_X,
  KEEP_ANGULAR,
  KEEP_LINEAR,
  QW,
  QX,
  REST_RADIUS,
  SIN,
  SMALL_TURN,
  TOUCHED,
  VX,
  VY,
  W,
} from '../src/solver/layout';
import { at, get, H, put, set, splat } from './lanes';

export function addForces(velocity: usize, drive: usize, from: i32, to: i32): void {
  for (let k = from; k < to; k += 1) {
    const i = <usize>k * (8 * BODY_STRIDE);
    const v = velocity + i;
    const f = drive + i;
    put(v, VX, f64x2.mul(f64x2.add(at(v, VX), at(f, GAIN_X)), splat(f, KEEP_LINEAR)));
    set(v, W, (get(v, W) + get(f, GAIN_W)) * get(f, KEEP_ANGULAR));
  }
}

export function moveOn(velocity: usize, motion: usize, drive: usize, from: i32, to: i32): void {
  const h = load<f64>(H);
  const inverseSquare = 1 / (REST_SPEED * REST_SPEED);
  for (let k = from; k < to; k += 1) {
    const i = <usize>k * (8 * BODY_STRIDE);
    const v = velocity + i;
    const f = drive + i;
    const radius = get(f, REST_RADIUS);
    const vx = get(v, VX);
    const vy = get(v, VY);
    const w = get(v, W);
    const share = (vx * vx + vy * vy + radius * w * w) * inverseSquare;
    const rests = radius >= 0 && get(f, TOUCHED) === 1 && share < 1;
    const keep = rests ? 1 - REST_DAMPING * h * (1 - share) : 1;
    const moved = f64x2.mul(at(v, VX), f64x2.splat(keep));
    const turned = w * keep;
    put(v, VX, moved);
    set(v, W, turned);
    put(motion + i, QX, f64x2.mul(moved, f64x2.splat(h)));
    set(motion + i, QW, turned * h);
  }
}

export function advance(velocity: usize, motion: usize, drive: usize, from: i32, to: i32): i32 {
  for (let k = from; k < to; k += 1) {
    const i = <usize>k * (8 * BODY_STRIDE);
    const q = motion + i;
    const turn = get(q, DW) + get(q, QW);
    const isTouched = get(drive + i, TOUCHED) === 1;
    if (isTouched && !(turn < SMALL_TURN && turn > -SMALL_TURN)) {
      return k;
    }
    put(q, DX, f64x2.add(at(q, DX), at(q, QX)));
    set(q, DW, turn);
    if (isTouched) {
      const s = turn * turn;
      set(velocity + i, COS_LESS_ONE, s * (-1.0 / 2.0 + s * (1.0 / 24.0 - s * (1.0 / 720.0 - s / 40320.0))));
      set(velocity + i, SIN, turn * (1 - s * (1.0 / 6.0 - s * (1.0 / 120.0 - s * (1.0 / 5040.0 - s / 362880.0)))));
    }
  }
  return to;
}

/** Whether what moves at a speed is no slower than that: also where that is no number. */
function isWild(record: usize, most: f64): bool {
  return !(Math.abs(get(record, VX)) < most && Math.abs(get(record, VY)) < most && Math.abs(get(record, W)) < most);
}

export function advancePoses(velocity: usize, motion: usize, pose: usize, from: i32, to: i32): i32 {
  const most = MAX_SPEED * load<f64>(H);
  for (let k = from; k < to; k += 1) {
    const i = <usize>k * (8 * BODY_STRIDE);
    const q = motion + i;
    const p = pose + i;
    const turn = get(q, QW);
    const square = turn * turn;
    if (square > SMALL_TURN * SMALL_TURN || isWild(velocity + i, MAX_SPEED) || isWild(q, most)) {
      return k;
    }
    const c = 1 - square * (1.0 / 2.0 - square * (1.0 / 24.0 - square * (1.0 / 720.0 - square / 40320.0)));
    const s = turn * (1 - square * (1.0 / 6.0 - square * (1.0 / 120.0 - square * (1.0 / 5040.0 - square / 362880.0))));
    const old = at(p, COS);
    const across = f64x2.mul(v128.shuffle<f64>(old, old, 1, 0), f64x2.replace_lane(f64x2.splat(s), 0, -s));
    put(p, COS, f64x2.add(f64x2.mul(old, f64x2.splat(c)), across));
    put(p, X, f64x2.add(at(p, X), at(q, QX)));
    set(p, ANGLE, get(p, ANGLE) + turn);
  }
  return to;
}
