import { buildChain } from './chain.js';
import { type Claim, type Figure, run } from './claim.js';

export const stretchedChain: Claim = {
  scene: 'chain of 40 links created at twice its length',
  measure(phys2D): Figure[] {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const { joints, bodies } = buildChain(phys2D, world, 40, 2);
    let first = Infinity;
    run(world, 4, (step) => {
      const [x, y] = bodies.at(-1)!.transformLocalPointToWorld([0.5, 0]);
      const gaps = joints.reduce((sum, { bodyA, bodyB }, i) => {
        const [ax, ay] = bodyA.transformLocalPointToWorld(i === 0 ? [0, 0] : [0.5, 0]);
        const [bx, by] = bodyB.transformLocalPointToWorld([-0.5, 0]);
        return sum + Math.sqrt((bx - ax) ** 2 + (by - ay) ** 2);
      }, 0);
      const isWhole = gaps <= 0.4 && Math.sqrt(x * x + y * y) < 40.4;
      first = Math.min(first, isWhole ? step : Infinity);
    });
    return [{ what: 'time until it is 1 % too long', value: first / 60, unit: 's', limit: 1 }];
  },
};
