import { describe, expect, it } from 'vitest';
import { atan2, cos, cosSin, pow, sin } from '../../src/math/trig.js';
import { generator } from '../scenes/mixed.js';
import { exact, exactAtan, exactCos, exactPow, exactSin, PI, relativeError } from './exact.js';

// Against integer arithmetic of 320 bits; the bound is 1e-15 over the range the engine uses.

const BOUND = 1e-15;

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

function angles(): number[] {
  const random = generator(1);
  const list: number[] = [];
  for (let i = 0; i < 1500; i += 1) {
    list.push(20 * random() - 10, 2e6 * random() - 1e6, 10 ** (20 * random() - 16), i);
  }
  const halfPi = Number((PI * 2n ** 60n) >> 321n) / 2 ** 60;
  for (let k = 1; k < 100_000; k += k < 200 ? 1 : 499) {
    list.push(k * halfPi, -k * halfPi);
  }
  for (let e = -60; e < 20; e += 1) {
    list.push(2 ** e, -(2 ** e));
  }
  return list.filter((x) => Math.abs(x) <= 1e6);
}

describe('sine and cosine', () => {
  it('are right to 1e-15, next to the multiples of π/2 too', () => {
    expect(worst('sin', angles(), (x) => relativeError(sin(x), exactSin(exact(x))))).toBeLessThan(BOUND);
    expect(worst('cos', angles(), (x) => relativeError(cos(x), exactCos(exact(x))))).toBeLessThan(BOUND);
  });

  it('are odd and even, and exact at zero', () => {
    for (const x of angles().slice(0, 500)) {
      expect(sin(-x)).toBe(-sin(x));
      expect(cos(-x)).toBe(cos(x));
    }
    expect([sin(0), sin(-0), cos(0), cos(-0)]).toEqual([0, -0, 1, 1]);
  });

  it('come together as they come alone', () => {
    const turn = new Float64Array(3);
    for (const x of angles()) {
      turn[0] = x;
      cosSin(turn);
      expect([turn[1], turn[2]]).toEqual([cos(x), sin(x)]);
    }
  });

  it('stay within bounds for huge angles, and refuse what is no angle', () => {
    for (const x of [1e7, -1e12, 1e300, Number.MAX_VALUE]) {
      expect(sin(x) ** 2 + cos(x) ** 2).toBeCloseTo(1, 12);
    }
    for (const x of [NaN, Infinity, -Infinity]) {
      expect([sin(x), cos(x)]).toEqual([NaN, NaN]);
    }
  });
});

describe('arc tangent', () => {
  it('is right to 1e-15 in all quadrants', () => {
    const random = generator(2);
    const cases: [number, number][] = [];
    for (let i = 0; i < 2000; i += 1) {
      cases.push([2 * random() - 1, 2 * random() - 1], [(random() - 0.5) * 10 ** (12 * random() - 6), random() - 0.5]);
      cases.push([(i + 1) / 16, i % 40 === 0 ? -1 : 1]);
    }
    const error = ([y, x]: [number, number]): number => {
      const acute = exactAtan(exact(Math.abs(y)), exact(Math.abs(x)));
      const upper = x < 0 ? PI - acute : acute;
      return relativeError(atan2(y, x), y < 0 ? -upper : upper);
    };
    expect(worst('atan2', cases, error)).toBeLessThan(BOUND);
  });

  it('has the signs of zero and infinity that ECMAScript prescribes', () => {
    const special = [0, -0, 1, -1, Infinity, -Infinity, NaN];
    for (const y of special) {
      for (const x of special) {
        const [got, wanted] = [atan2(y, x), Math.atan2(y, x)];
        const equal = Object.is(got, wanted) || (got !== 0 && Math.abs(got - wanted) < 1e-15);
        expect(equal, `atan2(${y}, ${x}) = ${got}, expected ${wanted}`).toBe(true);
      }
    }
  });

  it('does not overflow or underflow on the way', () => {
    expect(atan2(1e308, 1e308)).toBe(Math.PI / 4);
    expect(atan2(5e-324, 5e-324)).toBe(Math.PI / 4);
    expect(atan2(1e-308, 1e308)).toBe(0);
  });
});

describe('power', () => {
  it('is right to 1e-15 over the range of drag factors', () => {
    const random = generator(3);
    const cases: [number, number][] = [];
    for (let i = 0; i < 2000; i += 1) {
      cases.push([random(), random() / 60], [1 - random() * 10 ** (-12 * random()), 10 * random()]);
    }
    const inRange = cases.filter(([base, exponent]) => base > 0 && Math.abs(exponent * Math.log(base)) <= 8);
    const error = ([base, exponent]: [number, number]): number =>
      relativeError(pow(base, exponent), exactPow(base, exponent));
    expect(worst('pow', inRange, error)).toBeLessThan(BOUND);
  });

  it('has exact values where it must', () => {
    expect([pow(0, 2), pow(5, 0), pow(0, 0), pow(1, 1e300), pow(0.5, 2), pow(10, 3)]).toEqual([0, 1, 1, 1, 0.25, 1000]);
    expect([pow(0, -1), pow(Infinity, 2), pow(Infinity, -2)]).toEqual([Infinity, Infinity, 0]);
    expect([pow(-1, 2), pow(NaN, 1), pow(2, NaN)]).toEqual([NaN, NaN, NaN]);
  });

  it('overflows to infinity and underflows to zero', () => {
    expect([pow(10, 400), pow(10, -400), pow(0.5, 1074)]).toEqual([Infinity, 0, 5e-324]);
  });
});
