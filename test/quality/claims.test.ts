import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { describe, expect, it } from 'vitest';
import type * as source from '../../src/index.js';
import * as claims from './claims/index.js';
import { isMissed, type Measured, measure, tableOf } from './figures.js';

// Every claim of the quality suite, from the bundle as built: unbundled, this takes minutes.

const { phys2D } = (await import(
  /* @vite-ignore */ pathToFileURL(join(import.meta.dirname, '../../dist/phys2d.js')).href
)) as typeof source;

/** Not yet met: more sweeps would meet them, and cost half as much again in large nets; the discs come apart, but not within 2 s. */
const MISSED = ['confinedDiscs: overlap after 2 s'];

describe('quality', { timeout: 300_000 }, () => {
  const all: Measured[] = [];

  for (const [name, claim] of Object.entries(claims)) {
    it(`${name}: ${claim.scene}`, () => {
      const figures = measure({ [name]: claim }, phys2D);
      all.push(...figures);
      for (const { what, value, unit, limit } of figures) {
        console.log(
          `${name}: ${what} ${value.toPrecision(4)} ${unit}${limit === undefined ? '' : ` (target ${limit})`}`,
        );
      }
      const missed = figures.filter(isMissed).map(({ what }) => `${name}: ${what}`);
      expect(missed).toEqual(MISSED.filter((what) => what.startsWith(`${name}:`)));
    });
  }

  it('the committed table is what was measured', () => {
    expect(tableOf(all)).toBe(readFileSync(join(import.meta.dirname, 'FIGURES.md'), 'utf8'));
  });
});
