import { describe, expect, it } from 'vitest';
import * as g from '../../src/collide/layout.js';
import { overlaps, reset } from '../../src/collide/manifold.js';
import { collide } from '../../src/collide/table.js';
import { SPECULATIVE_MARGIN } from '../../src/config.js';
import { type Polygon, phys2D, type RigidBody, type Vec2 } from '../../src/index.js';
import { generator } from '../scenes/mixed.js';

// The kernels against plain geometry, written without them.

function corners(body: RigidBody): Vec2[] {
  const { vertices } = body.shapes[0] as Polygon;
  return Array.from({ length: vertices.length / 2 }, (_, i) =>
    body.transformLocalPointToWorld([vertices[2 * i]!, vertices[2 * i + 1]!]),
  );
}

/** The largest separation over the edge normals of both polygons: negative if they overlap. */
function separation(a: Vec2[], b: Vec2[]): number {
  let most = -Infinity;
  for (const [p, q] of [
    [a, b],
    [b, a],
  ] as const) {
    p.forEach(([x, y], i) => {
      const [nextX, nextY] = p[(i + 1) % p.length]!;
      const length = Math.hypot(nextX - x, nextY - y);
      const [nx, ny] = [(nextY - y) / length, -(nextX - x) / length];
      most = Math.max(most, Math.min(...q.map(([qx, qy]) => nx * (qx - x) + ny * (qy - y))));
    });
  }
  return most;
}

/** A record of a pair, and what it says. */
class Manifold {
  readonly numbers = new Float64Array(g.PAIR_NUMBERS);

  constructor() {
    reset(this.numbers, 0);
  }

  get count(): number {
    return this.numbers[g.COUNT]!;
  }

  get face(): number {
    return this.numbers[g.FACE]!;
  }

  overlaps(): boolean {
    return overlaps(this.numbers, 0);
  }
}

function meet(a: RigidBody, b: RigidBody, m = new Manifold()): Manifold {
  const [ax, ay] = a.getPosition();
  const [bx, by] = b.getPosition();
  a.place();
  b.place();
  m.numbers.set([bx - ax, by - ay, a.getRotation(), b.getRotation()]);
  collide(a.shapes[0]!, b.shapes[0]!, m.numbers, 0);
  return m;
}

function randomPolygon(random: () => number, spread: number): RigidBody {
  const sides = 3 + Math.floor(6 * random());
  const vertices = phys2D.createRegularPolygonVertices(0.3 + random(), 0.3 + random(), sides);
  return phys2D.createRigidBody({
    shapes: [phys2D.createPolygonShape({ vertices })],
    position: [spread * (random() - 0.5), spread * (random() - 0.5)],
    rotation: 6.3 * random(),
  });
}

const normalOf = (m: Manifold): Vec2 => [m.numbers[g.NX]!, m.numbers[g.NY]!];
const deepest = (m: Manifold): number => Math.min(m.numbers[g.S0]!, m.count === 2 ? m.numbers[g.S1]! : Infinity);

describe('two polygons', () => {
  it('agree with separating axes, and part along the normal by the depth', () => {
    const random = generator(1);
    let overlapping = 0;
    for (let i = 0; i < 4000; i += 1) {
      const [a, b] = [randomPolygon(random, 1.5), randomPolygon(random, 1.5)];
      const truth = separation(corners(a), corners(b));
      const m = meet(a, b);
      if (truth > SPECULATIVE_MARGIN) {
        expect(m.count).toBe(0);
      }
      if (!m.overlaps()) {
        continue;
      }
      overlapping += 1;
      const [nx, ny] = normalOf(m);
      expect(nx * nx + ny * ny).toBeCloseTo(1, 12);
      expect(truth).toBeLessThan(0);
      expect(deepest(m)).toBeGreaterThanOrEqual(truth - 1e-6);
      const [x, y] = b.getPosition();
      b.setPosition([x - (truth - 1e-6) * nx, y - (truth - 1e-6) * ny]);
      expect(separation(corners(a), corners(b))).toBeGreaterThanOrEqual(-2e-6);
    }
    expect(overlapping).toBeGreaterThan(1000);
  });

  it('see the same from both sides', () => {
    const random = generator(2);
    for (let i = 0; i < 1000; i += 1) {
      const [a, b] = [randomPolygon(random, 1), randomPolygon(random, 1)];
      const [m, n] = [meet(a, b), meet(b, a)];
      expect(n.overlaps()).toBe(m.overlaps());
      if (m.overlaps() && m.face !== n.face) {
        const [dx, dy] = [m.numbers[g.DX]!, m.numbers[g.DY]!];
        expect(n.numbers[g.NX]).toBeCloseTo(-m.numbers[g.NX]!, 9);
        expect(n.numbers[g.X1]! + dx).toBeCloseTo(m.numbers[g.X0]!, 9);
        expect(n.numbers[g.Y1]! + dy).toBeCloseTo(m.numbers[g.Y0]!, 9);
        expect(n.numbers[g.S1]).toBeCloseTo(m.numbers[g.S0]!, 9);
        expect([n.numbers[g.EDGE_A]!, n.numbers[g.EDGE_B]!]).toEqual([m.numbers[g.EDGE_B]!, m.numbers[g.EDGE_A]!]);
        expect([n.numbers[g.ID0]! ^ 1, n.numbers[g.ID1]! ^ 1]).toEqual([m.numbers[g.ID1]!, m.numbers[g.ID0]!]);
      }
    }
  });

  it('find after small motions what they would find afresh', () => {
    const random = generator(3);
    for (let i = 0; i < 200; i += 1) {
      const [a, b] = [randomPolygon(random, 1), randomPolygon(random, 1)];
      const kept = meet(a, b);
      for (let step = 0; step < 20; step += 1) {
        const [x, y] = b.getPosition();
        b.setPosition([x + 0.002 * (random() - 0.5), y + 0.002 * (random() - 0.5)]);
        b.setRotation(b.getRotation() + 0.002 * (random() - 0.5));
        meet(a, b, kept);
        const afresh = meet(a, b);
        if (kept.overlaps() && afresh.overlaps()) {
          expect(Math.abs(deepest(kept) - deepest(afresh))).toBeLessThan(0.006);
        }
      }
    }
  });

  it('notice new corners of a shape that has not moved', () => {
    const a = phys2D.createRigidBody({
      shapes: [phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1, 1) })],
    });
    const b = phys2D.createRigidBody({ shapes: [phys2D.createCircleShape({ radius: 1 })], position: [0.9, 0] });
    const square = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1, 1) });
    b.removeShape(b.shapes[0]!);
    b.addShape(square);
    const m = meet(a, b);
    expect(deepest(m)).toBeCloseTo(-0.1, 12);
    square.setVertices(phys2D.createBoxVertices(1.2, 1));
    meet(a, b, m);
    expect(deepest(m)).toBeCloseTo(-0.2, 12);
  });

  it('that touch exactly do not collide', () => {
    const box = () => phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1, 1) });
    const a = phys2D.createRigidBody({ shapes: [box()] });
    const b = phys2D.createRigidBody({ shapes: [box()], position: [1, 0] });
    expect(meet(a, b).overlaps()).toBe(false);
    expect(meet(a, b).count).toBe(2);
    const diagonal = phys2D.createRigidBody({ shapes: [box()], position: [1.005, 1.005] });
    expect(meet(a, diagonal).count).toBe(0);
  });
});

describe('circles', () => {
  const circle = (x: number, y: number, radius: number) =>
    phys2D.createRigidBody({ shapes: [phys2D.createCircleShape({ radius })], position: [x, y] });

  it('meet at the line of centres; touching counts; equal centres part along x', () => {
    const m = meet(circle(0, 0, 1), circle(1.5, 0, 1));
    expect([m.count, ...normalOf(m), m.numbers[g.X0], m.numbers[g.Y0], m.numbers[g.S0]]).toEqual([
      1, 1, 0, 0.75, 0, -0.5,
    ]);
    expect(meet(circle(0, 0, 1), circle(2, 0, 1)).overlaps()).toBe(true);
    expect(meet(circle(0, 0, 1), circle(2.01, 0, 1)).overlaps()).toBe(false);
    const same = meet(circle(0, 0, 1), circle(0, 0, 1));
    expect([...normalOf(same), same.numbers[g.S0]]).toEqual([1, 0, -2]);
  });

  it('meet a polygon at the nearest point of its outline', () => {
    const random = generator(4);
    let checked = 0;
    for (let i = 0; i < 3000; i += 1) {
      const polygon = randomPolygon(random, 0);
      const radius = 0.05 + 0.3 * random();
      const ball = circle(1.6 * (random() - 0.5), 1.6 * (random() - 0.5), radius);
      const [cx, cy] = ball.getPosition();
      const points = corners(polygon);
      let nearest = Infinity;
      let inside = true;
      points.forEach(([x, y], k) => {
        const [ex, ey] = [points[(k + 1) % points.length]![0] - x, points[(k + 1) % points.length]![1] - y];
        const t = Math.min(1, Math.max(0, ((cx - x) * ex + (cy - y) * ey) / (ex * ex + ey * ey)));
        nearest = Math.min(nearest, Math.hypot(cx - x - t * ex, cy - y - t * ey));
        inside &&= ex * (cy - y) - ey * (cx - x) >= 0;
      });
      const truth = (inside ? -nearest : nearest) - radius;
      for (const m of [meet(polygon, ball), meet(ball, polygon)]) {
        expect(m.overlaps()).toBe(truth <= 0);
        if (m.overlaps()) {
          checked += 1;
          expect(m.numbers[g.S0]).toBeCloseTo(truth, 9);
          const [nx, ny] = normalOf(m);
          expect(nx * nx + ny * ny).toBeCloseTo(1, 9);
        }
      }
    }
    expect(checked).toBeGreaterThan(1000);
  });
});
