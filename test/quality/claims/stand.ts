import type { Physics2DDevice, RigidBody } from '../../../src/index.js';
import { buildTower, type TowerParams } from '../../scenes/stacks.js';
import { fastest, run } from './claim.js';

export interface Stood {
  /** m. How much lower the topmost box is than in a tower of rigid boxes. */
  readonly top: number;
  /** m. How much farther from the axis the worst box is than at the start. */
  readonly sideways: number;
  /** m/s. The fastest box at the end. */
  readonly speed: number;
  readonly fell: number;
}

/** A tower, without sleep, after some seconds. */
export function stand(phys2D: Physics2DDevice, params: TowerParams, seconds: number): Stood {
  const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
  const boxes = buildTower(phys2D, world, params);
  const starts = boxes.map((body) => body.getPosition()[0]);
  run(world, seconds);
  const drift = (body: RigidBody, i: number): number => Math.abs(body.getPosition()[0]) - Math.abs(starts[i]!);
  const top = boxes.at(-1)!.getPosition()[1] + params.count - 0.5;
  return {
    top,
    sideways: Math.max(...boxes.map(drift)),
    speed: fastest(boxes),
    fell: Math.abs(top) < 0.9 ? 0 : 1,
  };
}
