import { expect, it } from 'vitest';
import { add, boxBody, heavy, steps } from '../conformance/setting.js';

// The handler of the guide of events: decided once, when shapes touch first.

const TOP = -2;

it('crates that land on a one-way platform stay there, though their corners get deeper than their speed tells', () => {
  for (let round = 0; round < 10; round += 1) {
    const world = heavy();
    const platform = boxBody(12, 0.2, { type: 'static', position: [0, TOP + 0.1] });
    platform.shapes[0]!.addEventListener('preSolve', (arbiter, other) => {
      const body = other.body!;
      const [, speed] = body.getVelocity();
      arbiter.setAcceptedState(body.computeWorldBounds()[3] - speed / 60 <= TOP + 0.02);
      arbiter.setPersistentState(true);
    });
    const crates = Array.from({ length: 8 }, (_, i) =>
      boxBody(0.6, 0.6, { position: [-2 + (i % 4) * 1.1, -3 - 1.2 * Math.floor(i / 4)], rotation: 0.1 * round }),
    );
    add(world, platform, ...crates);
    steps(world, 600);
    for (const crate of crates) {
      expect(crate.getPosition()[1]).toBeLessThan(TOP);
    }
  }
});
