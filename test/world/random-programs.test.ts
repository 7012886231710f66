import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type * as audit from '../../src/audit/index.js';
import type * as source from '../../src/index.js';
import { OPERATIONS, type Operation, Program } from './program.js';

// Random programs: anything may be called at any time, also from handlers. From the bundle as built, which is ten times as fast.

const PROGRAMS = 2000;
const LENGTH = 100;
/** How many of the numbers for operations stand for a step. */
const STEPS = 24;
/** ms. Ends the search for a shorter program that fails too. */
const TIME_LIMIT = 110_000;

const load = (name: string): Promise<unknown> =>
  import(/* @vite-ignore */ pathToFileURL(join(import.meta.dirname, '../../dist', name)).href);
const { phys2D } = (await load('phys2d.js')) as typeof source;
const { validate } = (await load('validate.js')) as typeof audit;

const operation: fc.Arbitrary<Operation> = fc.record({
  op: fc.nat(OPERATIONS + STEPS - 1),
  who: fc.nat(1000),
  later: fc.boolean(),
  seed: fc.nat(2 ** 31 - 1),
});

describe('random programs', () => {
  it(
    `${PROGRAMS} of ${LENGTH} operations from handlers and outside`,
    () => {
      fc.assert(
        fc.property(
          fc.nat(1000),
          fc.array(operation, { minLength: LENGTH, maxLength: LENGTH, size: 'max' }),
          (seed, operations) => new Program(phys2D, validate, seed).run(operations),
        ),
        { numRuns: PROGRAMS, seed: 1, interruptAfterTimeLimit: TIME_LIMIT, markInterruptAsFailure: true },
      );
    },
    2 * TIME_LIMIT,
  );

  it('knows all its operations', () => {
    expect(new Program(phys2D, validate, 1).count).toBe(OPERATIONS);
  });
});
