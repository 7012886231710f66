import type { Physics2DDevice } from '../../../src/index.js';
import { add } from '../../scenes/stacks.js';
import { type Claim, DT, type Figure } from './claim.js';

/** Heights of the apexes of a ball that falls 4 m, as shares of that of the one before. */
function apexRatios(phys2D: Physics2DDevice, elasticity: number, bounces: number): number[] {
  const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
  const material = phys2D.createMaterial({ elasticity, staticFriction: 0, dynamicFriction: 0, rollingFriction: 0 });
  const ground = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(20, 2), material });
  add(phys2D, world, ground, [0, 1], { type: 'static' });
  const ball = add(phys2D, world, phys2D.createCircleShape({ radius: 0.25, material }), [0, -4.25]);
  const heights = [4];
  let rose = false;
  let highest = 0;
  for (let i = 0; i < 6000 && heights.length <= bounces; i += 1) {
    world.step(DT);
    const [, vy] = ball.getVelocity();
    const height = -0.25 - ball.getPosition()[1];
    if (vy < 0) {
      highest = rose ? Math.max(highest, height) : height;
      rose = true;
    } else if (rose) {
      heights.push(highest);
      rose = false;
    }
  }
  return heights.slice(1).map((height, i) => height / heights[i]!);
}

export const bounce: Claim = {
  scene: 'ball that falls 4 m',
  measure(phys2D): Figure[] {
    const off = (elasticity: number, bounces: number): number => {
      const ratios = apexRatios(phys2D, elasticity, bounces);
      const missing = ratios.length < bounces ? Infinity : 0;
      return Math.max(missing, ...ratios.map((ratio) => Math.abs(ratio - elasticity * elasticity)));
    };
    return [
      { what: 'elasticity 1, ten bounces: apex ratio off', value: off(1, 10), unit: '', limit: 0.005 },
      // After the third its impacts are slower than what bounces at all.
      { what: 'elasticity 0.5, three bounces: apex ratio off', value: off(0.5, 3), unit: '', limit: 0.01 },
    ];
  },
};
