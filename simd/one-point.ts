// Contacts of one point, two at a time, and over positions one by one: what `src/solver/contacts/one-point.ts` does, operation by operation, so that the results are the same to the bit.
import {
  CALM_ACCELERATION,
  CONTACT_SLOP,
  DEEP_OVERLAP,
  DEEP_OVERLAP_CIRCLES,
  MAX_PUSH,
  MAX_PUSH_HOOKED,
  PRESSED_PUSH,
  PRESSED_SHARE,
  PUSH_SHARE_CIRCLES,
  PUSH_SHARE_CROWD,
  PUSH_SHARE_DEEP,
  PUSH_SHARE_DEEP_CIRCLES,
  PUSH_SHARE_HOOKED,
  PUSH_SHARE_STATIC,
  PUSH_TOLERANCE,
} from '../src/config';
import * as d from '../src/solver/layout';
import * as n from './lanes';
import { at, Bodies, firstOf, get, lanesOf, maskOf, number, OFFSETS, pick, put, secondOf, set, two } from './lanes';

/** Bytes of two records. */
const RECORDS: usize = 16 * d.ONE_STRIDE;

export function warmStartOne(records: usize, bodies: usize, velocity: usize, motion: usize, from: i32, to: i32): void {
  const zero = f64x2.splat(0);
  const inverseH = f64x2.splat(1 / load<f64>(n.H));
  for (let k = from & d.EVEN; k < to; k += 2) {
    const r = records + <usize>(k >> 1) * RECORDS;
    const pair = bodies + <usize>(k >> 1) * OFFSETS;
    const a1 = load<i32>(pair) << 3;
    const b1 = load<i32>(pair, 4) << 3;
    const bodiesOfSecond = load<i32>(pair, 8);
    const a2 = bodiesOfSecond << 3;
    const b2 = load<i32>(pair, 12) << 3;
    const nx = at(r, d.NX);
    const ny = at(r, d.NY);
    const rnA = at(r, d.RN_A1);
    const rnB = at(r, d.RN_B1);
    const rtA = at(r, d.RT_A);
    const rtB = at(r, d.RT_B);
    const dax = firstOf(motion + a1, motion + a2, d.DX);
    const day = secondOf(motion + a1, motion + a2, d.DX);
    const dx = f64x2.sub(firstOf(motion + b1, motion + b2, d.DX), dax);
    const dy = f64x2.sub(secondOf(motion + b1, motion + b2, d.DX), day);
    const cosA = firstOf(velocity + a1, velocity + a2, d.COS_LESS_ONE);
    const sinA = secondOf(velocity + a1, velocity + a2, d.COS_LESS_ONE);
    const cosB = firstOf(velocity + b1, velocity + b2, d.COS_LESS_ONE);
    const sinB = secondOf(velocity + b1, velocity + b2, d.COS_LESS_ONE);
    let s = f64x2.add(f64x2.add(at(r, d.START1), f64x2.mul(nx, dx)), f64x2.mul(ny, dy));
    s = f64x2.add(f64x2.add(s, f64x2.mul(cosB, at(r, d.PIVOT_B))), f64x2.mul(sinB, rnB));
    s = f64x2.sub(f64x2.sub(s, f64x2.mul(cosA, at(r, d.PIVOT_A))), f64x2.mul(sinA, rnA));
    const gap = f64x2.add(s, number(n.DEPTH));
    // What the velocities have no say in may be done for both at once.
    put(r, d.SEPARATION1, s);
    put(
      r,
      d.BIAS1,
      f64x2.add(f64x2.mul(f64x2.mul(number(n.HALF), f64x2.add(gap, f64x2.abs(gap))), inverseH), at(r, d.SURFACE_N)),
    );
    const p = at(r, d.NORMAL1);
    const t = at(r, d.TANGENT);
    const roll = at(r, d.ROLL);
    const idle = i64x2.bitmask(f64x2.eq(v128.or(v128.or(p, t), roll), zero));
    const jx = f64x2.sub(f64x2.mul(nx, p), f64x2.mul(ny, t));
    const jy = f64x2.add(f64x2.mul(ny, p), f64x2.mul(nx, t));
    const jwA = f64x2.add(f64x2.add(f64x2.mul(rnA, p), f64x2.mul(rtA, t)), roll);
    const jwB = f64x2.add(f64x2.add(f64x2.mul(rnB, p), f64x2.mul(rtB, t)), roll);
    for (let lanes = lanesOf(bodiesOfSecond, k, from, to); lanes !== 0; lanes >>= 2) {
      const busy = lanes & ~idle & 3;
      if (busy === 0) {
        continue;
      }
      let sumP = f64x2.add(at(r, d.NORMAL_SUM1), p);
      let sumT = f64x2.add(at(r, d.TANGENT_SUM), t);
      let sumRoll = f64x2.add(at(r, d.ROLL_SUM), roll);
      if (busy !== 3) {
        const mask = maskOf(busy);
        sumP = pick(mask, sumP, at(r, d.NORMAL_SUM1));
        sumT = pick(mask, sumT, at(r, d.TANGENT_SUM));
        sumRoll = pick(mask, sumRoll, at(r, d.ROLL_SUM));
      }
      put(r, d.NORMAL_SUM1, sumP);
      put(r, d.TANGENT_SUM, sumT);
      put(r, d.ROLL_SUM, sumRoll);
      Bodies.give(velocity + a1, velocity + a2, busy, f64x2.neg(jx), f64x2.neg(jy), f64x2.neg(jwA));
      Bodies.give(velocity + b1, velocity + b2, busy, jx, jy, jwB);
    }
  }
}

/** @returns whether any velocity changed by more than CALM_ACCELERATION · h. */
export function solveVelocityOne(records: usize, bodies: usize, velocity: usize, from: i32, to: i32): bool {
  const zero = f64x2.splat(0);
  const limitOfCalm = f64x2.splat(CALM_ACCELERATION * load<f64>(n.H));
  let changed = 0;
  for (let k = from & d.EVEN; k < to; k += 2) {
    const r = records + <usize>(k >> 1) * RECORDS;
    const pair = bodies + <usize>(k >> 1) * OFFSETS;
    const a1 = velocity + (load<i32>(pair) << 3);
    const b1 = velocity + (load<i32>(pair, 4) << 3);
    const bodiesOfSecond = load<i32>(pair, 8);
    const a2 = velocity + (bodiesOfSecond << 3);
    const b2 = velocity + (load<i32>(pair, 12) << 3);
    for (let lanes = lanesOf(bodiesOfSecond, k, from, to); lanes !== 0; lanes >>= 2) {
      const vax = firstOf(a1, a2, d.VX);
      const vay = secondOf(a1, a2, d.VX);
      const vbx = firstOf(b1, b2, d.VX);
      const vby = secondOf(b1, b2, d.VX);
      const wA = firstOf(a1, a2, d.W);
      const mA = secondOf(a1, a2, d.W);
      const wB = firstOf(b1, b2, d.W);
      const mB = secondOf(b1, b2, d.W);
      const nx = at(r, d.NX);
      const ny = at(r, d.NY);
      const dvx = f64x2.sub(vbx, vax);
      const dvy = f64x2.sub(vby, vay);
      const p = at(r, d.NORMAL1);
      const t = at(r, d.TANGENT);
      const roll = at(r, d.ROLL);
      const rnA = at(r, d.RN_A1);
      const rnB = at(r, d.RN_B1);
      const vn = f64x2.add(
        f64x2.add(f64x2.mul(nx, dvx), f64x2.mul(ny, dvy)),
        f64x2.add(f64x2.sub(f64x2.mul(rnB, wB), f64x2.mul(rnA, wA)), at(r, d.BIAS1)),
      );
      let busy = lanes & 3;
      const isBare = i64x2.bitmask(f64x2.eq(v128.or(v128.or(p, t), roll), zero));
      if (isBare & busy) {
        busy &= ~(isBare & i64x2.bitmask(f64x2.ge(vn, zero)));
        if (busy === 0) {
          continue;
        }
      }

      const rtA = at(r, d.RT_A);
      const rtB = at(r, d.RT_B);
      const tangentMass = at(r, d.TANGENT_MASS);
      const rollMass = at(r, d.ROLL_MASS);
      const normalMass = at(r, d.NORMAL_MASS);
      const slide = f64x2.add(
        f64x2.sub(f64x2.mul(nx, dvy), f64x2.mul(ny, dvx)),
        f64x2.add(f64x2.sub(f64x2.mul(rtB, wB), f64x2.mul(rtA, wA)), at(r, d.SURFACE_T)),
      );
      const nextT = within(f64x2.sub(t, f64x2.mul(slide, tangentMass)), f64x2.mul(at(r, d.FRICTION), p));
      const dt = f64x2.sub(nextT, t);
      const rolled = f64x2.sub(roll, f64x2.mul(f64x2.sub(wB, wA), rollMass));
      const nextRoll = within(
        f64x2.sub(rolled, f64x2.mul(at(r, d.ROLL_OF_TANGENT), dt)),
        f64x2.mul(at(r, d.ROLL_FRICTION), p),
      );
      const dr = f64x2.sub(nextRoll, roll);
      let wanted = f64x2.sub(p, f64x2.mul(vn, normalMass));
      wanted = f64x2.sub(wanted, f64x2.mul(at(r, d.NORMAL_OF_TANGENT), dt));
      wanted = f64x2.sub(wanted, f64x2.mul(at(r, d.NORMAL_OF_ROLL), dr));
      const nextP = f64x2.mul(number(n.HALF), f64x2.add(wanted, f64x2.abs(wanted)));
      const dp = f64x2.sub(nextP, p);
      if (busy === 3) {
        put(r, d.TANGENT, nextT);
        put(r, d.ROLL, nextRoll);
        put(r, d.NORMAL1, nextP);
      } else {
        const mask = maskOf(busy);
        put(r, d.TANGENT, pick(mask, nextT, t));
        put(r, d.ROLL, pick(mask, nextRoll, roll));
        put(r, d.NORMAL1, pick(mask, nextP, p));
      }
      if (changed === 0) {
        const isMuch = v128.or(
          v128.or(
            f64x2.gt(f64x2.abs(dp), f64x2.mul(limitOfCalm, normalMass)),
            f64x2.gt(f64x2.abs(dt), f64x2.mul(limitOfCalm, tangentMass)),
          ),
          f64x2.gt(f64x2.abs(dr), f64x2.mul(limitOfCalm, rollMass)),
        );
        changed = i64x2.bitmask(isMuch) & busy;
      }
      const jx = f64x2.sub(f64x2.mul(nx, dp), f64x2.mul(ny, dt));
      const jy = f64x2.add(f64x2.mul(ny, dp), f64x2.mul(nx, dt));
      const jwA = f64x2.add(f64x2.add(f64x2.mul(rtA, dt), dr), f64x2.mul(rnA, dp));
      const jwB = f64x2.add(f64x2.add(f64x2.mul(rtB, dt), dr), f64x2.mul(rnB, dp));
      Bodies.put(
        a1,
        a2,
        busy,
        f64x2.sub(vax, f64x2.mul(mA, jx)),
        f64x2.sub(vay, f64x2.mul(mA, jy)),
        f64x2.sub(wA, f64x2.mul(two(a1, a2, d.INV_INERTIA), jwA)),
        mA,
      );
      Bodies.put(
        b1,
        b2,
        busy,
        f64x2.add(vbx, f64x2.mul(mB, jx)),
        f64x2.add(vby, f64x2.mul(mB, jy)),
        f64x2.add(wB, f64x2.mul(two(b1, b2, d.INV_INERTIA), jwB)),
        mB,
      );
    }
  }
  return changed !== 0;
}

/** Cut to ± limit, as `solveVelocityOne` of the engine cuts it. */
function within(x: v128, limit: v128): v128 {
  const cut = f64x2.mul(number(n.HALF), f64x2.sub(f64x2.abs(f64x2.add(x, limit)), f64x2.abs(f64x2.sub(x, limit))));
  return pick(f64x2.gt(f64x2.abs(x), limit), cut, x);
}

/** As in `pressed.ts`. */
function boundPush(e: f64, c: f64, began: f64): f64 {
  const share = PRESSED_SHARE * began;
  const left = c - began + (share < -PRESSED_PUSH ? share : -PRESSED_PUSH);
  const most = left < 0 ? left : 0;
  return e < most ? most : e;
}

/** As most contacts are passed by, it would take a tenth longer in lanes. @returns bit 0: it changed something; CROWDED, PRESSED. */
export function solvePositionOne(records: usize, bodies: usize, motion: usize, from: i32, to: i32): i32 {
  let found = 0;
  for (let k = from; k < to; k += 1) {
    const r = records + <usize>(k >> 1) * RECORDS + ((k & 1) << 3);
    const pair = bodies + ((<usize>k) << 3);
    const a = motion + ((load<i32>(pair) & d.OFFSET) << 3);
    const b = motion + ((load<i32>(pair, 4) & d.OFFSET) << 3);
    const nx = get(r, d.NX);
    const ny = get(r, d.NY);
    const rnA = get(r, d.RN_A1);
    const rnB = get(r, d.RN_B1);
    const c =
      get(r, d.SEPARATION1) +
      nx * (get(b, d.QX) - get(a, d.QX)) +
      ny * (get(b, d.QY) - get(a, d.QY)) +
      rnB * get(b, d.QW) -
      rnA * get(a, d.QW) +
      CONTACT_SLOP;
    if (c > -PUSH_TOLERANCE) {
      continue;
    }
    found |= 1;
    const signed = get(r, d.SHARE);
    const share = Math.abs(signed);
    const isRound = share === PUSH_SHARE_CIRCLES;
    const deep = c + (isRound ? DEEP_OVERLAP_CIRCLES : DEEP_OVERLAP);
    let e = share * c;
    if (deep < 0 && share !== PUSH_SHARE_STATIC) {
      const isPressed = get(r, d.NORMAL1) !== 0;
      if (isRound && c < -DEEP_OVERLAP) {
        found |= isPressed ? d.PRESSED : d.CROWDED;
      }
      const ofDeep = isRound ? (isPressed ? PUSH_SHARE_DEEP_CIRCLES : PUSH_SHARE_CROWD) : PUSH_SHARE_DEEP;
      e += (ofDeep - share) * deep;
      if (isPressed && signed > 0) {
        e = boundPush(e, c, get(r, d.SEPARATION1) + CONTACT_SLOP);
      }
    }
    const most = share === PUSH_SHARE_HOOKED ? MAX_PUSH_HOOKED : MAX_PUSH;
    const x = (e < -most ? most : -e) * get(r, d.NORMAL_MASS);
    const mA = get(a, d.INV_MASS) * x;
    const mB = get(b, d.INV_MASS) * x;
    const wA = get(a, d.QW) - get(a, d.INV_INERTIA) * rnA * x;
    const normal = f64x2.replace_lane(f64x2.splat(nx), 1, ny);
    put(a, d.QX, f64x2.sub(at(a, d.QX), f64x2.mul(f64x2.splat(mA), normal)));
    set(a, d.QW, wA);
    const wB = get(b, d.QW) + get(b, d.INV_INERTIA) * rnB * x;
    put(b, d.QX, f64x2.add(at(b, d.QX), f64x2.mul(f64x2.splat(mB), normal)));
    set(b, d.QW, wB);
  }
  return found;
}
