import { expect, it } from 'vitest';
import { phys2D, type World } from '../../src/index.js';
import { dice } from './dice.js';

const DT = 1 / 60;
const SECONDS = 12;

/** A box that holds a ball by a light arm, on two hinges with limits, and falls. With sweeps alone 21 of 72 such trembled for ever. */
function drop(seed: number, ratio: number): World {
  const { within } = dice(seed);
  const world = phys2D.createWorld({ gravity: [0, 10] });
  const dense = (density: number) => phys2D.createMaterial({ staticFriction: 0.6, dynamicFriction: 0.6, density });
  const box = (width: number, height: number, material = dense(1)) =>
    phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, height), material });
  world.addRigidBody(phys2D.createRigidBody({ type: 'static', position: [0, 0.5], shapes: [box(800, 1)] }));
  const [width, height, length, thickness, radius] = [
    within(0.5, 1.2),
    within(0.3, 0.8),
    within(0.2, 0.6),
    within(0.06, 0.12),
    within(0.15, 0.35),
  ] as const;
  const angle = within(-1, 1);
  const y = -height / 2 - within(1.5, 7);
  const hinge = [width / 2 + 0.02, within(-0.4, 0.4) * height] as const;
  const at = (way: number): [number, number] => [
    hinge[0] + Math.cos(angle) * way,
    y + hinge[1] + Math.sin(angle) * way,
  ];
  const hand = phys2D.createRigidBody({
    position: [0, y],
    velocity: [within(-2, 2), 0],
    angularVelocity: within(-2, 2),
    shapes: [box(width, height, dense(4))],
  });
  const arm = phys2D.createRigidBody({ position: at(length / 2), rotation: angle, shapes: [box(length, thickness)] });
  const density = (ratio * length * thickness) / (Math.PI * radius * radius);
  const ball = phys2D.createRigidBody({
    position: at(length + radius + 0.02),
    rotation: angle,
    shapes: [phys2D.createCircleShape({ radius, material: dense(density) })],
  });
  for (const body of [hand, arm, ball]) world.addRigidBody(body);
  const tie = (
    bodyA: typeof hand,
    bodyB: typeof hand,
    anchorA: [number, number],
    anchorB: [number, number],
    turn: number,
  ) => {
    const pair = { bodyA, bodyB, ignoreInteractions: true };
    world.addConstraint(phys2D.createPointConstraint({ ...pair, anchorA, anchorB }));
    const [lowerBound, upperBound] = [turn - within(0.1, 0.6), turn + within(0.1, 0.6)];
    world.addConstraint(phys2D.createAngleConstraint({ ...pair, lowerBound, upperBound }));
  };
  tie(hand, arm, [hinge[0], hinge[1]], [-length / 2, 0], angle);
  tie(arm, ball, [length / 2, 0], [-radius - 0.02, 0], 0);
  return world;
}

it.each([
  [4, 0],
  [10, 0],
  [25, 1],
  [60, 1],
])(
  'hammers of which the head is %d times as heavy as the handle come to rest, all of 24 but %d at most',
  (ratio, most) => {
    const restless = Array.from({ length: 24 }, (_, i) => i + 1).filter((seed) => {
      const world = drop(seed, ratio);
      for (let i = 0; i < SECONDS / DT; i += 1) world.step(DT);
      return world.liveDynamics.length > 0;
    });
    expect(restless.length, `seeds ${restless}`).toBeLessThanOrEqual(most);
  },
);
