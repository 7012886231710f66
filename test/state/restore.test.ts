import { describe, expect, it } from 'vitest';
import { generator } from '../scenes/mixed.js';
import { GAMES } from '../scenes/states.js';
import { phys2D } from './built.js';

const MOMENTS = 50;
const STEPS = 300;
/** Steps from one comparison to the next. */
const EVERY = 10;

describe.each(Object.entries(GAMES))('%s', (_, build) => {
  it(`goes on to the bit for ${STEPS} steps after restores at ${MOMENTS} random moments`, () => {
    const game = build(phys2D);
    const random = generator(77);
    const moments = new Set(Array.from({ length: MOMENTS }, () => Math.floor(600 * random())));
    const hashes: string[] = [];
    const snapshots: [number, ArrayBuffer][] = [];
    for (let i = 0; i <= 600 + STEPS; i += 1) {
      if (moments.has(i)) {
        snapshots.push([i, game.world.snapshot()]);
      }
      hashes[i] = game.world.hash();
      game.step();
    }
    for (const [moment, snapshot] of snapshots) {
      game.world.restore(snapshot);
      for (let i = moment; i < moment + STEPS; i += 1) {
        if ((i - moment) % EVERY === 0) {
          expect(game.world.hash(), `step ${i} of the run from ${moment}`).toBe(hashes[i]);
        }
        game.step();
      }
      expect(game.world.hash(), `the end of the run from ${moment}`).toBe(hashes[moment + STEPS]);
    }
  }, 300_000);
});
