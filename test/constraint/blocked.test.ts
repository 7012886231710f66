import { describe, expect, it } from 'vitest';
import { type Constraint, phys2D, type RigidBody, type Vec2, type World } from '../../src/index.js';
import { add, box, disc, plainBody, speed, staticBody, steps, tie, weightless } from '../conformance/setting.js';

// What rigid constraints drag along, haul up or press down stays in front of what is in its way, however slowly and far they go on: the constraints stay open.

/** m. Of a wall at most so much. */
const DEPTH = 0.11;

const KINDS: Record<string, (bodyA: RigidBody, bodyB: RigidBody, anchorA: Vec2, anchorB: Vec2) => Constraint> = {
  point: (bodyA, bodyB, anchorA, anchorB) => phys2D.createPointConstraint({ bodyA, bodyB, anchorA, anchorB }),
  weld: (bodyA, bodyB, anchorA, anchorB) => phys2D.createWeldConstraint({ bodyA, bodyB, anchorA, anchorB }),
  distance: (bodyA, bodyB, anchorA, anchorB) =>
    phys2D.createDistanceConstraint({ bodyA, bodyB, anchorA, anchorB, lowerBound: 0, upperBound: 0.05 }),
  line: (bodyA, bodyB, anchorA, anchorB) =>
    phys2D.createLineConstraint({ bodyA, bodyB, anchorA, anchorB, axis: [0, 1], lowerBound: -0.1, upperBound: 0.1 }),
};

/** m. How far the anchor goes in a step. */
const PACES = [0.001, 0.005, 0.05, 0.3, 5];

describe('a box that a hand drags against a wall', () => {
  it.each(Object.keys(KINDS).flatMap((kind) => PACES.map((pace) => [kind, pace] as const)))(
    'by %s, %f m a step',
    (kind, pace) => {
      for (const [wall, size] of [
        [0.2, 0.3],
        [1, 1],
      ] as const) {
        const world = phys2D.createWorld();
        add(world, staticBody({ shapes: [box(40, 1)], position: [0, 0.5] }));
        add(world, staticBody({ shapes: [box(wall, 20)], position: [3 + wall / 2, -10] }));
        const dragged = phys2D.createRigidBody({ shapes: [box(size, size)], position: [2, -0.5 - size / 2] });
        add(world, dragged);
        const hand = staticBody({ position: [2, -3] });
        tie(world, KINDS[kind]!(hand, dragged, [0, 0], [0, 0]));
        for (let x = 2; x < 6; x += pace) {
          hand.setPosition([x, -3]);
          world.step(1 / 60);
        }
        steps(world, 60);
        expect(dragged.getPosition()[0] + size / 2, `a wall of ${wall} m`).toBeLessThan(3 + DEPTH);
      }
    },
  );
});

describe('a box on a weld of a hand that goes on into a wall', () => {
  it.each([0, 0.4, 0.8])('stands, at an angle of %f', (angle) => {
    for (const substeps of [1, 4, 8]) {
      const world = weightless({ substeps });
      const dragged = plainBody({ shapes: [box(0.8, 0.8)] });
      const velocity = [-0.3 * Math.cos(angle), -0.3 * Math.sin(angle)];
      const hand = phys2D.createRigidBody({ type: 'kinematic', velocity });
      add(world, staticBody({ shapes: [box(1, 40)], position: [-0.91, 0] }), dragged, hand);
      tie(world, KINDS.weld!(hand, dragged, [0, 0], [0, 0]));
      let fastest = 0;
      for (let i = 0; i < 240; i += 1) {
        world.step(1 / 60);
        fastest = Math.max(fastest, speed(dragged));
      }
      // 19.2 m/s before, for a quarter of a second: the momentum of corrections that the wall undid.
      expect(fastest, `${substeps} sub-steps`).toBeLessThan(1);
    }
  });
});

/** Steps a world for so many steps. @returns the largest difference in them between a body's velocity and how it moved, m/s. */
function untruth(world: World, body: RigidBody, count: number): number {
  let worst = 0;
  for (let i = 0; i < count; i += 1) {
    const [x, y] = body.getPosition();
    world.step(1 / 60);
    const [toX, toY] = body.getPosition();
    const [vx, vy] = body.getVelocity();
    worst = Math.max(worst, Math.hypot(vx - 60 * (toX - x), vy - 60 * (toY - y)));
  }
  return worst;
}

describe('what a hand holds by a weld moves as it is told to', () => {
  it.each([1, 4, 8])('an arm that it turned into a stone and turns back, %i sub-steps', (substeps) => {
    const world = weightless({ substeps });
    const arm = plainBody({ shapes: [box(2, 0.2)], position: [1, 0] });
    const hand = phys2D.createRigidBody({ type: 'kinematic', angularVelocity: 0.3 });
    add(world, arm, hand, staticBody({ shapes: [box(1, 1)], position: [1.5, 0.7] }));
    tie(world, KINDS.weld!(hand, arm, [0, 0], [-1, 0]));
    steps(world, 120);
    hand.setAngularVelocity(-0.3);
    // 17 m/s before, at which it stood: once the weld was open by less than 5 cm, momentum was made of what the stone undid.
    expect(untruth(world, arm, 120)).toBeLessThan(1.5);
  });

  it.each([1, 4, 8])('a sled that it draws over a bump, %i sub-steps', (substeps) => {
    const world = phys2D.createWorld({ substeps });
    const sled = phys2D.createRigidBody({ shapes: [box(3, 0.6)], position: [0, -0.3] });
    const hand = phys2D.createRigidBody({ type: 'kinematic', position: [1.5, -0.3], velocity: [4, 0] });
    const bump = staticBody({ shapes: [box(0.2, 0.2)], position: [4, 0.02], rotation: 0.785 });
    add(world, staticBody({ shapes: [box(40, 1)], position: [0, 0.5] }), bump, sled, hand);
    tie(world, KINDS.weld!(hand, sled, [0, 0], [1.5, 0]));
    // 30 m/s before, upwards, as it slid along.
    expect(untruth(world, sled, 120)).toBeLessThan(6);
  });
});

describe('a row that a hand presses against a wall', () => {
  it.each(
    [1, 3, 5].flatMap((count) => [2, 10].flatMap((seconds) => [4, 8].map((substeps) => [count, seconds, substeps]))),
  )('of %i comes off it slowly when that lets go after %i s, %i sub-steps', (count, seconds, substeps) => {
    for (const shape of [() => box(0.8, 0.8), () => disc(0.4)]) {
      const world = weightless({ substeps });
      const row = Array.from({ length: count }, (_, i) =>
        plainBody({ position: [0.4 + 0.8 * i, 0], shapes: [shape()] }),
      );
      const last = row[count - 1]!;
      const hand = phys2D.createRigidBody({ type: 'kinematic', position: last.getPosition(), velocity: [-0.3, 0] });
      add(world, staticBody({ shapes: [box(1, 40)], position: [-0.5, 0] }), ...row, hand);
      const grip = KINDS.point!(hand, last, [0, 0], [0, 0]);
      tie(world, grip);
      steps(world, 60 * seconds);
      // Up to 5,000 N·s and 232 m/s before, and more the longer it took.
      const [pull] = grip.getImpulseForBody(last);
      expect(Math.abs(pull)).toBeLessThan(40);
      world.removeConstraint(grip);
      steps(world, 2);
      expect(Math.max(...row.map(speed))).toBeLessThan(2.5);
    }
  });
});

/** Draws a rough box, turned by `rotation` as it starts, along a wall. @returns in how many steps its velocity is off by 2 m/s. */
function drawAlong(substeps: number, rotation: number): number {
  const material = phys2D.createMaterial({ staticFriction: 2, dynamicFriction: 2 });
  const world = phys2D.createWorld({ substeps });
  const shapes = [box(0.8, 0.8, { material })];
  const start = { position: [0.5, 0], velocity: [-0.9, 0.8], rotation } as const;
  const rough = phys2D.createRigidBody({ shapes, ...start, linearDrag: 0, angularDrag: 0 });
  const motion = { velocity: [0.25, 0.25], angularVelocity: -1.26 } as const;
  const hand = phys2D.createRigidBody({ type: 'kinematic', position: [1.96, 0.89], rotation: -1.1, ...motion });
  add(world, staticBody({ shapes: [box(1, 20, { material })], position: [-0.5, 0] }), rough, hand);
  const anchors = { bodyA: rough, bodyB: hand, anchorA: [-1.11, -0.18], anchorB: [0.53, -0.99] } as const;
  tie(world, phys2D.createLineConstraint({ ...anchors, axis: [-0.82, 0.57], lowerBound: -1, upperBound: 1 }));
  return Array.from({ length: 90 }, () => untruth(world, rough, 1)).filter((off) => off > 2).length;
}

describe('a rough box that a line draws along a wall', () => {
  it.each([2, 4, 8])('moves as it is told to, %i sub-steps', (substeps) => {
    const untrue = Array.from({ length: 12 }, (_, i) => drawAlong(substeps, 1.84 + 0.01 * i));
    // 226 to 286 before, at up to 20 m/s; the hand moves it at 3 m/s.
    expect(untrue.reduce((sum, count) => sum + count)).toBeLessThan(110);
  });
});

/** A load under a ceiling, on links that meet nothing, the last of which is held by a hand. */
function hangUp(world: World, kind: string, links: number, density: number, hand: RigidBody): RigidBody {
  const material = phys2D.createMaterial({ density });
  const load = phys2D.createRigidBody({ shapes: [box(1, 1, { material })], position: [0, 1] });
  add(world, load);
  let below = load;
  for (let i = 1; i < links; i += 1) {
    const link = phys2D.createRigidBody({ shapes: [box(0.1, 0.5, { mask: 0 })], position: [0, 1.25 - 0.5 * i] });
    add(world, link);
    tie(world, KINDS[kind]!(link, below, [0, 0.25], below === load ? [0, 0] : [0, -0.25]));
    below = link;
  }
  hand.setPosition([0, 1 - 0.5 * (links - 1)]);
  tie(world, KINDS[kind]!(hand, below, [0, 0], below === load ? [0, 0] : [0, -0.25]));
  return load;
}

describe('a load that is hauled up to a ceiling and on', () => {
  it.each(['point', 'weld', 'distance'].flatMap((kind) => [1, 3, 8].map((links) => [kind, links] as const)))(
    'by %s, %i links',
    (kind, links) => {
      for (const density of [1, 20]) {
        for (const pace of [0.005, 0.05]) {
          const world = phys2D.createWorld();
          add(world, staticBody({ shapes: [box(40, 0.2)], position: [0, -0.1] }));
          const hand = staticBody();
          const load = hangUp(world, kind, links, density, hand);
          const start = hand.getPosition()[1];
          for (let way = 0; way < 4; way += pace) {
            hand.setPosition([0, start - way]);
            world.step(1 / 60);
          }
          expect(load.getPosition()[1] - 0.5, `density ${density}, ${pace} m a step`).toBeGreaterThan(-DEPTH);
        }
      }
    },
  );
});

describe('an arm that is bent down to the ground and on', () => {
  it.each(['angle', 'weld'])('by %s', (kind) => {
    for (const pace of [0.002, 0.01, 0.05]) {
      const world = phys2D.createWorld();
      add(world, staticBody({ shapes: [box(40, 0.2)], position: [0, 0.1] }));
      const arm = phys2D.createRigidBody({ shapes: [box(2, 0.1)], position: [1, -1] });
      add(world, arm);
      const ends = { bodyA: staticBody({ position: [0, -1] }), bodyB: arm, anchorA: [0, 0], anchorB: [-1, 0] } as const;
      const bends = phys2D.createAngleConstraint({ ...ends, lowerBound: 0, upperBound: 0 });
      const weld = phys2D.createWeldConstraint({ ...ends, phase: 0 });
      tie(world, ...(kind === 'weld' ? [weld] : [phys2D.createPointConstraint(ends), bends]));
      for (let angle = 0; angle < 1.5; angle += pace) {
        weld.setPhase(angle);
        bends.setUpperBound(angle);
        bends.setLowerBound(angle);
        world.step(1 / 60);
      }
      const [, y] = arm.transformLocalPointToWorld([1, 0.05]);
      expect(y, `${pace} rad a step`).toBeLessThan(0.03);
    }
  });
});

describe('two things on either side of a wall that a rope pulls together', () => {
  it.each([0.1, 0.2, 1])('stay on their sides of %f m', (wall) => {
    for (const heavier of [1, 10]) {
      for (const pace of [0.001, 0.01, 0.1]) {
        const world = phys2D.createWorld();
        add(world, staticBody({ shapes: [box(20, 1)], position: [0, 0.5] }));
        add(world, staticBody({ shapes: [box(wall, 4)], position: [0, -2] }));
        const ends = [1, heavier].map((density, i) => {
          const shapes = [box(0.6, 0.6, { material: phys2D.createMaterial({ density }) })];
          return phys2D.createRigidBody({ shapes, position: [4 * i - 2, -0.3] });
        });
        add(world, ...ends);
        const [bodyA, bodyB] = [ends[0]!, ends[1]!];
        const middle = { anchorA: [0, 0], anchorB: [0, 0] } as const;
        const rope = phys2D.createDistanceConstraint({ bodyA, bodyB, ...middle, lowerBound: 0, upperBound: 4 });
        tie(world, rope);
        for (let length = 4; length > 0; length -= pace) {
          rope.setUpperBound(length);
          world.step(1 / 60);
        }
        steps(world, 60);
        const room = 0.3 + wall / 2 - DEPTH;
        expect(bodyA.getPosition()[0], `${heavier} : 1, ${pace} m a step`).toBeLessThan(-room);
        expect(bodyB.getPosition()[0], `${heavier} : 1, ${pace} m a step`).toBeGreaterThan(room);
      }
    }
  });
});

describe('a stack on a platform that draws something into what is in its way', () => {
  it('stands', () => {
    const world = phys2D.createWorld();
    const platform = phys2D.createRigidBody({ type: 'kinematic', shapes: [box(4, 0.4)] });
    const stack = Array.from({ length: 8 }, (_, i) => {
      const material = phys2D.createMaterial({ density: i === 7 ? 20 : 1 });
      return phys2D.createRigidBody({ shapes: [box(0.5, 0.5, { material })], position: [1.2, -0.45 - 0.5 * i] });
    });
    const bar = phys2D.createRigidBody({ shapes: [box(3, 0.5)], position: [-1, 1.9] });
    add(world, platform, ...stack, bar);
    const join = (bodyA: RigidBody, bodyB: RigidBody, anchorA: Vec2, anchorB: Vec2): void =>
      tie(world, phys2D.createPointConstraint({ bodyA, bodyB, anchorA, anchorB, ignoreInteractions: true }));
    for (let i = 0; i < 8; i += 2) {
      join(stack[i]!, stack[i + 1]!, [0, -0.25], [0, 0.25]);
    }
    join(platform, bar, [-1, 1.6], [0, -0.3]);
    for (const x of [-2, 0]) {
      add(world, staticBody({ shapes: [box(1.2, 0.5)], position: [x, 1.3] }));
    }
    let sinks = 0;
    for (let i = 0; i < 500; i += 1) {
      platform.setVelocity([0, i < 100 ? 0 : -0.1]);
      world.step(1 / 60);
      sinks = Math.max(sinks, stack[7]!.getPosition()[1] - platform.getPosition()[1] + 3.95);
    }
    // 0.19 m when contacts of the platform forgot some of their impulses, too.
    expect(sinks).toBeLessThan(0.05);
  });
});
