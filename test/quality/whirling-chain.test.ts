import { expect, it } from 'vitest';
import { JOINT_FAR } from '../../src/config-joints.js';
import { phys2D, type RigidBody } from '../../src/index.js';
import { DT, heavy } from '../conformance/setting.js';
import { buildChains, worstGap } from '../scenes/joint-grid.js';

const LINKS = 80;
const GRAVITY = 10;
/** rad/s. The end of the chain has 320 m/s. */
const SPIN = 8;
const STEPS = 480;

/** J. Depth counts below zero. */
function energyOf(body: RigidBody): number {
  const [vx, vy] = body.getVelocity();
  const w = body.getAngularVelocity();
  const kinetic = 0.5 * body.getMass() * (vx * vx + vy * vy) + 0.5 * body.getInertia() * w * w;
  return kinetic - body.getMass() * GRAVITY * body.getPosition()[1];
}

it('a long chain that whirls, far from closed, neither tears nor gains energy', () => {
  const world = heavy({ allowSleeping: false });
  const { bodies, joints } = buildChains(phys2D, world, 1, LINKS);
  for (const link of bodies) {
    link.setVelocity([0, SPIN * link.getPosition()[0]]);
    link.setAngularVelocity(SPIN);
  }
  const energy = (): number => bodies.reduce((sum, body) => sum + energyOf(body), 0);
  const start = energy();
  let gap = 0;
  for (let i = 0; i < STEPS; i += 1) {
    world.step(DT);
    gap = Math.max(gap, worstGap(joints));
  }
  const share = energy() / start;
  console.log(`whirling chain: widest gap ${gap.toFixed(4)} m, energy × ${share.toFixed(3)}`);
  expect(gap).toBeGreaterThan(JOINT_FAR);
  expect(gap).toBeLessThan(0.06);
  expect(share).toBeLessThan(1);
});
