import type { Physics2DDevice, RigidBody, World } from '../../src/index.js';
import { Builder, friction } from './play.js';

/** m/s, and m: how long the floors are and how far apart. */
export const RUN_SPEED = 16;
const LENGTH = 32;
const LANE = 3;

/** Floors of tiles with walls of tiles, along which a box, a flat plank, a disc and a hexagon slide without friction. @returns these. */
export function buildTileRun(phys2D: Physics2DDevice, world: World): RigidBody[] {
  const yard = new Builder(phys2D, world);
  const ice = friction(0, 1);
  const params = { surface: ice, linearDrag: 0, angularDrag: 0, velocity: [RUN_SPEED, 0] } as const;
  const hexagon = phys2D.createRegularPolygonVertices(1, 1, 6);
  const make = [
    (y: number) => yard.box(-LENGTH / 2 + 3, y - 0.4, 0.8, 0.8, params),
    (y: number) => yard.box(-LENGTH / 2 + 6, y - 0.15, 2.4, 0.3, params),
    (y: number) => yard.disc(-LENGTH / 2 + 9, y - 0.4, 0.4, params),
    (y: number) => {
      // It lies on a side.
      const bottom = Math.max(...hexagon.map(([, height]) => height));
      return yard.polygon(hexagon, { position: [-LENGTH / 2 + 12, y - bottom], ...params });
    },
  ];
  return make.map((put, lane) => {
    const y = LANE * lane;
    for (let i = 0; i < LENGTH; i += 1) {
      yard.wall(-LENGTH / 2 + i, y, -LENGTH / 2 + i + 1, y + 1, { surface: ice });
    }
    for (const side of [-1, 1]) {
      for (let i = 0; i < 2; i += 1) {
        yard.wall((side * LENGTH) / 2, y - 1 - i, (side * LENGTH) / 2 + side, y - i, { surface: ice });
      }
    }
    return put(y);
  });
}
