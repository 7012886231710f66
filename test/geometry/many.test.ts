import { it } from 'vitest';
import { measure as measurePairs } from './random-pairs.js';
import { measure as measureSweeps } from './random-sweeps.js';
import { expectInTime, expectRight } from './right.js';

// What distance.test.ts and sweep.test.ts do with few random pairs and sweeps, with many, and what the worst of them is.

const PAIRS = 1_000_000;
const SWEEPS = 30_000;
const timeout = 120_000;

it(`the distance of ${PAIRS.toLocaleString('en')} random pairs is that of the references`, { timeout }, () => {
  const measured = measurePairs(PAIRS, 1);
  const { worst, counts } = measured;
  console.log(`distance of ${PAIRS} pairs (${JSON.stringify(counts)}), worst errors over the extent of the pair:`);
  for (const [kind, { error, pair }] of Object.entries(worst)) {
    console.log(`  ${kind.padEnd(12)} ${error.toExponential(1)}  (pair ${pair})`);
  }
  expectRight(measured, PAIRS);
});

it(`${SWEEPS.toLocaleString('en')} random sweeps agree with their distances in between`, { timeout }, () => {
  const measured = measureSweeps(SWEEPS, 1);
  const { worst, counts } = measured;
  console.log(`${SWEEPS} sweeps (${JSON.stringify(counts)}), worst errors over the size where not in s:`);
  for (const [kind, { error, sweep }] of Object.entries(worst)) {
    console.log(`  ${kind.padEnd(26)} ${kind === 'iterations' ? error : error.toExponential(1)}  (sweep ${sweep})`);
  }
  expectInTime(measured, SWEEPS);
});
