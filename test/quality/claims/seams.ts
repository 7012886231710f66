import type { Physics2DDevice } from '../../../src/index.js';
import { add, plainMaterial } from '../../scenes/stacks.js';
import { type Claim, type Figure, run } from './claim.js';

/** A box at 5 m/s over 60 tiles. @returns its least speed and highest hop. */
function overTiles(phys2D: Physics2DDevice, offset: number, oneBody: boolean): { speed: number; hop: number } {
  const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
  const material = plainMaterial(phys2D, 0);
  const tile = (x: number) =>
    phys2D.createPolygonShape({ vertices: phys2D.createRectangleVertices(x, 0, x + 1, 1), material });
  const shapes = Array.from({ length: 60 }, (_, i) => tile(i));
  for (const group of oneBody ? [shapes] : shapes.map((shape) => [shape])) {
    world.addRigidBody(phys2D.createRigidBody({ type: 'static', position: [0, 0], shapes: group }));
  }
  const box = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1, 1), material });
  const body = add(phys2D, world, box, [1 + offset, -0.5], { velocity: [5, 0] });
  let speed = 5;
  let hop = 0;
  run(world, 11, () => {
    speed = Math.min(speed, body.getVelocity()[0]);
    hop = Math.max(hop, -0.5 - body.getPosition()[1]);
  });
  return { speed: speed / 5, hop };
}

export const seams: Claim = {
  scene: 'box at 5 m/s over 60 flush tiles, 20 offsets, friction 0',
  measure(phys2D): Figure[] {
    return [false, true].flatMap((oneBody) => {
      const runs = Array.from({ length: 20 }, (_, i) => overTiles(phys2D, i / 20, oneBody));
      const what = oneBody ? 'shapes of one body' : 'bodies of their own';
      return [
        { what: `${what}: runs that snag`, value: runs.filter(({ speed }) => speed < 0.9).length, unit: '', limit: 0 },
        { what: `${what}: speed lost`, value: 1 - Math.min(...runs.map(({ speed }) => speed)), unit: '', limit: 0.001 },
        { what: `${what}: highest hop`, value: Math.max(...runs.map(({ hop }) => hop)), unit: 'm', limit: 0.001 },
      ];
    });
  },
};
