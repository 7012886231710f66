import { describe, expect, it } from 'vitest';
import { type NumberSink, phys2D, type RigidBody, type Vec2, type World } from '../../src/index.js';
import { addFloor, box, boxBody, disc, speed } from '../conformance/setting.js';

describe('what sleeps through a change of the step', () => {
  it.each([1 / 240, 1 / 600, 1 / 20])(
    'wakes with the impulses of the step that it fell asleep in: %s s',
    (deltaTime) => {
      const world = phys2D.createWorld();
      addFloor(world);
      const boxes = Array.from({ length: 10 }, (_, i) => {
        const body = boxBody(1, 1, { position: [0, -0.5 - i] });
        world.addRigidBody(body);
        return body;
      });
      for (let i = 0; i < 600 && !boxes[9]!.sleeping; i += 1) {
        world.step(1 / 60);
      }
      expect(boxes[9]!.sleeping).toBe(true);
      for (let i = 0; i < 3; i += 1) {
        world.step(deltaTime);
      }
      boxes[0]!.wake();
      let fastest = 0;
      for (let i = 0; i < 60; i += 1) {
        world.step(deltaTime);
        fastest = Math.max(fastest, ...boxes.map(speed));
      }
      expect(boxes[9]!.sleeping).toBe(false);
      expect(fastest).toBeLessThan(1e-3);
    },
  );
});

describe('a joint of a chain that is pulled against a wall', () => {
  it('tells all of what it gives', () => {
    const world = phys2D.createWorld({ gravity: [0, 0], allowSleeping: false });
    const wall = phys2D.createPolygonShape({ vertices: phys2D.createRectangleVertices(2, -5, 3, 5) });
    world.addRigidBody(phys2D.createRigidBody({ type: 'static', shapes: [wall] }));
    let before = phys2D.createRigidBody({ type: 'static' });
    world.addRigidBody(before);
    for (let i = 0; i < 12; i += 1) {
      const body = boxBody(0.4, 0.2, { position: [0.2 + 0.4 * i, 0], linearDrag: 0, angularDrag: 0 });
      world.addRigidBody(body);
      world.addConstraint(
        phys2D.createPointConstraint({
          bodyA: before,
          bodyB: body,
          anchorA: i === 0 ? [0, 0] : [0.2, 0],
          anchorB: [-0.2, 0],
          ignoreInteractions: true,
        }),
      );
      before = body;
    }
    const last = world.constraints[11]!;
    let touched = 0;
    for (let i = 0; i < 200; i += 1) {
      const pull = Math.min(2080, 20 * i);
      before.setForce([pull, 0]);
      const { 0: vx } = before.getVelocity();
      world.step(1 / 60);
      touched += world.solver.joints.groups.some((group) => group.touched) ? 1 : 0;
      const given = (before.getVelocity()[0] - vx) * before.getMass() - pull / 60;
      expect(last.getImpulseForBody(before)[0]).toBeCloseTo(given, 6);
    }
    expect(touched).toBeGreaterThan(50);
  });
});

describe('joints in steps of other lengths', () => {
  /** A chain that falls from where it lies level, and its energy as a share of what it has in falling 1 m. */
  function fallingChain(kind: string): { world: World; energy: () => number } {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    let before = phys2D.createRigidBody({ type: 'static' });
    for (let i = 0; i < 10; i += 1) {
      const body = boxBody(1, 0.2, { position: [i + 0.5, 0], linearDrag: 0, angularDrag: 0 });
      for (const shape of body.shapes) shape.setMask(0);
      world.addRigidBody(body);
      const params = {
        bodyA: before,
        bodyB: body,
        anchorA: [i === 0 ? 0 : 0.5, 0],
        anchorB: [-0.5, 0],
      };
      const custom = {
        bodies: [before, body],
        dimension: 2,
        position(data: NumberSink, index: number): void {
          const a = params.bodyA.transformLocalPointToWorld(params.anchorA);
          const b = params.bodyB.transformLocalPointToWorld(params.anchorB);
          data[index] = b[0] - a[0];
          data[index + 1] = b[1] - a[1];
        },
        jacobian(data: NumberSink, index: number): void {
          const a = params.bodyA.transformLocalVectorToWorld(params.anchorA);
          const b = params.bodyB.transformLocalVectorToWorld(params.anchorB);
          [-1, 0, a[1], 1, 0, -b[1], 0, -1, -a[0], 0, 1, b[0]].forEach((value, k) => {
            data[index + k] = value;
          });
        },
      };
      const constraint =
        kind === 'point'
          ? phys2D.createPointConstraint(params)
          : kind === 'weld'
            ? phys2D.createWeldConstraint(params)
            : kind === 'custom'
              ? phys2D.createCustomConstraint(custom)
              : phys2D.createDistanceConstraint({ ...params, upperBound: 0.05 });
      world.addConstraint(constraint);
      if (kind === 'angle') {
        world.addConstraint(phys2D.createPointConstraint(params));
        world.addConstraint(
          phys2D.createAngleConstraint({ bodyA: before, bodyB: body, lowerBound: -0.1, upperBound: 0.1 }),
        );
      }
      before = body;
    }
    const energy = (): number => {
      let sum = 0;
      for (const body of world.rigidBodies) {
        const [vx, vy] = body.getVelocity();
        const turning = body.getInertia() * body.getAngularVelocity() ** 2;
        sum += (body.getMass() * (vx * vx + vy * vy) + turning) / 2 - 10 * body.getMass() * body.getPosition()[1];
      }
      return sum / (100 * before.getMass());
    };
    return { world, energy };
  }

  for (const kind of ['point', 'weld', 'rope', 'angle', 'custom']) {
    for (const short of [[1e-3], [1e-4], [1e-6], [1e-9, 1e-9], [1e-17], [1e-6, 1e-5, 1e-4, 1e-3]]) {
      it(`${kind}: one of ${short.join(', then ')} s now and then gives a chain no energy`, () => {
        const { world, energy } = fallingChain(kind);
        for (let i = 0; i < 100; i += 1) {
          world.step(1 / 60);
        }
        const first = energy();
        for (let i = 0; i < 6; i += 1) {
          for (const deltaTime of short) {
            const before = energy();
            world.step(deltaTime);
            expect(energy() - before).toBeLessThan(0.05);
          }
          for (let k = 0; k < 5; k += 1) {
            world.step(1 / 60);
          }
        }
        expect(energy() - first).toBeLessThan(0.1);
      });
    }
  }

  it('a snapshot knows after what lengths', () => {
    const { world } = fallingChain('point');
    for (let i = 0; i < 60; i += 1) {
      world.step(1 / 60);
    }
    world.step(1e-3);
    const snapshot = world.snapshot();
    world.step(1e-3);
    const hash = world.hash();
    world.step(1 / 60);
    world.restore(snapshot);
    world.step(1e-3);
    expect(world.hash()).toBe(hash);
  });
});

describe('contacts in steps of other lengths', () => {
  /** Boxes that lie on each other, or fall from 3 m. */
  function boxesOn(height: number): { world: World; boxes: RigidBody[] } {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    addFloor(world);
    const boxes = Array.from({ length: 10 }, (_, i) => {
      const x = height > 0 ? 0.9 * (i % 3) : 0;
      const body = boxBody(1, 1, { position: [x, -height - 0.5 - i * (1 + height / 6)], rotation: height > 0 ? i : 0 });
      world.addRigidBody(body);
      return body;
    });
    return { world, boxes };
  }

  for (const short of [[1 / 600], [1e-4], [1e-6], [1e-9], [1e-17], [1e-300], [1e-9, 1e-6, 1e-3]]) {
    const name = short.join(', then ');
    for (const [what, height, steps, most] of [
      ['a tower', 0, 120, 0.3],
      ['what falls', 3, 20, 20],
    ] as const) {
      it(`${what} is not thrown about by one of ${name} s now and then`, () => {
        const { world, boxes } = boxesOn(height);
        for (let i = 0; i < steps; i += 1) {
          world.step(1 / 60);
        }
        let fastest = 0;
        for (let i = 0; i < 30; i += 1) {
          for (const deltaTime of [...short, 1 / 60, 1 / 60, 1 / 60, 1 / 60]) {
            world.step(deltaTime);
            fastest = Math.max(fastest, ...boxes.map(speed));
          }
        }
        expect(fastest).toBeLessThan(most);
      });
    }
  }
});

/** What is rigid and what is loose, and stands. */
const STANDS: Record<string, (world: World) => void> = {
  'a pyramid': (world) => {
    addFloor(world);
    for (let row = 0; row < 10; row += 1) {
      for (let i = 0; i < 10 - row; i += 1) {
        world.addRigidBody(boxBody(1, 1, { position: [i - (9 - row) / 2, -row] }));
      }
    }
  },
  'a house of planks': (world) => {
    addFloor(world);
    for (let storey = 0; storey < 5; storey += 1) {
      const y = 0.5 - 1.7 * storey;
      for (const x of [-0.8, 0.8]) {
        world.addRigidBody(boxBody(0.3, 1.5, { position: [x, y - 0.75] }));
      }
      world.addRigidBody(boxBody(2.2, 0.2, { position: [0, y - 1.6] }));
    }
  },
  'a heap': (world) => {
    const walls: [number, number, number, number][] = [
      [0, 1, 20, 1],
      [-3.5, -4, 1, 10],
      [3.5, -4, 1, 10],
    ];
    for (const [x, y, width, height] of walls) {
      world.addRigidBody(boxBody(width, height, { type: 'static', position: [x, y] }));
    }
    for (let i = 0; i < 100; i += 1) {
      const position: Vec2 = [-2.5 + (i % 10) * 0.55 + (i % 3) * 0.01, -0.3 - Math.floor(i / 10) * 0.55];
      const shapes = [i % 2 === 0 ? box(0.45, 0.45) : disc(0.25)];
      world.addRigidBody(phys2D.createRigidBody({ position, shapes }));
    }
  },
  'a welded beam on two blocks, with a stack on it': (world) => {
    addFloor(world);
    let last: RigidBody | null = null;
    for (let i = 0; i < 8; i += 1) {
      const piece = boxBody(1, 0.3, { position: [i - 3.5, -0.5] });
      world.addRigidBody(piece);
      if (last !== null) {
        const anchors = { anchorA: [0.5, 0], anchorB: [-0.5, 0] } as const;
        world.addConstraint(
          phys2D.createWeldConstraint({ bodyA: last, bodyB: piece, ...anchors, ignoreInteractions: true }),
        );
      }
      last = piece;
    }
    for (const x of [-3.5, 3.5]) {
      world.addRigidBody(boxBody(0.5, 0.84, { position: [x, 0.08] }));
    }
    for (let i = 0; i < 3; i += 1) {
      world.addRigidBody(boxBody(0.7, 0.7, { position: [0, -1 - 0.7 * i] }));
    }
  },
};

// Where a frame took a step and the rest of its time as another one, pyramids crept by a decimetre in half a minute, houses fell, and nothing slept.
describe.each([
  ['1/60 and 1/300 s by turns', [1 / 60, 1 / 300]],
  ['1/60 and 1/144 s by turns', [1 / 60, 1 / 144]],
  ['1/30 and 1/240 s by turns', [1 / 30, 1 / 240]],
  ['1/60 s and the rest of a frame at 58 a second', [1 / 60, 1 / 58 - 1 / 60]],
  ['1/60 s, and three of 1e-6 s now and then, as the game is paused', [...new Array(9).fill(1 / 60), 1e-6, 1e-6, 1e-6]],
  ['1/60 s, and one of 1/600 s in thirty', [...new Array(29).fill(1 / 60), 1 / 600]],
])('in steps of %s', (_, lengths: number[]) => {
  it.each(Object.entries(STANDS))('%s comes to rest', (_name, build) => {
    const world = phys2D.createWorld({ gravity: [0, 10] });
    build(world);
    const run = (seconds: number, look = () => {}) => {
      let time = 0;
      for (let i = 0; time < seconds; i += 1) {
        const deltaTime = lengths[i % lengths.length]!;
        world.step(deltaTime);
        time += deltaTime;
        look();
      }
    };
    run(10);
    const places = world.rigidBodies.map((body) => body.getPosition());
    let fastest = 0;
    run(10, () => {
      fastest = Math.max(fastest, ...world.liveDynamics.map(speed));
    });
    const ways = world.rigidBodies.map((body, i) => {
      const [x, y] = body.getPosition();
      return Math.hypot(x - places[i]![0], y - places[i]![1]);
    });
    expect(fastest).toBeLessThan(0.01);
    expect(Math.max(...ways)).toBeLessThan(0.005);
  });
});

// Heaps were thrown up by 0.2 m, at 1 m/s, in the first step after a second of slow motion.
describe.each([
  ['a tenth', () => 1 / 600],
  ['a hundredth', () => 1 / 6000],
  [
    'a tenth, to which and from which it comes bit by bit',
    (i: number) => 1 / Math.min(600, 60 + 15 * i, 75 + 15 * (199 - i)),
  ],
])('slow motion of %s', (_, lengthOf: (i: number) => number) => {
  it.each(Object.entries(STANDS))('ends without a jolt: %s', (_name, build) => {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    build(world);
    for (let i = 0; i < 900; i += 1) {
      world.step(1 / 60);
    }
    for (let i = 0; i < 200; i += 1) {
      world.step(lengthOf(i));
    }
    let fastest = 0;
    for (let i = 0; i < 60; i += 1) {
      world.step(1 / 60);
      fastest = Math.max(fastest, ...world.liveDynamics.map(speed));
    }
    expect(fastest).toBeLessThan(0.005);
  });
});

describe('a step of 0.25 s after those of 1/240 s', () => {
  function afterHitch(world: World): number {
    world.step(0.25);
    let fastest = 0;
    for (let i = 0; i < 240; i += 1) {
      world.step(1 / 240);
      fastest = Math.max(fastest, ...world.liveDynamics.map(speed));
    }
    return fastest;
  }

  it.each(['a tower', 'a house of planks'])('does not shake %s', (what) => {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    STANDS[what]?.(world);
    if (what === 'a tower') {
      addFloor(world);
      for (let i = 0; i < 15; i += 1) world.addRigidBody(boxBody(1, 1, { position: [0, -0.5 - i] }));
    }
    for (let i = 0; i < 720; i += 1) {
      world.step(1 / 240);
    }
    expect(afterHitch(world)).toBeLessThan(0.2);
  });

  // With the impulses that carried what is gone, or its weight, it was thrown up at 0.7 m/s and more.
  it.each(['gravity', 'its upper half'])('does not throw up a tower that lost %s', (lost) => {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    addFloor(world);
    const tower = Array.from({ length: 12 }, (_, i) => boxBody(1, 0.8, { position: [0.02 * (i % 2), -0.4 - 0.8 * i] }));
    for (const body of tower) world.addRigidBody(body);
    for (let i = 0; i < 720; i += 1) {
      world.step(1 / 240);
    }
    if (lost === 'gravity') world.setGravity([0, 0]);
    else for (const body of tower.slice(6)) world.removeRigidBody(body);
    expect(afterHitch(world)).toBeLessThan(0.1);
  });

  // With the impulses of the blow it was thrown up at 38 m/s.
  it('does not throw up a heavy ball that has just landed on a pyramid', () => {
    for (let steps = 0; steps < 8; steps += 1) {
      const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
      STANDS['a pyramid']!(world);
      const material = phys2D.createMaterial({ density: 5 });
      const ball = phys2D.createRigidBody({
        position: [0.3, -11],
        velocity: [0, 8],
        shapes: [phys2D.createCircleShape({ radius: 0.6, material })],
      });
      world.addRigidBody(ball);
      while (!ball.shapes[0]!.arbiters.some((pair) => pair.active)) {
        world.step(1 / 240);
      }
      for (let i = 0; i < steps; i += 1) {
        world.step(1 / 240);
      }
      expect(afterHitch(world)).toBeLessThan(8);
    }
  });
});
