import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, it } from 'vitest';
import { run } from './golden-run.js';

// The start of each golden scene in the process of the tests, where coverage and mutations see it; engines.test.ts has all of it, in every engine.

const STEPS = 100;
const golden = JSON.parse(readFileSync(join(import.meta.dirname, 'golden.json'), 'utf8')) as Record<string, string[]>;

it.each(Object.entries(golden))(`the hashes of the first ${STEPS} steps of %s are golden`, (name, hashes) => {
  const found = run(name, STEPS);
  expect(found).toHaveLength(STEPS / 10);
  expect(found).toEqual(hashes.slice(0, found.length));
});
