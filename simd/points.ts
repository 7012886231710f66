// Rigid point joints, two at a time: what `src/solver/joints/kernels/point-loops.ts` does, operation by operation, so that the results are the same to the bit. No two that share a body lie side by side; where
// the second is missing, its record has anchors of 0, and what is done in its place touches no body. From one record to another, both even; each returns twice the index of the first that is not done, and 1 if an error
// was worth another iteration: what is rare, such as a turn that is not small, is left to the loops in TypeScript.
import { MIN_INVERSE_MASS } from '../src/config';
import { JOINT_SNAP, JOINT_TOLERANCE, SINGULAR } from '../src/config-joints';
import { COS, X } from '../src/constraint/layout';
import * as j from '../src/solver/joints/joint-layout';
import { INV_INERTIA, MISSING, QW, QX, SMALL_TURN, VX, W } from '../src/solver/layout';
import * as n from './lanes';
import { at, Bodies, firstOf, maskOf, OFFSETS, put, secondOf, splat, two } from './lanes';

/** Bytes of two records. */
const RECORDS: usize = 16 * j.POINT_STRIDE;

const NUMBERS: usize = memory.data<f64>([
  0.5,
  1 / 24,
  1 / 6,
  1 / 120,
  1,
  SMALL_TURN * SMALL_TURN,
  JOINT_TOLERANCE * JOINT_TOLERANCE,
  JOINT_SNAP * JOINT_SNAP,
  SINGULAR,
  MIN_INVERSE_MASS,
]);

const HALF = 0;
const BY_24 = 1;
const BY_6 = 2;
const BY_120 = 3;
const ONE = 4;
const SMALL = 5;
const TOLERANCE = 6;
const SNAP = 7;
const RANK = 8;
const LIGHTEST = 9;

function number(which: i32): v128 {
  return splat(NUMBERS, which);
}

/** Of K. */
function diagonal(m: v128, iA: v128, a: v128, iB: v128, b: v128): v128 {
  return f64x2.add(f64x2.add(m, f64x2.mul(f64x2.mul(iA, a), a)), f64x2.mul(f64x2.mul(iB, b), b));
}

/** Where K can be inverted as a whole. */
function isRegular(k11: v128, k22: v128, product: v128, det: v128): v128 {
  return v128.and(
    f64x2.gt(det, f64x2.mul(number(RANK), product)),
    v128.and(f64x2.gt(k11, number(LIGHTEST)), f64x2.gt(k22, number(LIGHTEST))),
  );
}

export function warmStartPoints(records: usize, bodies: usize, velocity: usize, pose: usize, from: i32, to: i32): i32 {
  let worst = v128.load(n.WORST);
  for (let k = from; k < to; k += 2) {
    const r = records + <usize>(k >> 1) * RECORDS;
    const pair = bodies + <usize>(k >> 1) * OFFSETS;
    const a1 = load<i32>(pair) << 3;
    const b1 = load<i32>(pair, 4) << 3;
    const bodiesOfSecond = load<i32>(pair, 8);
    const lanes = bodiesOfSecond & MISSING ? 1 : 3;
    const a2 = bodiesOfSecond << 3;
    const b2 = load<i32>(pair, 12) << 3;
    const cosA = firstOf(pose + a1, pose + a2, COS);
    const sinA = secondOf(pose + a1, pose + a2, COS);
    const cosB = firstOf(pose + b1, pose + b2, COS);
    const sinB = secondOf(pose + b1, pose + b2, COS);
    let x = at(r, j.ANCHOR_AX);
    let y = at(r, j.ANCHOR_AY);
    const ax = f64x2.sub(f64x2.mul(cosA, x), f64x2.mul(sinA, y));
    const ay = f64x2.add(f64x2.mul(sinA, x), f64x2.mul(cosA, y));
    x = at(r, j.ANCHOR_BX);
    y = at(r, j.ANCHOR_BY);
    const bx = f64x2.sub(f64x2.mul(cosB, x), f64x2.mul(sinB, y));
    const by = f64x2.add(f64x2.mul(sinB, x), f64x2.mul(cosB, y));
    const dx = f64x2.sub(firstOf(pose + b1, pose + b2, X), firstOf(pose + a1, pose + a2, X));
    const dy = f64x2.sub(secondOf(pose + b1, pose + b2, X), secondOf(pose + a1, pose + a2, X));
    const cx = f64x2.add(dx, f64x2.sub(bx, ax));
    const cy = f64x2.add(dy, f64x2.sub(by, ay));
    const mA = secondOf(velocity + a1, velocity + a2, W);
    const m = f64x2.add(mA, secondOf(velocity + b1, velocity + b2, W));
    const iA = two(velocity + a1, velocity + a2, INV_INERTIA);
    const iB = two(velocity + b1, velocity + b2, INV_INERTIA);
    const k11 = diagonal(m, iA, ay, iB, by);
    const k12 = f64x2.sub(f64x2.mul(f64x2.mul(f64x2.neg(iA), ax), ay), f64x2.mul(f64x2.mul(iB, bx), by));
    const k22 = diagonal(m, iA, ax, iB, bx);
    const product = f64x2.mul(k11, k22);
    const det = f64x2.sub(product, f64x2.mul(k12, k12));
    if (lanes & ~i64x2.bitmask(isRegular(k11, k22, product, det))) {
      v128.store(n.WORST, worst);
      return k << 2;
    }
    const square = f64x2.add(f64x2.mul(cx, cx), f64x2.mul(cy, cy));
    worst = f64x2.pmax(worst, square);
    const inverse = f64x2.div(number(ONE), det);
    put(r, j.ARM_AX, ax);
    put(r, j.ARM_AY, ay);
    put(r, j.ARM_BX, bx);
    put(r, j.ARM_BY, by);
    put(r, j.ERROR_X, cx);
    put(r, j.ERROR_Y, cy);
    put(r, j.PUSH_X, f64x2.splat(0));
    put(r, j.PUSH_Y, f64x2.splat(0));
    put(r, j.I11, f64x2.mul(k22, inverse));
    put(r, j.I12, f64x2.mul(f64x2.neg(k12), inverse));
    put(r, j.I22, f64x2.mul(k11, inverse));
    const px = at(r, j.IMPULSE_X);
    const py = at(r, j.IMPULSE_Y);
    const jwA = f64x2.sub(f64x2.mul(ax, py), f64x2.mul(ay, px));
    const jwB = f64x2.sub(f64x2.mul(bx, py), f64x2.mul(by, px));
    Bodies.give(velocity + a1, velocity + a2, lanes, f64x2.neg(px), f64x2.neg(py), f64x2.neg(jwA));
    Bodies.give(velocity + b1, velocity + b2, lanes, px, py, jwB);
  }
  v128.store(n.WORST, worst);
  return to << 2;
}

export function pushPoints(records: usize, bodies: usize, motion: usize, from: i32, to: i32): i32 {
  let worst = v128.load(n.WORST);
  let found = 0;
  for (let k = from; k < to; k += 2) {
    const r = records + <usize>(k >> 1) * RECORDS;
    const pair = bodies + <usize>(k >> 1) * OFFSETS;
    const a1 = motion + (load<i32>(pair) << 3);
    const b1 = motion + (load<i32>(pair, 4) << 3);
    const bodiesOfSecond = load<i32>(pair, 8);
    const lanes = bodiesOfSecond & MISSING ? 1 : 3;
    const a2 = motion + (bodiesOfSecond << 3);
    const b2 = motion + (load<i32>(pair, 12) << 3);
    const qax = firstOf(a1, a2, QX);
    const qay = secondOf(a1, a2, QX);
    const qbx = firstOf(b1, b2, QX);
    const qby = secondOf(b1, b2, QX);
    const wA = firstOf(a1, a2, QW);
    const mA = secondOf(a1, a2, QW);
    const wB = firstOf(b1, b2, QW);
    const mB = secondOf(b1, b2, QW);
    const squareA = f64x2.mul(wA, wA);
    const squareB = f64x2.mul(wB, wB);
    const ca = cosLessOne(squareA);
    const sa = sine(wA, squareA);
    const cb = cosLessOne(squareB);
    const sb = sine(wB, squareB);
    let x = at(r, j.ARM_AX);
    let y = at(r, j.ARM_AY);
    const dax = f64x2.sub(f64x2.mul(ca, x), f64x2.mul(sa, y));
    const day = f64x2.add(f64x2.mul(sa, x), f64x2.mul(ca, y));
    const ax = f64x2.add(x, dax);
    const ay = f64x2.add(y, day);
    x = at(r, j.ARM_BX);
    y = at(r, j.ARM_BY);
    const dbx = f64x2.sub(f64x2.mul(cb, x), f64x2.mul(sb, y));
    const dby = f64x2.add(f64x2.mul(sb, x), f64x2.mul(cb, y));
    const bx = f64x2.add(x, dbx);
    const by = f64x2.add(y, dby);
    const dx = f64x2.sub(qbx, qax);
    const dy = f64x2.sub(qby, qay);
    const cx = f64x2.add(f64x2.add(at(r, j.ERROR_X), dx), f64x2.sub(dbx, dax));
    const cy = f64x2.add(f64x2.add(at(r, j.ERROR_Y), dy), f64x2.sub(dby, day));
    const square = f64x2.add(f64x2.mul(cx, cx), f64x2.mul(cy, cy));
    const iA = two(a1, a2, INV_INERTIA);
    const iB = two(b1, b2, INV_INERTIA);
    const m = f64x2.add(mA, mB);
    const k11 = diagonal(m, iA, ay, iB, by);
    const k12 = f64x2.sub(f64x2.mul(f64x2.mul(f64x2.neg(iA), ax), ay), f64x2.mul(f64x2.mul(iB, bx), by));
    const k22 = diagonal(m, iA, ax, iB, bx);
    const product = f64x2.mul(k11, k22);
    const det = f64x2.sub(product, f64x2.mul(k12, k12));
    const isRare = v128.or(
      v128.or(f64x2.gt(squareA, number(SMALL)), f64x2.gt(squareB, number(SMALL))),
      v128.and(f64x2.gt(square, number(SNAP)), f64x2.ne(at(r, j.POINT_SNAPS), f64x2.splat(0))),
    );
    if (lanes & i64x2.bitmask(v128.or(isRare, v128.not(isRegular(k11, k22, product, det))))) {
      v128.store(n.WORST, worst);
      return (k << 2) | found;
    }
    const mask = v128.and(f64x2.gt(square, number(TOLERANCE)), maskOf(lanes));
    if (v128.any_true(mask)) {
      found |= i64x2.bitmask(mask);
      worst = f64x2.pmax(worst, v128.and(mask, square));
    }
    const inverse = f64x2.div(number(ONE), det);
    const i11 = f64x2.mul(k22, inverse);
    const i12 = f64x2.mul(f64x2.neg(k12), inverse);
    const i22 = f64x2.mul(k11, inverse);
    put(r, j.PLACED_WA, wA);
    put(r, j.PLACED_WB, wB);
    put(r, j.PLACED_AX, ax);
    put(r, j.PLACED_AY, ay);
    put(r, j.PLACED_BX, bx);
    put(r, j.PLACED_BY, by);
    put(r, j.OFFSET_X, f64x2.sub(cx, f64x2.add(f64x2.sub(dx, f64x2.mul(wB, by)), f64x2.mul(wA, ay))));
    put(r, j.OFFSET_Y, f64x2.sub(cy, f64x2.sub(f64x2.add(dy, f64x2.mul(wB, bx)), f64x2.mul(wA, ax))));
    put(r, j.I11, i11);
    put(r, j.I12, i12);
    put(r, j.I22, i22);
    const jx = f64x2.add(f64x2.mul(i11, cx), f64x2.mul(i12, cy));
    const jy = f64x2.add(f64x2.mul(i12, cx), f64x2.mul(i22, cy));
    put(r, j.PUSH_X, f64x2.sub(at(r, j.PUSH_X), jx));
    put(r, j.PUSH_Y, f64x2.sub(at(r, j.PUSH_Y), jy));
    const jwA = f64x2.sub(f64x2.mul(ax, jy), f64x2.mul(ay, jx));
    const jwB = f64x2.sub(f64x2.mul(bx, jy), f64x2.mul(by, jx));
    Bodies.put(
      a1,
      a2,
      lanes,
      f64x2.add(qax, f64x2.mul(mA, jx)),
      f64x2.add(qay, f64x2.mul(mA, jy)),
      f64x2.add(wA, f64x2.mul(iA, jwA)),
      mA,
    );
    Bodies.put(
      b1,
      b2,
      lanes,
      f64x2.sub(qbx, f64x2.mul(mB, jx)),
      f64x2.sub(qby, f64x2.mul(mB, jy)),
      f64x2.sub(wB, f64x2.mul(iB, jwB)),
      mB,
    );
  }
  v128.store(n.WORST, worst);
  return (to << 2) | found;
}

/** Of a small turn, by its square. */
function cosLessOne(square: v128): v128 {
  return f64x2.mul(square, f64x2.sub(f64x2.mul(square, number(BY_24)), number(HALF)));
}

function sine(turn: v128, square: v128): v128 {
  const inner = f64x2.sub(number(BY_6), f64x2.mul(square, number(BY_120)));
  return f64x2.mul(turn, f64x2.sub(number(ONE), f64x2.mul(square, inner)));
}

/** A class, as only its functions can be told to stand where they are called. */
abstract class Points {
  /** Sweeps over velocities or, with the offset of a constant part of the error, over positions. */
  @inline
  static sweep(
    records: usize,
    bodies: usize,
    velocity: usize,
    from: i32,
    to: i32,
    arms: i32,
    impulse: i32,
    rest: i32,
  ): i32 {
    let found = 0;
    for (let k = from; k < to; k += 2) {
      const r = records + <usize>(k >> 1) * RECORDS;
      const pair = bodies + <usize>(k >> 1) * OFFSETS;
      const a1 = velocity + (load<i32>(pair) << 3);
      const b1 = velocity + (load<i32>(pair, 4) << 3);
      const bodiesOfSecond = load<i32>(pair, 8);
      const lanes = bodiesOfSecond & MISSING ? 1 : 3;
      const a2 = velocity + (bodiesOfSecond << 3);
      const b2 = velocity + (load<i32>(pair, 12) << 3);
      const vax = firstOf(a1, a2, VX);
      const vay = secondOf(a1, a2, VX);
      const vbx = firstOf(b1, b2, VX);
      const vby = secondOf(b1, b2, VX);
      const wA = firstOf(a1, a2, W);
      const mA = secondOf(a1, a2, W);
      const wB = firstOf(b1, b2, W);
      const mB = secondOf(b1, b2, W);
      const ax = at(r, arms);
      const ay = at(r, arms + 2);
      const bx = at(r, arms + 4);
      const by = at(r, arms + 6);
      let cx = f64x2.add(f64x2.sub(f64x2.sub(vbx, vax), f64x2.mul(wB, by)), f64x2.mul(wA, ay));
      let cy = f64x2.sub(f64x2.add(f64x2.sub(vby, vay), f64x2.mul(wB, bx)), f64x2.mul(wA, ax));
      if (rest > 0) {
        cx = f64x2.add(at(r, rest), cx);
        cy = f64x2.add(at(r, rest + 2), cy);
        const square = f64x2.add(f64x2.mul(cx, cx), f64x2.mul(cy, cy));
        found |= i64x2.bitmask(f64x2.gt(square, number(TOLERANCE))) & lanes;
      }
      const i12 = at(r, j.I12);
      const jx = f64x2.add(f64x2.mul(at(r, j.I11), cx), f64x2.mul(i12, cy));
      const jy = f64x2.add(f64x2.mul(i12, cx), f64x2.mul(at(r, j.I22), cy));
      put(r, impulse, f64x2.sub(at(r, impulse), jx));
      put(r, impulse + 2, f64x2.sub(at(r, impulse + 2), jy));
      const jwA = f64x2.sub(f64x2.mul(ax, jy), f64x2.mul(ay, jx));
      const jwB = f64x2.sub(f64x2.mul(bx, jy), f64x2.mul(by, jx));
      Bodies.put(
        a1,
        a2,
        lanes,
        f64x2.add(vax, f64x2.mul(mA, jx)),
        f64x2.add(vay, f64x2.mul(mA, jy)),
        f64x2.add(wA, f64x2.mul(two(a1, a2, INV_INERTIA), jwA)),
        mA,
      );
      Bodies.put(
        b1,
        b2,
        lanes,
        f64x2.sub(vbx, f64x2.mul(mB, jx)),
        f64x2.sub(vby, f64x2.mul(mB, jy)),
        f64x2.sub(wB, f64x2.mul(two(b1, b2, INV_INERTIA), jwB)),
        mB,
      );
    }
    return (to << 2) | found;
  }
}

export function solveVelocityPoints(records: usize, bodies: usize, velocity: usize, from: i32, to: i32): i32 {
  return Points.sweep(records, bodies, velocity, from, to, j.ARM_AX, j.IMPULSE_X, 0);
}

export function pushPointsLinearly(records: usize, bodies: usize, motion: usize, from: i32, to: i32): i32 {
  return Points.sweep(records, bodies, motion, from, to, j.PLACED_AX, j.PUSH_X, j.OFFSET_X);
}

export function finishPoints(records: usize, bodies: usize, velocity: usize, from: i32, to: i32): i32 {
  const share = v128.load64_splat(n.H);
  for (let k = from; k < to; k += 2) {
    const r = records + <usize>(k >> 1) * RECORDS;
    const pair = bodies + <usize>(k >> 1) * OFFSETS;
    const a1 = velocity + (load<i32>(pair) << 3);
    const b1 = velocity + (load<i32>(pair, 4) << 3);
    const bodiesOfSecond = load<i32>(pair, 8);
    const lanes = bodiesOfSecond & MISSING ? 1 : 3;
    const a2 = velocity + (bodiesOfSecond << 3);
    const b2 = velocity + (load<i32>(pair, 12) << 3);
    const carry = f64x2.mul(share, at(r, j.POINT_CARRY));
    const x = f64x2.mul(carry, at(r, j.PUSH_X));
    const y = f64x2.mul(carry, at(r, j.PUSH_Y));
    const ax = at(r, j.ARM_AX);
    const ay = at(r, j.ARM_AY);
    const bx = at(r, j.ARM_BX);
    const by = at(r, j.ARM_BY);
    const jwA = f64x2.sub(f64x2.mul(ax, y), f64x2.mul(ay, x));
    const jwB = f64x2.sub(f64x2.mul(bx, y), f64x2.mul(by, x));
    Bodies.give(a1, a2, lanes, f64x2.neg(x), f64x2.neg(y), f64x2.neg(jwA));
    Bodies.give(b1, b2, lanes, x, y, jwB);
    const jx = f64x2.add(x, at(r, j.IMPULSE_X));
    const jy = f64x2.add(y, at(r, j.IMPULSE_Y));
    put(r, j.SUM_X, f64x2.add(at(r, j.SUM_X), jx));
    put(r, j.SUM_Y, f64x2.add(at(r, j.SUM_Y), jy));
    put(r, j.SUM_WA, f64x2.sub(at(r, j.SUM_WA), f64x2.sub(f64x2.mul(ax, jy), f64x2.mul(ay, jx))));
    put(r, j.SUM_WB, f64x2.add(at(r, j.SUM_WB), f64x2.sub(f64x2.mul(bx, jy), f64x2.mul(by, jx))));
  }
  return to << 2;
}
