import type { Physics2DDevice, PointConstraint, RigidBody, Vec2, World } from '../../src/index.js';
import { Builder, friction } from './play.js';

export interface LoadedRope {
  readonly joints: readonly PointConstraint[];
  /** At the ends, the left one first. */
  readonly loads: readonly RigidBody[];
}

const LINK = 0.2;
const THICKNESS = 0.1;

export interface RopeParams {
  /** Where the middle of the drum is, and its radius. */
  readonly at: Vec2;
  readonly radius: number;
  /** m. How far the rope hangs down on either side. */
  readonly leg: number;
  /** kg, of either load. */
  readonly loads: readonly [number, number];
  readonly surface: number;
  readonly density: number;
}

/** A rope over a drum that is there already, with a load at either end. */
export function hangOver(phys2D: Physics2DDevice, world: World, params: RopeParams): LoadedRope {
  const { at, leg, loads: kilograms, surface, density } = params;
  const builder = new Builder(phys2D, world);
  // The middle of the rope goes round a little farther out, and down beside the drum.
  const radius = params.radius + THICKNESS / 2 + 0.01;
  const quarter = (Math.PI / 2) * radius;
  const place = (way: number): { position: Vec2; rotation: number } => {
    const side = Math.sign(way);
    if (Math.abs(way) > quarter) {
      return { position: [at[0] + side * radius, at[1] + Math.abs(way) - quarter], rotation: (side * Math.PI) / 2 };
    }
    const angle = way / radius;
    return { position: [at[0] + radius * Math.sin(angle), at[1] - radius * Math.cos(angle)], rotation: angle };
  };
  const joints: PointConstraint[] = [];
  const half = Math.round((quarter + leg) / LINK);
  const links: RigidBody[] = [];
  for (let i = 0; i < 2 * half; i += 1) {
    const { position, rotation } = place((i - half + 0.5) * LINK);
    const link = builder.box(...position, LINK, THICKNESS, { rotation, surface: { ...friction(surface), density } });
    if (i > 0) joints.push(builder.pin(links[i - 1]!, [LINK / 2, 0], link, [-LINK / 2, 0]));
    links.push(link);
  }
  const loads = kilograms.map((mass, i) => {
    const link = links.at(-i)!;
    const [x, y] = link.getPosition();
    const load = builder.box(x, y + 0.6, 0.5, 0.8, { mass, inertia: mass / 10 });
    joints.push(builder.pin(link, [(i - 0.5) * LINK, 0], load, [0, -0.5]));
    return load;
  });
  return { joints, loads };
}

/** Ropes over a drum that holds them by friction, over one without any, and over a wheel that turns with them. */
export function buildLoadedRopes(phys2D: Physics2DDevice, world: World): readonly LoadedRope[] {
  const builder = new Builder(phys2D, world);
  builder.wall(-10, 8, 10, 9);
  const drum = (x: number, value: number): void => {
    builder.disc(x, 0, 1.5, { type: 'static', surface: friction(value) });
  };
  drum(-6, 1);
  drum(0, 0);
  const wheel = builder.disc(6, 0, 1.5, { surface: { ...friction(1), density: 0.5 } });
  const axle = phys2D.createRigidBody({ type: 'static', position: [6, 0] });
  world.addConstraint(phys2D.createPointConstraint({ bodyA: axle, bodyB: wheel }));
  const common = { radius: 1.5, density: 2 };
  return [
    hangOver(phys2D, world, { ...common, at: [-6, 0], leg: 3, loads: [5, 10], surface: 1 }),
    hangOver(phys2D, world, { ...common, at: [0, 0], leg: 3, loads: [4, 5], surface: 0 }),
    hangOver(phys2D, world, { ...common, at: [6, 0], leg: 3, loads: [4, 5], surface: 1 }),
  ];
}
