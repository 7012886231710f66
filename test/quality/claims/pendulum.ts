import { APART, FREE } from './chain.js';
import { type Claim, type Figure, run } from './claim.js';

export const pendulum: Claim = {
  scene: 'pendulum of 1 m released level, 60 s',
  measure(phys2D): Figure[] {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const pivot = phys2D.createRigidBody({ type: 'static', position: [0, 0] });
    world.addRigidBody(pivot);
    const shape = phys2D.createCircleShape({ radius: 0.25, ...APART });
    const bob = phys2D.createRigidBody({ position: [1, 0], shapes: [shape], ...FREE });
    world.addRigidBody(bob);
    world.addConstraint(phys2D.createPointConstraint({ bodyA: pivot, bodyB: bob, anchorA: [0, 0], anchorB: [-1, 0] }));
    let gain = 0;
    let apex = 0;
    run(world, 60, (step) => {
      const height = 1 - Math.max(0, bob.getPosition()[1]);
      gain = Math.max(gain, -bob.getPosition()[1]);
      apex = step > 3600 - 180 ? Math.max(apex, height) : 0;
    });
    return [
      { what: 'apex lower after 60 s', value: 100 * (1 - apex), unit: '%', limit: 0.5 },
      { what: 'ever above the start', value: gain, unit: 'm', limit: 1e-9 },
    ];
  },
};
