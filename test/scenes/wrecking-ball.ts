import type { Physics2DDevice, PointConstraint, RigidBody, World } from '../../src/index.js';
import { Builder, friction } from './play.js';

export interface WreckingBall {
  readonly ball: RigidBody;
  readonly joints: readonly PointConstraint[];
  readonly crates: readonly RigidBody[];
}

const LINK = 0.6;

/** A heavy ball on a chain swings into a wall of crates. */
export function buildWreckingBall(phys2D: Physics2DDevice, world: World, links = 12): WreckingBall {
  const yard = new Builder(phys2D, world);
  const [top, radius] = [-9.6, 0.9];
  yard.wall(-12, 0, 14, 1);
  yard.wall(-0.3, top - 0.3, 0.3, top + 0.3, { shape: { mask: 0 } });
  const joints: PointConstraint[] = [];
  let last = phys2D.createRigidBody({ type: 'static', position: [0, top] });
  for (let i = 0; i < links; i += 1) {
    const link = yard.box(-LINK * (i + 0.5), top, LINK, 0.16, { surface: { density: 3 } });
    joints.push(yard.pin(last, i === 0 ? [0, 0] : [-LINK / 2, 0], link, [LINK / 2, 0]));
    last = link;
  }
  const surface = { ...friction(0.5, 0.1), density: 8 };
  const ball = yard.disc(-LINK * links - radius, top, radius, { surface });
  joints.push(yard.pin(last, [-LINK / 2, 0], ball, [radius, 0]));
  const crates: RigidBody[] = [];
  for (let row = 0; row < 8; row += 1) {
    for (let column = 0; column < 4; column += 1) {
      crates.push(yard.box(2 + 0.85 * column, -0.4 - 0.8 * row, 0.8, 0.8, { surface: friction(0.6) }));
    }
  }
  return { ball, joints, crates };
}
