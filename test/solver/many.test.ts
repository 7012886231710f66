import { describe, expect, it } from 'vitest';
import { phys2D, type RigidBody, type Shape, type Vec2, type World } from '../../src/index.js';

// Things that do not meet move as each would alone, however many there are: all that grows with their number keeps what is in it.

const COUNT = 80;
/** m. From one to the next. */
const APART = 4;

function box(width: number, height: number): Shape {
  return phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, height) });
}

function disc(radius: number, elasticity = 0): Shape {
  return phys2D.createCircleShape({ radius, material: phys2D.createMaterial({ elasticity }) });
}

function addGround(world: World, x: number): RigidBody {
  const body = phys2D.createRigidBody({ type: 'static', position: [x, 0.5], shapes: [box(3, 1)] });
  world.addRigidBody(body);
  return body;
}

type Build = (world: World, x: number) => RigidBody;

function thing(shape: () => Shape, [dx, y]: Vec2, velocity: Vec2): Build {
  return (world, x) => {
    addGround(world, x);
    const body = phys2D.createRigidBody({ position: [x + dx, y], velocity, shapes: [shape()] });
    world.addRigidBody(body);
    return body;
  };
}

const things: Record<string, Build> = {
  'boxes that slide': thing(() => box(0.5, 0.5), [-1, -0.25], [3, 0]),
  'discs that roll': thing(() => disc(0.25), [-1, -0.25], [1, 0]),
  'balls that bounce': thing(() => disc(0.25, 0.8), [0, -1], [0.1, 2]),
  'bricks that bounce': thing(
    () =>
      phys2D.createPolygonShape({
        vertices: phys2D.createBoxVertices(1, 0.5),
        material: phys2D.createMaterial({ elasticity: 0.8 }),
      }),
    [0, -0.5],
    [0, 2],
  ),
  'bullets that meet': (world, x) => {
    const [body] = [-1, 1].map((side) => {
      const shapes = [disc(0.05)];
      const made = phys2D.createRigidBody({
        position: [x + 0.3 * side, 0],
        velocity: [-90 * side, 1],
        shapes,
        bullet: true,
      });
      world.addRigidBody(made);
      return made;
    });
    return body!;
  },
  pendulums: (world, x) => {
    const bodyA = addGround(world, x);
    const bodyB = phys2D.createRigidBody({ position: [x + 1, 3], shapes: [disc(0.2)] });
    world.addRigidBody(bodyB);
    world.addConstraint(phys2D.createPointConstraint({ bodyA, bodyB, anchorA: [0, 1], anchorB: [-1, -1.5] }));
    return bodyB;
  },
  'things on springs': (world, x) => {
    const bodyA = addGround(world, x);
    const bodyB = phys2D.createRigidBody({ position: [x + 1, 3], rotation: 1, shapes: [box(1, 0.2)] });
    world.addRigidBody(bodyB);
    world.addConstraint(phys2D.createWeldConstraint({ bodyA, bodyB, anchorA: [1, 2], stiff: false, frequency: 2 }));
    return bodyB;
  },
};

describe(`${COUNT} of them move as each would alone:`, () => {
  it.each(Object.entries(things))('%s', (_, build) => {
    const world = phys2D.createWorld();
    const bodies = Array.from({ length: COUNT }, (_, i) => build(world, APART * i));
    const alone = [0, COUNT - 1].map((i) => {
      const other = phys2D.createWorld();
      return [bodies[i]!, build(other, APART * i), other] as const;
    });
    for (let i = 0; i < 12; i += 1) {
      world.step(1 / 60);
      for (const [body, twin, other] of alone) {
        other.step(1 / 60);
        const [x, y] = twin.getPosition();
        expect(body.getPosition()[0]).toBeCloseTo(x, 6);
        expect(body.getPosition()[1]).toBeCloseTo(y, 6);
        expect(body.getRotation()).toBeCloseTo(twin.getRotation(), 6);
      }
    }
  });
});

it(`${COUNT} bodies fall asleep in the same step, and each wakes alone`, () => {
  const world = phys2D.createWorld({ gravity: [0, 0] });
  const bodies = Array.from({ length: COUNT }, (_, i) =>
    phys2D.createRigidBody({ position: [APART * i, 0], shapes: [disc(1)] }),
  );
  for (const body of bodies) {
    world.addRigidBody(body);
  }
  while (bodies.every(({ sleeping }) => !sleeping)) {
    world.step(1 / 60);
  }
  expect(world.liveDynamics).toEqual([]);
  bodies.at(-1)!.setVelocity([1, 0]);
  world.step(1 / 60);
  expect(world.liveDynamics).toEqual([bodies.at(-1)]);
});
