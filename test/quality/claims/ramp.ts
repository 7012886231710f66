import type { Physics2DDevice, RigidBody, World } from '../../../src/index.js';
import { add, plainMaterial } from '../../scenes/stacks.js';
import { type Claim, type Figure, run } from './claim.js';

const SLOPE = (20 * Math.PI) / 180;

/** A 1 m box on a slope of 20°. @returns it. */
function onRamp(phys2D: Physics2DDevice, world: World, friction: number): RigidBody {
  const material = plainMaterial(phys2D, friction);
  const ramp = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(400, 2), material });
  const [c, s] = [Math.cos(SLOPE), Math.sin(SLOPE)];
  add(phys2D, world, ramp, [-s, c], { type: 'static', rotation: SLOPE });
  const box = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1, 1), material });
  return add(phys2D, world, box, [0.5 * s, -0.5 * c], { rotation: SLOPE });
}

/** How far it has slid down the slope, m. */
function slid(body: RigidBody): number {
  const [x, y] = body.getPosition();
  return x * Math.cos(SLOPE) + y * Math.sin(SLOPE);
}

export const ramp: Claim = {
  scene: 'box on a slope of 20°',
  measure(phys2D): Figure[] {
    const sliding = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const box = onRamp(phys2D, sliding, 0.2);
    run(sliding, 3);
    const expected = 0.5 * 10 * (Math.sin(SLOPE) - 0.2 * Math.cos(SLOPE)) * 9;
    const holding = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const held = onRamp(phys2D, holding, 0.5);
    run(holding, 1);
    const start = slid(held);
    run(holding, 60);
    return [
      {
        what: 'friction 0.2: distance off in 3 s',
        value: 100 * Math.abs(slid(box) / expected - 1),
        unit: '%',
        limit: 0.15,
      },
      { what: 'friction 0.5: creep in 60 s', value: Math.abs(slid(held) - start), unit: 'm', limit: 1e-6 },
    ];
  },
};
