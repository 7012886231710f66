import type { RigidBody } from '../../../src/index.js';
import { add, addGround, plainMaterial } from '../../scenes/stacks.js';
import { type Claim, type Figure, run } from './claim.js';

export const ballStack: Claim = {
  scene: 'three balls on each other, the topmost 100 times as heavy and taken away at step 120',
  measure(phys2D): Figure[] {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    addGround(phys2D, world, 0.6);
    const balls = [1, 1, 100].map((density, i) => {
      const shape = phys2D.createCircleShape({ radius: 0.5, material: plainMaterial(phys2D, 0.6, density) });
      return add(phys2D, world, shape, [0, -0.5 - i]);
    });
    const [lower, upper, heavy] = balls as [RigidBody, RigidBody, RigidBody];
    run(world, 2);
    world.removeRigidBody(heavy);
    let rise = 0;
    const height = (): number => Math.max(-0.5 - lower.getPosition()[1], -1.5 - upper.getPosition()[1]);
    run(world, 2, () => {
      rise = Math.max(rise, height());
    });
    return [{ what: 'others rise above where they were made', value: rise, unit: 'm', limit: 0.001 }];
  },
};
