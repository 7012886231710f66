import { describe, expect, it } from 'vitest';
import { phys2D, type RigidBody } from '../../src/index.js';
import { disc, steps, weightless } from '../conformance/setting.js';
import { generator } from '../scenes/mixed.js';

// Which pairs interact, against a model that knows nothing of broadphases, caches and islands.

const TYPES = ['dynamic', 'dynamic', 'kinematic', 'static'] as const;
/** m. What the solver may find within a step. */
const LATE = 0.1;

describe('interactions', () => {
  it.each([1, 2, 3, 4, 5, 6, 7, 8])('are those of a simple model, program %i', (seed) => {
    const random = generator(seed);
    const pick = <T>(list: readonly T[]): T => list[Math.floor(random() * list.length)]!;
    const place = (): [number, number] => [random() * 6, random() * 6];
    const world = weightless({
      broadphase: seed % 2 ? phys2D.createBoxTreeBroadphase() : phys2D.createSweepAndPruneBroadphase(),
    });
    const bodies = Array.from({ length: 12 }, () => {
      const velocity = random() < 0.4 ? [0, 0] : [random() * 4 - 2, random() * 4 - 2];
      const filter = { sensor: random() < 0.3, group: pick([1, 2, 3]), mask: pick([1, 2, 3, 3]) };
      const shapes = [disc(0.2 + random() * 0.5, filter)];
      return phys2D.createRigidBody({ type: pick(TYPES), position: place(), velocity, linearDrag: 0.9, shapes });
    });
    for (const body of bodies) {
      world.addRigidBody(body);
    }
    const changes: ((body: RigidBody) => void)[] = [
      (body) => body.sleep(),
      (body) => body.wake(),
      (body) => body.setPosition(place()),
      (body) => body.setVelocity([random() - 0.5, random() - 0.5]),
      (body) => body.setAsDynamic(),
      (body) => body.setAsKinematic(),
      (body) => body.setAsStatic(),
      (body) => body.shapes[0]!.setMask(pick([1, 2, 3])),
    ];
    const shapeOf = (body: RigidBody) => body.shapes[0] as ReturnType<typeof disc>;
    const runs = (a: RigidBody, b: RigidBody): boolean =>
      shapeOf(a).arbiters.some(
        ({ shapeA, shapeB, active, sleeping }) =>
          (shapeA === shapeOf(b) || shapeB === shapeOf(b)) && (active || sleeping),
      );
    const gap = (a: RigidBody, b: RigidBody): number => {
      const [ax, ay] = a.getPosition();
      const [bx, by] = b.getPosition();
      return Math.hypot(bx - ax, by - ay) - shapeOf(a).getRadius() - shapeOf(b).getRadius();
    };
    const may = (a: RigidBody, b: RigidBody): boolean => {
      const [s, t] = [shapeOf(a), shapeOf(b)];
      const kinds = s.sensor || t.sensor ? !(a.isStatic() && b.isStatic()) : a.isDynamic() || b.isDynamic();
      return kinds && (s.getGroup() & t.getMask()) !== 0 && (t.getGroup() & s.getMask()) !== 0;
    };
    let interactions = 0;
    for (let i = 0; i < 300; i += 1) {
      if (random() < 0.3) {
        pick(changes)(pick(bodies));
      }
      const expectations = bodies.flatMap((a, k) =>
        bodies.slice(k + 1).map((b) => {
          const frozen = a.sleeping && b.sleeping;
          const apart = gap(a, b);
          const late = may(a, b) && apart < LATE;
          return { a, b, frozen, late, expected: frozen ? runs(a, b) : may(a, b) && apart <= 0 };
        }),
      );
      steps(world, 1);
      for (const { a, b, frozen, late, expected } of expectations) {
        const found = runs(a, b);
        interactions += found ? 1 : 0;
        const excused = frozen ? !(a.sleeping && b.sleeping) : found && late;
        expect(found === expected || excused, `step ${i}: ${shapeOf(a).id}, ${shapeOf(b).id}`).toBe(true);
      }
    }
    expect(interactions).toBeGreaterThan(50);
  });
});
