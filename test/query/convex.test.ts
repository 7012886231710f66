import { describe, expect, it } from 'vitest';
import { type Broadphase, type CastResult, phys2D, type Shape, type Vec2, type World } from '../../src/index.js';
import { add, box, near, plainBody, weightless } from '../conformance/setting.js';
import { Chance } from '../geometry/forms.js';
import { type Form, gapAlong, signedDistance } from '../geometry/reference.js';
import { Scene } from './scene.js';

const CASTS = 1000;
const EXTENT = 25;

const chance = new Chance(220);
const scene = new Scene(chance, 150, EXTENT);

/** A swept shape of the scene as others see it. */
class Swept {
  readonly rate: number;
  private readonly forms = new Map<number, Form>();

  constructor(
    readonly index: number,
    readonly shape: Shape,
  ) {
    const body = shape.body!;
    const [x, y] = body.getPosition();
    const { corners } = scene.formOf(index, body);
    let reach = 0;
    for (let i = 0; i < corners.length; i += 2) {
      reach = Math.max(reach, Math.hypot(corners[i]! - x, corners[i + 1]! - y));
    }
    this.rate = Math.hypot(...body.getVelocity()) + Math.abs(body.getAngularVelocity()) * reach;
  }

  at(t: number): Form {
    let form = this.forms.get(t);
    if (form === undefined) {
      form = scene.formOf(this.index, this.shape.body!, t);
      this.forms.set(t, form);
    }
    return form;
  }

  /** The first time with a distance below `limit` that sampling finds, where the shape could have come so near in between; or −1. */
  firstBelow(other: Form, limit: number, end: number): number {
    const search = (from: number, d: number, to: number, e: number): number => {
      if (d < limit) {
        return from;
      }
      if (0.5 * (d + e - this.rate * (to - from)) >= limit || to - from < 1e-7 * end) {
        return e < limit ? to : -1;
      }
      const middle = 0.5 * (from + to);
      const f = signedDistance(this.at(middle), other);
      const first = search(from, d, middle, f);
      return first >= 0 ? first : search(middle, f, to, e);
    };
    return search(0, signedDistance(this.at(0), other), end, signedDistance(this.at(end), other));
  }
}

/** Random velocities, the same in both worlds. */
function push(index: number): Shape[] {
  const shapes = scene.shapes.map((list) => list[index]!);
  const velocity = [chance.size(0.01, 100), chance.size(0.01, 100)].map((v) => (chance.next() < 0.5 ? -v : v));
  const spin = chance.next() < 0.4 ? 0 : chance.span(-50, 50);
  for (const { body } of shapes) {
    body!.setVelocity(velocity);
    body!.setAngularVelocity(spin);
  }
  return shapes;
}

/** The hit is on the shape's surface, the normal points from there to the swept shape, and between them there is no gap to speak of. */
function checkHit(swept: Swept, { shape, factor, hitPoint, hitNormal }: CastResult, what: string): void {
  const other = scene.forms[shape.userData as number]!;
  const there = swept.at(factor);
  const point: Form = { corners: Float64Array.from(hitPoint), radius: 0 };
  const [nx, ny] = hitNormal;
  expect(Math.abs(signedDistance(there, other)), `${what}: gap`).toBeLessThan(1e-8);
  expect(Math.abs(signedDistance(other, point)), `${what}: point on the shape`).toBeLessThan(1e-8);
  expect(Math.abs(nx * nx + ny * ny - 1), what).toBeLessThan(1e-12);
  const gap = gapAlong(other.corners, there.corners, nx, ny) - other.radius - there.radius;
  expect(Math.abs(gap), `${what}: normal`).toBeLessThan(1e-8);
}

describe('convex casts', () => {
  it(`${CASTS} of them meet what sampling finds, with both broadphases`, () => {
    let hits = 0;
    let skipped = 0;
    let worst = 0;
    for (let i = 0; i < CASTS; i += 1) {
      const index = chance.index(scene.forms.length);
      const shapes = push(index);
      const swept = new Swept(index, shapes[0]!);
      const time = chance.size(0.3, 30) / Math.max(0.1, swept.rate);
      const [one, other] = scene.worlds.map((world, w) => world.convexCast(shapes[w]!, time));
      const plain = (found: CastResult | null | undefined) => found && { ...found, shape: found.shape.userData };
      const what = `cast ${i}`;
      expect(plain(other), `${what}: broadphases differ`).toEqual(plain(one));
      const body = shapes[0]!.body!;
      const start = scene.forms.map((form) => signedDistance(swept.at(0), form));
      if (start.some((d) => d > 0 && d < 1e-6)) {
        skipped += 1;
        continue;
      }
      const end = one?.factor ?? time;
      scene.forms.forEach((form, k) => {
        if (start[k]! > 0 && start[k]! < swept.rate * time && scene.shapes[0]![k]!.body !== body) {
          const first = swept.firstBelow(form, -1e-6, end);
          expect(first, `${what}: shape ${k} was met before ${end}`).toBe(-1);
        }
      });
      if (one) {
        hits += 1;
        expect(one.factor > 0 && one.factor < time, `${what}: factor ${one.factor} of ${time}`).toBe(true);
        expect(start[one.shape.userData as number], `${what}: touched at the start`).toBeGreaterThan(0);
        expect(one.shape.body).not.toBe(body);
        checkHit(swept, one, what);
        worst = Math.max(worst, signedDistance(swept.at(one.factor), scene.forms[one.shape.userData as number]!));
      }
    }
    console.log(
      `${CASTS} convex casts: ${hits} hits, largest gap left ${worst.toExponential(1)} m; ${skipped} left out`,
    );
    expect(hits).toBeGreaterThan(CASTS / 4);
    expect(skipped).toBeLessThan(CASTS / 20);
  });

  it('the nearest that a callback accepts', () => {
    let hits = 0;
    for (let i = 0; i < CASTS / 4; i += 1) {
      const index = chance.index(scene.forms.length);
      const shapes = push(index);
      const [world] = scene.worlds;
      // What is hit when everything before it is turned down, one after the other.
      const inOrder: CastResult[] = [];
      for (let k = 0; k < 4; k += 1) {
        const before = inOrder.map(({ shape }) => shape);
        const next = world!.convexCast(shapes[0]!, 1, (_, { shape }) => !before.includes(shape));
        if (next === null) {
          break;
        }
        inOrder.push({ ...next });
      }
      hits += inOrder.length;
      inOrder.forEach(({ factor }, k) => {
        expect(factor).toBeGreaterThanOrEqual(inOrder[k - 1]?.factor ?? 0);
      });
      const wanted = inOrder.find(({ shape }) => (shape.userData as number) % 3 === 0);
      for (const [w, each] of scene.worlds.entries()) {
        const context = {};
        const found = each.convexCast(
          shapes[w]!,
          1,
          function (this: unknown, swept, { shape, factor, hitPoint, hitNormal }) {
            expect(this).toBe(context);
            expect(swept).toBe(shapes[w]);
            expect(Number.isFinite(factor + hitPoint[0] + hitPoint[1] + hitNormal[0] + hitNormal[1])).toBe(true);
            return (shape.userData as number) % 3 === 0;
          },
          context,
        );
        if (wanted !== undefined) {
          expect(found?.shape.userData).toBe(wanted.shape.userData);
          near(found!.factor, wanted.factor, 1e-12);
        }
      }
    }
    expect(hits).toBeGreaterThan(CASTS / 4);
  });

  it.each([1e3, 1e9, 1e100, 1e200, Number.MAX_VALUE])('take %d s', (time) => {
    const world = weightless();
    add(world, plainBody({ position: [9, 0] }));
    for (const [velocity, spin, factor] of [
      [[2, 0], 0, 4],
      [[2, 0], 5, 4],
      [[1e-3, 0], 50, 8000],
      [[0, 0], 5, null],
      [[-1, 0], 5, null],
    ] as const) {
      const probe = plainBody({ velocity, angularVelocity: spin }).shapes[0]!;
      const wanted = factor !== null && factor < time ? factor : null;
      const found = world.convexCast(probe, time);
      const what = `${velocity} m/s, ${spin} rad/s`;
      expect(found && Number(found.factor.toPrecision(6)), what).toBe(wanted);
    }
  });
});

describe('a shape that turns many times on its way', () => {
  it.each([
    [1, 1000],
    [1, 5000],
    [0.1, 300],
    [20, 1e5],
  ])('at %d m/s and %d rad/s meets the wall', (speed, spin) => {
    const world = weightless();
    add(world, phys2D.createRigidBody({ type: 'static', position: [10, 0], shapes: [box(1, 4)] }));
    const shape = box(1, 1);
    const body = phys2D.createRigidBody({ shapes: [shape], velocity: [speed, 0], angularVelocity: spin });
    const hit = world.convexCast(shape, 20 / speed)!;
    // At the latest when its inscribed circle would, and no sooner than the one around it.
    expect(hit.factor * speed).toBeGreaterThan(9.5 - Math.SQRT1_2 - 1e-6);
    expect(hit.factor * speed).toBeLessThan(9.5 - Math.SQRT1_2 + 0.01);
    expect(hit.hitNormal[0]).toBe(-1);
    // And one that passes it does not.
    body.setPosition([0, 2 + Math.SQRT1_2 + 1e-3]);
    expect(world.convexCast(shape, 20 / speed)).toBeNull();
    body.setPosition([20, 0]);
    expect(world.convexCast(shape, 20 / speed)).toBeNull();
  });
});

describe('a long cast across', () => {
  /** Discs on a grid, the last of which the cast meets, and two that it meets at one time. */
  const worldOf = (broadphase: Broadphase): World => {
    const world = phys2D.createWorld({ broadphase, gravity: [0, 0] });
    for (let i = 0; i < 2500; i += 1) {
      const [x, y] = [4 * (i % 50), 4 * Math.floor(i / 50)];
      if (x !== y) add(world, phys2D.createRigidBody({ type: 'static', position: [x, y], shapes: [disc()] }));
    }
    for (const position of [
      [161, 159],
      [159, 161],
    ] as Vec2[]) {
      add(world, phys2D.createRigidBody({ type: 'static', position, shapes: [disc()] }));
    }
    return world;
  };
  const disc = (): Shape => phys2D.createCircleShape({ radius: 1 });
  const probe = phys2D.createRigidBody({
    position: [0, 0],
    velocity: [10, 10],
    shapes: [phys2D.createCircleShape({ radius: 0.5 })],
  });

  it('is asked of what is near its way, not of all around it', () => {
    const broadphase = phys2D.createBoxTreeBroadphase();
    const world = worldOf(broadphase);
    let visits = 0;
    const { cast } = broadphase;
    broadphase.cast = (start, direction, limit, visit) =>
      cast!.call(broadphase, start, direction, limit, (handle) => {
        visits += 1;
        return visit(handle);
      });
    expect(world.convexCast(probe.shapes[0]!, 30)).not.toBeNull();
    expect(visits).toBeGreaterThan(0);
    expect(visits).toBeLessThan(250);
  });

  it('meets the older one of two at once, whatever the broadphase', () => {
    const hits = [phys2D.createBoxTreeBroadphase(), phys2D.createSweepAndPruneBroadphase()].map((broadphase) => {
      const world = worldOf(broadphase);
      const { shape, ...rest } = world.convexCast(probe.shapes[0]!, 30)!;
      expect(shape.body!.getPosition()).toEqual([161, 159]);
      return rest;
    });
    expect(hits[1]).toEqual(hits[0]);
  });
});
