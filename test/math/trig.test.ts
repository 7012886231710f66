import { describe, expect, it } from 'vitest';
import { atan2, cos, cosSin, pow, sin } from '../../src/math/trig.js';
import { generator } from '../scenes/mixed.js';
import { exact, exactAtan, exactCos, exactPow, exactSin, PI, relativeError } from './exact.js';

// Against integer arithmetic of 320 bits. The engine needs 1e-15 over the range it uses; the bounds here are those that trig.ts
// states, tighter, since an error in a last table digit or the loss of a tail stays below 1e-15.

const SIN_BOUND = 2.4e-16;
const ATAN_BOUND = 4.5e-16;
const POW_BOUND = 2e-16;

/** 1 in the units of the reference. */
const ONE = exact(1);

/** The largest relative error over some arguments; printed, so that drift shows. */
function worst<A>(name: string, cases: readonly A[], error: (argument: A) => number): number {
  let most = 0;
  let at: A | undefined;
  for (const argument of cases) {
    const e = error(argument);
    if (!(e <= most)) {
      most = e;
      at = argument;
    }
  }
  console.log(`${name}: worst relative error ${most.toExponential(2)} at ${String(at)}, ${cases.length} arguments`);
  return most;
}

/** x · 2^k, k even; exact while the result is normal. */
const scaled = (x: number, k: number): number => x * 2 ** (k / 2) * 2 ** (k / 2);

/** The double nearest to k · π/2: both conversions of a BigInt to a double round to the nearest. */
const nearest = (k: number): number => Number((BigInt(k) * PI) / 2n) / Number(ONE);

/** All over the range, with integers, powers of two, and numbers down to 1e-30. */
function angles(): number[] {
  const random = generator(1);
  const list: number[] = [];
  for (let i = 0; i < 1500; i += 1) {
    list.push(20 * random() - 10, 2e6 * random() - 1e6, 10 ** (20 * random() - 16), 10 ** (-30 * random()));
    list.push(i, 1 + Math.floor(100_000 * random()));
  }
  for (let e = -100; e < 20; e += 1) {
    list.push(2 ** e, -(2 ** e));
  }
  return list.filter((x) => Math.abs(x) <= 1e6);
}

/** The doubles nearest to the multiples of π/2: all of them up to 1e5, a sample and the two worst of all up to 1e6 beyond. */
function nearMultiples(): number[] {
  const list = [413441.44719405076, 826882.8943881015];
  for (let k = 1; nearest(k) <= 1e6; k += k < 100_000 ? 1 : 101) {
    list.push(nearest(k));
  }
  return list;
}

/** Angles whose quotient by π/2 is computed as an integer and a half: which way that rounds must not depend on the sign. */
function halfway(): number[] {
  const list: number[] = [];
  for (let k = 1; k < 200_000; k += k < 5000 ? 2 : 98) {
    list.push(nearest(k) / 2);
  }
  return list.filter((x) => (x * (2 / Math.PI)) % 1 === 0.5);
}

const sinError = (x: number): number => relativeError(sin(x), exactSin(exact(x)));
const cosError = (x: number): number => relativeError(cos(x), exactCos(exact(x)));

describe('sine and cosine', () => {
  it('are right to the last digit but one', () => {
    expect(worst('sin', angles(), sinError)).toBeLessThan(SIN_BOUND);
    expect(worst('cos', angles(), cosError)).toBeLessThan(SIN_BOUND);
  });

  it('are right to the last digit but one next to the multiples of π/2', () => {
    expect(worst('sin near k·π/2', nearMultiples(), sinError)).toBeLessThan(SIN_BOUND);
    expect(worst('cos near k·π/2', nearMultiples(), cosError)).toBeLessThan(SIN_BOUND);
  });

  it('of a tiny or subnormal angle are the angle and one', () => {
    // x − x³/6 is nearer to x than half of its last digit from 2^−27 downward.
    for (let x = 2 ** -27; x > 0; x /= 3) {
      expect([sin(x), sin(-x), cos(x)]).toEqual([x, -x, 1]);
    }
    expect([sin(5e-324), sin(-5e-324), cos(5e-324)]).toEqual([5e-324, -5e-324, 1]);
  });

  it('are odd and even, between two multiples of π/2 too, and exact at zero', () => {
    const ties = halfway();
    expect(ties.length).toBeGreaterThan(1000);
    expect(ties).toContain(Math.PI / 4);
    const broken = [...ties, ...angles()].filter((x) => !Object.is(sin(-x), -sin(x)) || cos(-x) !== cos(x));
    expect(broken).toEqual([]);
    expect([sin(0), sin(-0), cos(0), cos(-0)]).toEqual([0, -0, 1, 1]);
  });

  it('come together as they come alone', () => {
    const turn = new Float64Array(3);
    const differing = [...angles(), ...halfway(), -0, 1e7, -1e12, Infinity, NaN].filter((x) => {
      turn[0] = x;
      cosSin(turn);
      return !Object.is(turn[1], cos(x)) || !Object.is(turn[2], sin(x));
    });
    expect(differing).toEqual([]);
  });

  it('of a huge angle are those of the rest by 2π as a double', () => {
    const random = generator(4);
    const huge = [1e7, -1e12, 1e300, Number.MAX_VALUE];
    for (let i = 0; i < 500; i += 1) {
      huge.push((random() - 0.5) * 10 ** (6.5 + 300 * random()));
    }
    const cases = huge.filter((x) => Math.abs(x) > 1e6);
    const rest = (x: number): bigint => exact(x % (2 * Math.PI));
    const sines = worst('sin of huge', cases, (x) => relativeError(sin(x), exactSin(rest(x))));
    const cosines = worst('cos of huge', cases, (x) => relativeError(cos(x), exactCos(rest(x))));
    expect(Math.max(sines, cosines)).toBeLessThan(SIN_BOUND);
  });

  it('refuse what is no angle', () => {
    for (const x of [NaN, Infinity, -Infinity]) {
      expect([sin(x), cos(x)]).toEqual([NaN, NaN]);
    }
  });
});

/** Error of atan2 at (y, x); the reference takes both times 2^lift, which leaves the angle. */
function atan2Error(y: number, x: number, lift: number): number {
  const acute = exactAtan(exact(scaled(Math.abs(y), lift)), exact(scaled(Math.abs(x), lift)));
  const upper = x < 0 ? PI - acute : acute;
  return relativeError(atan2(y, x), y < 0 ? -upper : upper);
}

describe('arc tangent', () => {
  it('is right to the last digit but one in all quadrants', () => {
    const random = generator(2);
    const cases: [number, number][] = [];
    for (let i = 0; i < 2000; i += 1) {
      cases.push([2 * random() - 1, 2 * random() - 1], [(random() - 0.5) * 10 ** (12 * random() - 6), random() - 0.5]);
      cases.push([(i + 1) / 16, i % 40 === 0 ? -1 : 1], [random() - 0.5, (random() - 0.5) * 10 ** (-40 * random())]);
      // Next to where the table entry changes.
      const x = random();
      cases.push([x * (((i % 9) + 0.5) / 8) * (1 + (random() - 0.5) * 1e-12), x]);
    }
    expect(worst('atan2', cases, ([y, x]) => atan2Error(y, x, 0))).toBeLessThan(ATAN_BOUND);
  });

  it('is right to the last digit but one for huge and for subnormal coordinates', () => {
    const random = generator(5);
    const cases: [number, number, number][] = [];
    for (let i = 0; i < 1000; i += 1) {
      const [y, x] = [2 * random() - 1, 2 * random() - 1];
      for (const k of [1022, 996, 700, -700, -964, -1030]) {
        cases.push([scaled(y, k), scaled(x, k), -k]);
      }
      cases.push([scaled(y, -1040), scaled(x, -966), 1000]);
    }
    const subnormal = cases.filter(([y]) => Math.abs(y) < 2.2250738585072014e-308);
    expect(subnormal.length).toBeGreaterThan(1000);
    expect(worst('atan2, extreme', cases, ([y, x, lift]) => atan2Error(y, x, lift))).toBeLessThan(ATAN_BOUND);
  });

  it('has the signs of zero and infinity that ECMAScript prescribes', () => {
    const pi = Math.PI;
    const inf = Infinity;
    // y, x, angle: ECMAScript 2022, 21.3.2.8; with −y, minus the angle.
    const table: [number, number, number][] = [
      [0, 1, 0],
      [0, 0, 0],
      [0, -0, pi],
      [0, -1, pi],
      [0, inf, 0],
      [0, -inf, pi],
      [1, 0, pi / 2],
      [1, -0, pi / 2],
      [1, inf, 0],
      [1, -inf, pi],
      [1, 1, pi / 4],
      [1, -1, (3 * pi) / 4],
      [inf, 1, pi / 2],
      [inf, -1, pi / 2],
      [inf, 0, pi / 2],
      [inf, -0, pi / 2],
      [inf, inf, pi / 4],
      [inf, -inf, (3 * pi) / 4],
    ];
    for (const [y, x, angle] of table) {
      expect(atan2(y, x), `atan2(${y}, ${x})`).toBe(angle);
      expect(atan2(-y, x), `atan2(${-y}, ${x})`).toBe(-angle);
    }
    for (const x of [0, -0, 1, inf, -inf, NaN]) {
      expect([atan2(NaN, x), atan2(x, NaN)]).toEqual([NaN, NaN]);
    }
  });

  it('does not overflow or underflow on the way', () => {
    expect(atan2(1e308, 1e308)).toBe(Math.PI / 4);
    expect(atan2(5e-324, 5e-324)).toBe(Math.PI / 4);
    expect([atan2(5e-324, 1), atan2(5e-324, -1), atan2(1, 5e-324)]).toEqual([5e-324, Math.PI, Math.PI / 2]);
    expect([atan2(1e-308, 1e308), atan2(1e-308, -1e308)]).toEqual([0, Math.PI]);
  });
});

/** base^exponent for any base > 0: one below the units of the reference is lifted by powers of 2^200 first. */
function truePower(base: number, exponent: number): bigint {
  let lifted = base;
  let lifts = 0;
  while (lifted < 2 ** -100) {
    lifted *= 2 ** 200;
    lifts += 1;
  }
  let power = exactPow(lifted, exponent);
  for (; lifts > 0; lifts -= 1) {
    power = (power * ONE) / exactPow(2 ** 200, exponent);
  }
  return power;
}

const powError = ([base, exponent]: readonly [number, number]): number =>
  relativeError(pow(base, exponent), truePower(base, exponent));

describe('power', () => {
  it('is right to the last digit but one over the range of drag factors', () => {
    const random = generator(3);
    const cases: [number, number][] = [];
    for (let i = 0; i < 2000; i += 1) {
      cases.push([random(), random() / 60], [1 - random() * 10 ** (-12 * random()), 10 * random()]);
    }
    const inRange = cases.filter(([base, exponent]) => base > 0 && Math.abs(exponent * Math.log(base)) <= 8);
    expect(worst('pow', inRange, powError)).toBeLessThan(POW_BOUND);
  });

  it('is right to the last digit but one for any base while |exponent · ln base| ≤ 8', () => {
    const random = generator(6);
    const cases: [number, number][] = [];
    for (let i = 0; i < 1000; i += 1) {
      const close = 1 + (random() - 0.5) * 10 ** (-15 * random());
      for (const base of [close, 2 * close, close / 2, 4 * close, 10 ** (600 * random() - 300), random() * 1e-308]) {
        cases.push([base, (16 * random() - 8) / Math.log(base)]);
      }
    }
    const inRange = cases.filter(([base, exponent]) => Math.abs(exponent * Math.log(base)) <= 8);
    expect(inRange.length).toBeGreaterThan(5000);
    expect(worst('pow, any base', inRange, powError)).toBeLessThan(POW_BOUND);
  });

  it('is right to 1e-14 up to the ends of the doubles', () => {
    const random = generator(7);
    const cases: [number, number][] = [];
    for (let i = 0; i < 1500; i += 1) {
      const base = 1.0001 + random() * (i % 2 === 0 ? 1 : 1e6);
      cases.push([base, (8 + 692 * random()) / Math.log(base)]);
    }
    expect(worst('pow, large', cases, powError)).toBeLessThan(1e-14);
    // A small power and the reference, both lifted by 2^1020.
    const smallError = ([base, exponent]: [number, number]): number =>
      relativeError(scaled(pow(base, -exponent), 1020), ((ONE << 1020n) * ONE) / exactPow(base, exponent));
    expect(worst('pow, small', cases, smallError)).toBeLessThan(1e-14);
  });

  it('has exact values where it must', () => {
    expect([pow(0, 2), pow(5, 0), pow(0, 0), pow(1, 1e300), pow(1, -1e308), pow(0.5, 2), pow(10, 3)]).toEqual([
      0, 1, 1, 1, 1, 0.25, 1000,
    ]);
    expect([pow(0, -1), pow(Infinity, 2), pow(Infinity, -2)]).toEqual([Infinity, Infinity, 0]);
    expect([pow(-1, 2), pow(NaN, 1), pow(2, NaN), pow(1, NaN)]).toEqual([NaN, NaN, NaN, NaN]);
    let [up, down] = [1, 1];
    for (let n = 1; n <= 1074; n += 1) {
      up *= 2;
      down /= 2;
      expect([pow(2, n), pow(2, -n)]).toEqual([up, down]);
    }
  });

  it('overflows to infinity and underflows to zero', () => {
    expect([pow(10, 400), pow(10, -400), pow(0.5, 1074)]).toEqual([Infinity, 0, 5e-324]);
    expect([pow(2, 1024), pow(2, -1076), pow(2, 1e308), pow(2, -1e308)]).toEqual([Infinity, 0, Infinity, 0]);
    expect([pow(1 + 2 ** -52, 1e308), pow(1 - 2 ** -53, 1e308)]).toEqual([Infinity, 0]);
  });
});
