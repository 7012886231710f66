import { add, plainMaterial } from '../../scenes/stacks.js';
import { type Claim, type Figure, run } from './claim.js';

export const spinningBox: Claim = {
  scene: 'box that flies and spins freely, 60 s',
  measure(phys2D): Figure[] {
    const world = phys2D.createWorld({ gravity: [0, 0], allowSleeping: false });
    const material = plainMaterial(phys2D, 0.6);
    const shape = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(2, 1), material });
    const body = add(phys2D, world, shape, [0, 0], { velocity: [3, -2], angularVelocity: 7 });
    const energy = (): number => {
      const [vx, vy] = body.getVelocity();
      return 0.5 * 2 * (vx * vx + vy * vy) + 0.5 * (10 / 12) * body.getAngularVelocity() ** 2;
    };
    const start = energy();
    let most = 0;
    run(world, 60, () => {
      most = Math.max(most, energy() / start - 1);
    });
    return [{ what: 'energy above the start', value: most, unit: '', limit: 1e-12 }];
  },
};
