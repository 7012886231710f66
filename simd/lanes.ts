import {
  CONTACT_SLOP,
  DEEP_OVERLAP,
  MAX_PUSH,
  MAX_PUSH_HOOKED,
  PRESSED_PUSH,
  PRESSED_SHARE,
  PUSH_SHARE_DEEP,
  PUSH_SHARE_HOOKED,
  PUSH_TOLERANCE,
  TOUCH_DEPTH,
} from '../src/config';
import { INV_INERTIA, VX, W, WAITS } from '../src/solver/layout';

/** Address of the length of the sub-step: as an argument it would be boxed for some of the calls. */
export const H: usize = 8;
/** Address of the squares of the worst errors of joints so far, one of each lane. */
export const WORST: usize = 16;

/** Bytes of the offsets of the bodies of two contacts, A₁, B₁, A₂, B₂. */
export const OFFSETS: usize = 16;

/** Numbers of the kernels. As a vector one is loaded with a single instruction; written out it would take four. */
const NUMBERS: usize = memory.data<f64>([
  0.5,
  TOUCH_DEPTH,
  CONTACT_SLOP,
  -PUSH_TOLERANCE,
  DEEP_OVERLAP,
  PUSH_SHARE_DEEP,
  PUSH_SHARE_HOOKED,
  -MAX_PUSH,
  -MAX_PUSH_HOOKED,
  -PRESSED_PUSH,
  PRESSED_SHARE,
]);

export const HALF = 0;
export const DEPTH = 1;
export const SLOP = 2;
export const TOLERANCE = 3;
export const DEEP = 4;
export const SHARE_DEEP = 5;
export const SHARE_HOOKED = 6;
export const LEAST = 7;
export const LEAST_HOOKED = 8;
export const PUSH = 9;
export const SHARE_PRESSED = 10;

/** One of them, in both lanes. */
export function number(which: i32): v128 {
  return splat(NUMBERS, which);
}

/** One of a table of numbers, in both lanes. */
export function splat(numbers: usize, which: i32): v128 {
  return v128.load64_splat(numbers + which * 8);
}

/** By the bits of lanes: which they are, as a mask. */
const MASKS: usize = memory.data<i64>([0, 0, -1, 0, 0, -1, -1, -1]);

export function maskOf(lanes: i32): v128 {
  return v128.load(MASKS + (lanes << 4));
}

/** From a number of a record to its address: of a pair both numbers lie side by side. */
export function at(record: usize, offset: i32): v128 {
  return v128.load(record + offset * 8);
}

/** Sets that number of both. */
export function put(record: usize, offset: i32, value: v128): void {
  v128.store(record + offset * 8, value);
}

/** One number of one body or contact. */
export function get(record: usize, offset: i32): f64 {
  return load<f64>(record + offset * 8);
}

export function set(record: usize, offset: i32, value: f64): void {
  store<f64>(record + offset * 8, value);
}

/** The first lanes, and the second ones, of two vectors. */
function first(x: v128, y: v128): v128 {
  return v128.shuffle<f64>(x, y, 0, 2);
}

function second(x: v128, y: v128): v128 {
  return v128.shuffle<f64>(x, y, 1, 3);
}

/** One number of two bodies, and the one after it: where both are asked for, each body is loaded once. */
export function firstOf(one: usize, other: usize, offset: i32): v128 {
  return first(at(one, offset), at(other, offset));
}

export function secondOf(one: usize, other: usize, offset: i32): v128 {
  return second(at(one, offset), at(other, offset));
}

/** One number of two bodies. */
export function two(x: usize, y: usize, offset: i32): v128 {
  return v128.load64_lane(y + offset * 8, v128.load64_zero(x + offset * 8), 1);
}

/** `yes` where the mask is set, else `no`. */
export function pick(mask: v128, yes: v128, no: v128): v128 {
  return v128.bitselect(yes, no, mask);
}

/** Two bodies. A class, as only its functions can be told to stand where they are called. */
export abstract class Bodies {
  /** Stores what the first three numbers of both became. What follows goes with them: a store as wide as the loads that come next is passed on to these. */
  @inline
  static put(one: usize, other: usize, lanes: i32, x: v128, y: v128, w: v128, invMass: v128): void {
    if (lanes & 1) {
      v128.store(one, first(x, y));
      v128.store(one, first(w, invMass), 16);
    }
    if (lanes & 2) {
      v128.store(other, second(x, y));
      v128.store(other, second(w, invMass), 16);
    }
  }

  /** Gives impulses to both: velocities are those of their records. */
  @inline
  static give(one: usize, other: usize, lanes: i32, jx: v128, jy: v128, jw: v128): void {
    const v1 = at(one, VX);
    const v2 = at(other, VX);
    const w1 = at(one, W);
    const w2 = at(other, W);
    const invMass = second(w1, w2);
    Bodies.put(
      one,
      other,
      lanes,
      f64x2.add(first(v1, v2), f64x2.mul(invMass, jx)),
      f64x2.add(second(v1, v2), f64x2.mul(invMass, jy)),
      f64x2.add(first(w1, w2), f64x2.mul(two(one, other, INV_INERTIA), jw)),
      invMass,
    );
  }
}

/**
 * Which of contacts k and k + 1 are to be solved, of those from one index to another: bits 0 and 1; bits 2 and 3 for those that have to wait for these, as the second does where
 * both have a body that can move.
 */
export function lanesOf(bodiesOfSecond: i32, k: i32, from: i32, to: i32): i32 {
  let lanes = bodiesOfSecond & WAITS ? 9 : 3;
  if (k < from) lanes = 2;
  if (k + 1 >= to) lanes &= 1;
  return lanes;
}
