import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { describe, expect, it } from 'vitest';
import type * as source from '../../src/index.js';
import { worstGap } from '../scenes/joint-grid.js';

// What is far heavier than the planks of a bridge does not go through them: joints that bear much make momentum of their corrections. From the bundle as built.

const { phys2D } = (await import(
  /* @vite-ignore */ pathToFileURL(join(import.meta.dirname, '../../dist/phys2d.js')).href
)) as typeof source;

const PLANKS = 20;
const RADIUS = 0.4;

function box(world: source.World, x: number, y: number, size: readonly [number, number], isStatic: boolean) {
  const material = phys2D.createMaterial({ density: 2 });
  const shapes = [phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(size[0], size[1]), material })];
  const type = isStatic ? 'static' : 'dynamic';
  const body = phys2D.createRigidBody({ type, position: [x, y], shapes, linearDrag: 0, angularDrag: 0 });
  world.addRigidBody(body);
  return body;
}

/** Planks of 1 m, taut between two banks, and balls that roll onto them from the left one. */
function buildBridge(thickness: number, balls: number, density: number, isCompound: boolean) {
  const world = phys2D.createWorld({ gravity: [0, 10] });
  const left = box(world, -13, 0.5, [6, 1], true);
  const right = box(world, 13, 0.5, [6, 1], true);
  const joints: source.PointConstraint[] = [];
  const planks: source.RigidBody[] = [];
  const hinge = (bodyA: source.RigidBody, anchorA: source.Vec2, bodyB: source.RigidBody, anchorB: source.Vec2) => {
    joints.push(phys2D.createPointConstraint({ bodyA, bodyB, anchorA, anchorB, ignoreInteractions: true }));
    world.addConstraint(joints.at(-1)!);
  };
  for (let i = 0; i < PLANKS; i += 1) {
    const plank = box(world, -9.5 + i, 0.05, [1, thickness], false);
    const last = planks.at(-1);
    hinge(last ?? left, last === undefined ? [3, -0.45] : [0.5, 0], plank, [-0.5, 0]);
    planks.push(plank);
  }
  hinge(planks.at(-1)!, [0.5, 0], right, [-3, -0.45]);
  for (let i = 0; i < 240; i += 1) {
    world.step(1 / 60);
  }
  const material = phys2D.createMaterial({ density, staticFriction: 0.8, dynamicFriction: 0.8 });
  const load = Array.from({ length: balls }, (_, i) => {
    const shapes = [RADIUS, RADIUS / 4].map((radius) => phys2D.createCircleShape({ radius, material }));
    const place = { position: [-13 + 1.2 * i, -RADIUS], velocity: [3, 0] } as const;
    const ball = phys2D.createRigidBody({
      ...place,
      shapes: isCompound ? shapes : shapes.slice(0, 1),
      linearDrag: 0,
      angularDrag: 0,
    });
    world.addRigidBody(ball);
    return ball;
  });
  return { world, joints, planks, load };
}

/** Whether a ball that has the planks above it is below all of them. */
function isThrough(ball: source.RigidBody, planks: readonly source.RigidBody[]): boolean {
  const [x, y] = ball.getPosition();
  return Math.abs(x) < PLANKS / 2 && planks.every((plank) => plank.getPosition()[1] < y - RADIUS);
}

describe('a hinged bridge', () => {
  // Balls of two shapes are pushed out by as much as others: not as what may be hooked. Before, balls went through in all of these, as they do in Box2D through one in eleven random bridges and now here through one in twenty.
  it.each([
    { thickness: 0.12, balls: 1, density: 100, rate: 60 },
    { thickness: 0.12, balls: 3, density: 60, rate: 60 },
    { thickness: 0.12, balls: 3, density: 100, rate: 60 },
    { thickness: 0.3, balls: 3, density: 100, rate: 60 },
    { thickness: 0.3, balls: 3, density: 96, rate: 30 },
    { thickness: 0.12, balls: 1, density: 200, rate: 60 },
    { thickness: 0.12, balls: 3, density: 60, rate: 60, isCompound: true },
    { thickness: 0.12, balls: 1, density: 30, rate: 60, isCompound: true },
  ])('of planks of $thickness m holds $balls balls of $density kg/m², at 1/$rate s', (made) => {
    const { world, joints, planks, load } = buildBridge(
      made.thickness,
      made.balls,
      made.density,
      made.isCompound ?? false,
    );
    const ratio = load[0]!.getMass() / planks[0]!.getMass();
    let gap = 0;
    for (let i = 0; i < 8 * made.rate; i += 1) {
      world.step(1 / made.rate);
      gap = Math.max(gap, worstGap(joints));
      expect(load.some((ball) => isThrough(ball, planks))).toBe(false);
    }
    console.log(`${made.balls} balls of ${ratio.toFixed(0)} planks each: joints gape by ${gap.toFixed(3)} m`);
    // How far they gape for a moment is a matter of chance; never so far that half a ball would fit in.
    expect(gap).toBeLessThan(RADIUS);
  });
});
