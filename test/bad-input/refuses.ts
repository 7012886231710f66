import { describe, expect, it } from 'vitest';

/** A bad value, what it is refused with, and how the message shows it. */
export type Bad = readonly [value: unknown, kind: typeof TypeError | typeof RangeError, shown?: string];

export const NOT_NUMBERS: Bad[] = [
  ['1', TypeError, '"1"'],
  [null, TypeError, 'null'],
  [{}, TypeError, 'an object'],
];
export const NOT_FINITE: Bad[] = [
  ...NOT_NUMBERS,
  [NaN, RangeError, 'NaN'],
  [Infinity, RangeError],
  [-Infinity, RangeError],
];
export const NOT_NON_NEGATIVE: Bad[] = [...NOT_FINITE, [-1, RangeError, '-1']];
export const NOT_POSITIVE: Bad[] = [...NOT_NON_NEGATIVE, [0, RangeError, '0']];
export const NOT_MASS: Bad[] = [...NOT_NUMBERS, [NaN, RangeError], [0, RangeError], [-3, RangeError, '-3']];
export const NOT_COUNT: Bad[] = [
  ...NOT_FINITE,
  [0, RangeError],
  [1.5, RangeError, '1.5'],
  [-1, RangeError],
  [2 ** 32 + 8, RangeError],
];
export const NOT_BITS: Bad[] = [...NOT_FINITE, [0.5, RangeError], [2 ** 32, RangeError], [-(2 ** 31) - 1, RangeError]];
export const NOT_BOOLEAN: Bad[] = [
  [1, TypeError, '1'],
  ['true', TypeError, '"true"'],
  [null, TypeError],
];
export const NOT_VECTOR: Bad[] = [
  [1, TypeError, '1'],
  [null, TypeError],
  [[1], TypeError, 'an array of length 1'],
];

/** Calls with a bad value; the error is of the right kind and its message starts with function and argument and shows the value. */
export function refuses(call: (value: never) => unknown, where: string, name: string, [value, kind, shown]: Bad): void {
  let thrown: unknown;
  try {
    call(value as never);
  } catch (error) {
    thrown = error;
  }
  expect(thrown, `${where} with ${name} = ${String(value)}`).toBeInstanceOf(kind);
  const { message } = thrown as Error;
  expect(message.startsWith(`${where}: ${name} must be `), message).toBe(true);
  expect(message).toContain(`, got ${shown ?? String(value)}`);
}

/** A factory and the values that each of its options refuses. */
export function factory(
  where: string,
  make: (options: never) => unknown,
  valid: object,
  options: Record<string, readonly Bad[]>,
): void {
  describe(where, () => {
    for (const [name, values] of Object.entries(options)) {
      it(`refuses bad ${name}`, () => {
        for (const bad of values) {
          refuses((value) => make({ ...valid, [name]: value } as never), where, name, bad);
        }
      });
      it(`takes an undefined ${name} as left out`, () => {
        if (!(name in valid)) {
          expect(() => make({ ...valid, [name]: undefined } as never)).not.toThrow();
        } else {
          expect(() => make({ ...valid, [name]: undefined } as never)).toThrow(TypeError);
        }
      });
    }
    it('refuses options that are no object', () => {
      for (const value of [1, 'x', null]) {
        refuses(make, where, 'params', [value, TypeError, typeof value === 'string' ? '"x"' : String(value)]);
      }
    });
  });
}
