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
      expect(figures.filter(isMissed).map(({ what }) => what)).toEqual([]);
    });
  }

  it('the committed table is what was measured', () => {
    expect(tableOf(all)).toBe(readFileSync(join(import.meta.dirname, 'FIGURES.md'), 'utf8'));
  });
});
