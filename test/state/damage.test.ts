import { describe, expect, it } from 'vitest';
import { seal } from '../../src/state/format.js';
import { generator } from '../scenes/mixed.js';
import { GAMES } from '../scenes/states.js';
import { phys2D } from './built.js';

describe('damaged snapshots', () => {
  const CASES = 10_000;

  /** A snapshot with something wrong with it. */
  function damaged(snapshot: ArrayBuffer, random: () => number): ArrayBuffer {
    const bytes = new Uint8Array(snapshot);
    const kind = Math.floor(4 * random());
    if (kind === 0) {
      return snapshot.slice(0, Math.floor(bytes.length * random()));
    }
    const copy = snapshot.slice(0);
    if (kind === 1) {
      new Int32Array(copy)[1] = 3 + Math.floor(1000 * random());
      return copy;
    }
    for (let i = kind === 2 ? 1 : 20; i > 0; i -= 1) {
      new Uint8Array(copy)[Math.floor(bytes.length * random())]! ^= 1 << Math.floor(8 * random());
    }
    return copy;
  }

  it(`${CASES} of them are refused, and the world is untouched`, () => {
    const game = GAMES.events!(phys2D);
    for (let i = 0; i < 100; i += 1) {
      game.step();
    }
    const { world } = game;
    const snapshot = world.snapshot();
    const random = generator(5);
    const hash = world.hash();
    const bytes = new Uint8Array(snapshot.slice(0));
    for (let i = 0; i < CASES; i += 1) {
      const wrong = damaged(snapshot, random);
      const isRight = wrong.byteLength === bytes.length && new Uint8Array(wrong).every((byte, k) => byte === bytes[k]);
      if (!isRight) {
        expect(() => world.restore(wrong), `case ${i}`).toThrow(/^World\.restore: (this is no|the) snapshot/);
      }
      if (i % 100 === 0) {
        expect(world.hash()).toBe(hash);
      }
    }
    expect(world.hash()).toBe(hash);
    expect([...new Uint8Array(world.snapshot())]).toEqual([...bytes]);
  }, 120_000);
});

describe('forged snapshots, whose checksum is right', () => {
  it.each(['events', 'constraints', 'drum'])(
    'are refused or taken, but never break the world: %s',
    (name) => {
      const game = GAMES[name]!(phys2D);
      for (let i = 0; i < 120; i += 1) {
        game.step();
      }
      const { world } = game;
      const snapshot = world.snapshot();
      const random = generator(8);
      const hash = world.hash();
      let taken = 0;
      for (let i = 0; i < 1500; i += 1) {
        const forged = snapshot.slice(0);
        for (let k = Math.floor(3 * random()); k >= 0; k -= 1) {
          new Uint8Array(forged)[32 + Math.floor((forged.byteLength - 32) * random())]! ^=
            1 << Math.floor(8 * random());
        }
        seal(forged);
        try {
          world.restore(forged);
          taken += 1;
        } catch (error) {
          expect(String(error), `case ${i}`).toMatch(
            /^(Range|Type)?Error: (World\.restore: the snapshot|createMaterial)/,
          );
        }
        world.snapshot();
        world.restore(snapshot);
        expect(world.hash(), `case ${i}`).toBe(hash);
      }
      expect(taken).toBeGreaterThan(0);
      expect(taken).toBeLessThan(1500);
    },
    120_000,
  );
});
