// Contacts of two points, two at a time: what `src/solver/contacts/two-point.ts` does, operation by operation, so that the results are the same to the bit.
import { CALM_ACCELERATION } from '../src/config';
import * as d from '../src/solver/layout';
import * as n from './lanes';
import { at, Bodies, firstOf, lanesOf, maskOf, number, OFFSETS, pick, put, secondOf, two } from './lanes';

/** Bytes of two records. */
const RECORDS: usize = 16 * d.TWO_STRIDE;

export function warmStartTwo(records: usize, bodies: usize, velocity: usize, motion: usize, from: i32, to: i32): void {
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
    const rnA1 = at(r, d.RN_A1);
    const rnB1 = at(r, d.RN_B1);
    const rnA2 = at(r, d.RN_A2);
    const rnB2 = at(r, d.RN_B2);
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
    const moved = f64x2.sub(
      f64x2.add(f64x2.add(f64x2.mul(nx, dx), f64x2.mul(ny, dy)), f64x2.mul(cosB, rtB)),
      f64x2.mul(cosA, rtA),
    );
    const s1 = f64x2.sub(f64x2.add(f64x2.add(at(r, d.START1), moved), f64x2.mul(sinB, rnB1)), f64x2.mul(sinA, rnA1));
    const s2 = f64x2.sub(f64x2.add(f64x2.add(at(r, d.START2), moved), f64x2.mul(sinB, rnB2)), f64x2.mul(sinA, rnA2));
    const surface = at(r, d.SURFACE_N);
    const gap1 = f64x2.add(s1, number(n.DEPTH));
    const gap2 = f64x2.add(s2, number(n.DEPTH));
    // All that the velocities have no say in may be done for both at once, and twice.
    put(r, d.SEPARATION1, s1);
    put(r, d.SEPARATION2, s2);
    put(
      r,
      d.BIAS1,
      f64x2.add(f64x2.mul(f64x2.mul(number(n.HALF), f64x2.add(gap1, f64x2.abs(gap1))), inverseH), surface),
    );
    put(
      r,
      d.BIAS2,
      f64x2.add(f64x2.mul(f64x2.mul(number(n.HALF), f64x2.add(gap2, f64x2.abs(gap2))), inverseH), surface),
    );
    const p1 = at(r, d.NORMAL1);
    const p2 = at(r, d.NORMAL2);
    const t = at(r, d.TANGENT);
    const idle = i64x2.bitmask(f64x2.eq(v128.or(v128.or(p1, p2), t), zero));
    const p = f64x2.add(p1, p2);
    const jx = f64x2.sub(f64x2.mul(nx, p), f64x2.mul(ny, t));
    const jy = f64x2.add(f64x2.mul(ny, p), f64x2.mul(nx, t));
    const jwA = f64x2.add(f64x2.add(f64x2.mul(rnA1, p1), f64x2.mul(rnA2, p2)), f64x2.mul(rtA, t));
    const jwB = f64x2.add(f64x2.add(f64x2.mul(rnB1, p1), f64x2.mul(rnB2, p2)), f64x2.mul(rtB, t));
    for (let lanes = lanesOf(bodiesOfSecond, k, from, to); lanes !== 0; lanes >>= 2) {
      const busy = lanes & ~idle & 3;
      if (busy === 0) {
        continue;
      }
      let sum1 = f64x2.add(at(r, d.NORMAL_SUM1), p1);
      let sum2 = f64x2.add(at(r, d.NORMAL_SUM2), p2);
      let sumT = f64x2.add(at(r, d.TANGENT_SUM), t);
      if (busy !== 3) {
        const mask = maskOf(busy);
        sum1 = pick(mask, sum1, at(r, d.NORMAL_SUM1));
        sum2 = pick(mask, sum2, at(r, d.NORMAL_SUM2));
        sumT = pick(mask, sumT, at(r, d.TANGENT_SUM));
      }
      put(r, d.NORMAL_SUM1, sum1);
      put(r, d.NORMAL_SUM2, sum2);
      put(r, d.TANGENT_SUM, sumT);
      Bodies.give(velocity + a1, velocity + a2, busy, f64x2.neg(jx), f64x2.neg(jy), f64x2.neg(jwA));
      Bodies.give(velocity + b1, velocity + b2, busy, jx, jy, jwB);
    }
  }
}

/** @returns whether any velocity changed by more than CALM_ACCELERATION · h. */
export function solveVelocityTwo(records: usize, bodies: usize, velocity: usize, from: i32, to: i32): bool {
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
      let wA = firstOf(a1, a2, d.W);
      const mA = secondOf(a1, a2, d.W);
      let wB = firstOf(b1, b2, d.W);
      const mB = secondOf(b1, b2, d.W);
      const nx = at(r, d.NX);
      const ny = at(r, d.NY);
      const dvx = f64x2.sub(vbx, vax);
      const dvy = f64x2.sub(vby, vay);
      const vn = f64x2.add(f64x2.mul(nx, dvx), f64x2.mul(ny, dvy));
      const p1 = at(r, d.NORMAL1);
      const p2 = at(r, d.NORMAL2);
      const before = at(r, d.TANGENT);
      let busy = lanes & 3;
      const isBare = i64x2.bitmask(f64x2.eq(v128.or(v128.or(p1, p2), before), zero));
      if (isBare & busy) {
        const c1 = along(r, vn, wA, wB, 0);
        const c2 = along(r, vn, wA, wB, d.SECOND);
        busy &= ~(isBare & i64x2.bitmask(v128.and(f64x2.ge(c1, zero), f64x2.ge(c2, zero))));
        if (busy === 0) {
          continue;
        }
      }

      const iA = two(a1, a2, d.INV_INERTIA);
      const iB = two(b1, b2, d.INV_INERTIA);
      const rtA = at(r, d.RT_A);
      const rtB = at(r, d.RT_B);
      const tangentMass = at(r, d.TANGENT_MASS);
      const limit = f64x2.mul(at(r, d.FRICTION), f64x2.add(p1, p2));
      const slide = f64x2.sub(
        f64x2.add(f64x2.add(f64x2.sub(f64x2.mul(nx, dvy), f64x2.mul(ny, dvx)), at(r, d.SURFACE_T)), f64x2.mul(rtB, wB)),
        f64x2.mul(rtA, wA),
      );
      let after = f64x2.sub(before, f64x2.mul(slide, tangentMass));
      after = f64x2.pmin(f64x2.pmax(after, f64x2.neg(limit)), limit);
      const t = f64x2.sub(after, before);
      wA = f64x2.sub(wA, f64x2.mul(f64x2.mul(iA, rtA), t));
      wB = f64x2.add(wB, f64x2.mul(f64x2.mul(iB, rtB), t));

      const c1 = along(r, vn, wA, wB, 0);
      const c2 = along(r, vn, wA, wB, d.SECOND);
      const i12 = at(r, d.I12);
      const k11 = at(r, d.K11);
      const k22 = at(r, d.K22);
      let x1 = f64x2.sub(p1, f64x2.add(f64x2.mul(at(r, d.I11), c1), f64x2.mul(i12, c2)));
      let x2 = f64x2.sub(p2, f64x2.add(f64x2.mul(i12, c1), f64x2.mul(at(r, d.I22), c2)));
      const both = v128.and(f64x2.ge(x1, zero), f64x2.ge(x2, zero));
      if (busy & ~i64x2.bitmask(both)) {
        const k12 = at(r, d.K12);
        const e1 = f64x2.sub(f64x2.sub(c1, f64x2.mul(k11, p1)), f64x2.mul(k12, p2));
        const e2 = f64x2.sub(f64x2.sub(c2, f64x2.mul(k12, p1)), f64x2.mul(k22, p2));
        const y1 = f64x2.div(f64x2.neg(e1), k11);
        const y2 = f64x2.div(f64x2.neg(e2), k22);
        const only1 = v128.and(f64x2.ge(y1, zero), f64x2.ge(f64x2.add(f64x2.mul(k12, y1), e2), zero));
        const only2 = v128.and(f64x2.ge(y2, zero), f64x2.ge(f64x2.add(f64x2.mul(k12, y2), e1), zero));
        const none = v128.and(f64x2.ge(e1, zero), f64x2.ge(e2, zero));
        x1 = pick(both, x1, pick(only1, y1, pick(v128.or(only2, none), zero, f64x2.pmax(zero, x1))));
        x2 = pick(both, x2, pick(only1, zero, pick(only2, y2, pick(none, zero, f64x2.pmax(zero, x2)))));
      }
      if (busy !== 3) {
        const mask = maskOf(busy);
        after = pick(mask, after, before);
        x1 = pick(mask, x1, p1);
        x2 = pick(mask, x2, p2);
      }
      put(r, d.TANGENT, after);
      put(r, d.NORMAL1, x1);
      put(r, d.NORMAL2, x2);
      const d1 = f64x2.sub(x1, p1);
      const d2 = f64x2.sub(x2, p2);
      if (changed === 0) {
        const isMuch = v128.or(
          v128.or(
            f64x2.gt(f64x2.mul(f64x2.abs(d1), k11), limitOfCalm),
            f64x2.gt(f64x2.mul(f64x2.abs(d2), k22), limitOfCalm),
          ),
          f64x2.gt(f64x2.abs(t), f64x2.mul(limitOfCalm, tangentMass)),
        );
        changed = i64x2.bitmask(isMuch) & busy;
      }
      const p = f64x2.add(d1, d2);
      const jx = f64x2.sub(f64x2.mul(nx, p), f64x2.mul(ny, t));
      const jy = f64x2.add(f64x2.mul(ny, p), f64x2.mul(nx, t));
      wA = f64x2.sub(wA, f64x2.mul(iA, f64x2.add(f64x2.mul(at(r, d.RN_A1), d1), f64x2.mul(at(r, d.RN_A2), d2))));
      wB = f64x2.add(wB, f64x2.mul(iB, f64x2.add(f64x2.mul(at(r, d.RN_B1), d1), f64x2.mul(at(r, d.RN_B2), d2))));
      Bodies.put(a1, a2, busy, f64x2.sub(vax, f64x2.mul(mA, jx)), f64x2.sub(vay, f64x2.mul(mA, jy)), wA, mA);
      Bodies.put(b1, b2, busy, f64x2.add(vbx, f64x2.mul(mB, jx)), f64x2.add(vby, f64x2.mul(mB, jy)), wB, mB);
    }
  }
  return changed !== 0;
}

/** @returns whether anything was pushed. */
export function solvePositionTwo(records: usize, bodies: usize, motion: usize, from: i32, to: i32): bool {
  const zero = f64x2.splat(0);
  let pushed = false;
  for (let k = from & d.EVEN; k < to; k += 2) {
    const r = records + <usize>(k >> 1) * RECORDS;
    const pair = bodies + <usize>(k >> 1) * OFFSETS;
    const a1 = motion + (load<i32>(pair) << 3);
    const b1 = motion + (load<i32>(pair, 4) << 3);
    const bodiesOfSecond = load<i32>(pair, 8);
    const a2 = motion + (bodiesOfSecond << 3);
    const b2 = motion + (load<i32>(pair, 12) << 3);
    for (let lanes = lanesOf(bodiesOfSecond, k, from, to); lanes !== 0; lanes >>= 2) {
      const qax = firstOf(a1, a2, d.QX);
      const qay = secondOf(a1, a2, d.QX);
      const qbx = firstOf(b1, b2, d.QX);
      const qby = secondOf(b1, b2, d.QX);
      const qaw = firstOf(a1, a2, d.QW);
      const invMassA = secondOf(a1, a2, d.QW);
      const qbw = firstOf(b1, b2, d.QW);
      const invMassB = secondOf(b1, b2, d.QW);
      const nx = at(r, d.NX);
      const ny = at(r, d.NY);
      const rnA1 = at(r, d.RN_A1);
      const rnB1 = at(r, d.RN_B1);
      const rnA2 = at(r, d.RN_A2);
      const rnB2 = at(r, d.RN_B2);
      const moved = f64x2.add(
        f64x2.add(f64x2.mul(nx, f64x2.sub(qbx, qax)), f64x2.mul(ny, f64x2.sub(qby, qay))),
        number(n.SLOP),
      );
      const c1 = f64x2.sub(
        f64x2.add(f64x2.add(at(r, d.SEPARATION1), moved), f64x2.mul(rnB1, qbw)),
        f64x2.mul(rnA1, qaw),
      );
      const c2 = f64x2.sub(
        f64x2.add(f64x2.add(at(r, d.SEPARATION2), moved), f64x2.mul(rnB2, qbw)),
        f64x2.mul(rnA2, qaw),
      );
      const idle = i64x2.bitmask(v128.and(f64x2.gt(c1, number(n.TOLERANCE)), f64x2.gt(c2, number(n.TOLERANCE))));
      const busy = lanes & ~idle & 3;
      if (busy === 0) {
        continue;
      }
      pushed = true;
      const signed = at(r, d.SHARE);
      const share = f64x2.abs(signed);
      const least = pick(f64x2.eq(share, number(n.SHARE_HOOKED)), number(n.LEAST_HOOKED), number(n.LEAST));
      const more = f64x2.pmax(zero, f64x2.sub(number(n.SHARE_DEEP), share));
      const isPressed = v128.and(f64x2.ne(v128.or(at(r, d.NORMAL1), at(r, d.NORMAL2)), zero), f64x2.gt(signed, zero));
      let s1 = f64x2.add(f64x2.mul(share, c1), f64x2.mul(more, f64x2.pmin(zero, f64x2.add(c1, number(n.DEEP)))));
      let s2 = f64x2.add(f64x2.mul(share, c2), f64x2.mul(more, f64x2.pmin(zero, f64x2.add(c2, number(n.DEEP)))));
      s1 = boundPush(r, s1, c1, isPressed, 0);
      s2 = boundPush(r, s2, c2, isPressed, d.SECOND);
      const e1 = pick(f64x2.lt(s1, least), least, pick(f64x2.lt(c1, zero), s1, c1));
      const e2 = pick(f64x2.lt(s2, least), least, pick(f64x2.lt(c2, zero), s2, c2));
      const i12 = at(r, d.I12);
      let x1 = f64x2.neg(f64x2.add(f64x2.mul(at(r, d.I11), e1), f64x2.mul(i12, e2)));
      let x2 = f64x2.neg(f64x2.add(f64x2.mul(i12, e1), f64x2.mul(at(r, d.I22), e2)));
      const pulls = v128.or(f64x2.lt(x1, zero), f64x2.lt(x2, zero));
      if (busy & i64x2.bitmask(pulls)) {
        const isFirst = f64x2.lt(c1, c2);
        x1 = pick(pulls, pick(isFirst, f64x2.div(f64x2.neg(e1), at(r, d.K11)), zero), x1);
        x2 = pick(pulls, pick(isFirst, zero, f64x2.div(f64x2.neg(e2), at(r, d.K22))), x2);
      }
      const sum = f64x2.add(x1, x2);
      const mA = f64x2.mul(invMassA, sum);
      const mB = f64x2.mul(invMassB, sum);
      const jwA = f64x2.add(f64x2.mul(rnA1, x1), f64x2.mul(rnA2, x2));
      const jwB = f64x2.add(f64x2.mul(rnB1, x1), f64x2.mul(rnB2, x2));
      Bodies.put(
        a1,
        a2,
        busy,
        f64x2.sub(qax, f64x2.mul(mA, nx)),
        f64x2.sub(qay, f64x2.mul(mA, ny)),
        f64x2.sub(qaw, f64x2.mul(two(a1, a2, d.INV_INERTIA), jwA)),
        invMassA,
      );
      Bodies.put(
        b1,
        b2,
        busy,
        f64x2.add(qbx, f64x2.mul(mB, nx)),
        f64x2.add(qby, f64x2.mul(mB, ny)),
        f64x2.add(qbw, f64x2.mul(two(b1, b2, d.INV_INERTIA), jwB)),
        invMassB,
      );
    }
  }
  return pushed;
}

/** As in `pressed.ts`, of both contacts: of those that are pressed. */
function boundPush(r: usize, s: v128, c: v128, isPressed: v128, shift: i32): v128 {
  const began = f64x2.add(at(r, d.SEPARATION1 + shift), number(n.SLOP));
  const most = f64x2.pmin(number(n.PUSH), f64x2.mul(number(n.SHARE_PRESSED), began));
  const left = f64x2.add(f64x2.sub(c, began), most);
  return pick(isPressed, f64x2.pmax(s, f64x2.pmin(f64x2.splat(0), left)), s);
}

/** The normal velocity of a point, with its bias. */
function along(r: usize, vn: v128, wA: v128, wB: v128, shift: i32): v128 {
  const turning = f64x2.add(vn, f64x2.mul(at(r, d.RN_B1 + shift), wB));
  return f64x2.add(f64x2.sub(turning, f64x2.mul(at(r, d.RN_A1 + shift), wA)), at(r, d.BIAS1 + shift));
}
