import { describe, expect, it } from 'vitest';
import { phys2D, type Shape, type World } from '../../src/index.js';
import { add, box, DT, disc, weightless } from '../conformance/setting.js';

// What comes into a zone and leaves it is told of once each, also where a step ends so close to the edge that a sweep finds no gap.

const GAPS = [0, 1e-12, 1e-9, 1e-7, 5e-7, 9.9e-7, 1.1e-6, 1e-5, 1e-3];
const SPEEDS = [0.7, 2, 10, 60, 200];
const SHAPES: Readonly<Record<string, () => Shape>> = {
  disc: () => disc(0.25),
  box: () => box(0.5, 0.5),
  // Tangent to the edge with a corner.
  rhomb: () =>
    phys2D.createPolygonShape({
      vertices: [
        [0.25, 0],
        [0, 0.25],
        [-0.25, 0],
        [0, -0.25],
      ],
    }),
};

/** A zone from x = 0 to 1, and how often what passes it began and ended to be in it. */
function watch(zone: 'static' | 'kinematic', world: World): { begun: number; ended: number } {
  const shapes = [box(1, 2, { sensor: true })];
  const counts = { begun: 0, ended: 0 };
  shapes[0]!.addEventListener('begin', () => {
    counts.begun += 1;
  });
  shapes[0]!.addEventListener('end', () => {
    counts.ended += 1;
  });
  add(world, phys2D.createRigidBody({ type: zone, position: [0.5, 0], shapes }));
  return counts;
}

describe('what passes a zone', () => {
  for (const [name, shape] of Object.entries(SHAPES)) {
    for (const zone of ['static', 'kinematic'] as const) {
      it(`${name}, ${zone} zone: begins once and ends once, wherever a step ends`, () => {
        for (const gap of GAPS) {
          for (const speed of SPEEDS) {
            for (const side of [-1, 1]) {
              // The rim that comes first, or that leaves last, is at the edge at the end of the third step, but for the gap.
              for (const edge of [-0.25 - gap, -0.25 + gap, 1.25 - gap, 1.25 + gap]) {
                const world = weightless();
                const counts = watch(zone, world);
                const startsAt = edge - 3 * speed * DT;
                const isIn = startsAt > -0.25;
                const mirrored = side < 0;
                const body = phys2D.createRigidBody({
                  shapes: [shape()],
                  position: [mirrored ? 1 - startsAt : startsAt, 0],
                  velocity: [side * speed, 0],
                  linearDrag: 0,
                });
                add(world, body);
                for (let i = 0; i < 6 + Math.ceil(2 / (speed * DT)); i += 1) {
                  world.step(DT);
                }
                const what = `gap ${gap}, ${speed} m/s, to ${side}, ${isIn ? 'leaves' : 'comes'}, ${edge}`;
                expect(counts, what).toEqual({ begun: 1, ended: 1 });
              }
            }
          }
        }
      });
    }
  }
});
