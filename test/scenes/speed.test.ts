import { describe, expect, it } from 'vitest';
import { phys2D } from '../../src/index.js';
import { DT, scenes } from './speed/index.js';

// The scenes of the bench: that they are what their titles say, and that phys2d keeps what it must in a few steps of them.

/** What takes long to build is left to the bench. */
const SMALL = Object.keys(scenes).filter((name) => !/100$|^many|^large|^smash|^pusher/.test(name));

const DYNAMIC: Readonly<Record<string, number>> = {
  pyramid: 820,
  pyramids: 25 * 55,
  circles: 2000,
  rain: 1000,
  chains: 2000,
  drum1000: 1000,
  drum2000: 2000,
  tiles: 2050,
  asleep: 2000,
  bullets: 500,
  tumbler: 2025,
  spinner: 3038,
  ragdolls: 3000,
  barrel: 2600,
  compounds: 1000,
};

describe('scenes of the bench', () => {
  it.each(SMALL)('%s', (name) => {
    const { figure, start } = scenes[name]!;
    const { world, act = () => world.step(DT), before = () => {}, quality } = start(phys2D);
    const built = world.rigidBodies.filter((body) => body.isDynamic()).length;
    expect(built).toBe(DYNAMIC[name] ?? built);
    const first = quality();
    for (let i = 0; i < 3; i += 1) {
      before(i);
      act();
    }
    const value = quality();
    expect(Number.isFinite(value)).toBe(true);
    if (figure === 'escaped' || figure === 'bodies left') {
      expect(value).toBe(0);
    } else if (figure === 'deepest overlap, mm') {
      // Nothing starts overlapped.
      expect(first).toBeLessThan(1e-6);
    }
  });
});
