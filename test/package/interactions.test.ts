import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import { expect, it } from 'vitest';

// The examples of interactions, as a user's programs: what they print tells whether they work.

function run(name: string): string[] {
  const file = join(import.meta.dirname, `../../dist/examples/${name}.js`);
  return execFileSync(process.execPath, [file], { encoding: 'utf8' }).trimEnd().split('\n');
}

/** All numbers of a line. */
function numbers(line: string): number[] {
  return [...line.matchAll(/-?\d+(?:\.\d+)?/g)].map(([text]) => Number(text));
}

it('one-way platform: jumped through from below, stood on, dropped through', () => {
  const lines = run('one-way-platform');
  expect(lines).toHaveLength(4);
  const heights = lines.map(numbers);
  for (const [i, wanted] of [0, -2, null, 0].entries()) {
    for (const height of heights[i]!) {
      if (wanted === null) {
        expect(height).toBeGreaterThan(-1.9);
      } else {
        expect(height).toBeCloseTo(wanted, 1);
      }
    }
  }
});

it('conveyor belt: carries crates at its speed, and wakes one when it is reversed', () => {
  const [onBelt, inBin, stopped, reversed] = run('conveyor-belt');
  expect(numbers(onBelt!)).toEqual([1.5, 1.5, 1.5]);
  for (const [i, value] of numbers(inBin!).entries()) {
    // On its floor, or on others: flat on top of one a crate would be at 2.25.
    expect(value).toBeGreaterThan(i % 2 === 0 ? 6.4 : 2.2);
    expect(value).toBeLessThan(i % 2 === 0 ? 9.6 : 3);
  }
  expect(stopped).toMatch(/asleep$/);
  expect(numbers(reversed!)[0]! - numbers(stopped!)[0]!).toBeGreaterThan(2);
  expect(numbers(reversed!)[2]).toBe(1.5);
});

it('spikes: each fall on them costs one life, harder landings cost more health', () => {
  const lines = run('spikes');
  const health = lines.filter((line) => line.includes('landed')).map((line) => numbers(line)[2]!);
  expect(health).toHaveLength(3);
  expect(health[0]).toBe(100);
  expect(100 - health[1]!).toBeGreaterThan(10);
  expect(health[1]! - health[2]!).toBeGreaterThan(100 - health[1]!);
  expect(lines.filter((line) => line.endsWith('dead'))).toHaveLength(2);
  expect(lines.filter((line) => line.endsWith('health 100, 4 bodies'))).toHaveLength(2);
});

it('pickup: the player takes each coin once, enemies take none, the checkpoint tells who passes', () => {
  expect(run('pickup')).toEqual([
    'the enemy reaches the checkpoint',
    'the enemy leaves the checkpoint',
    'the enemy walked to x = 13.0: 0 coins',
    'the player reaches the checkpoint',
    'the player leaves the checkpoint',
    'the player walked to x = 13.0: 5 coins',
  ]);
});
