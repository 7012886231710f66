import { describe, expect, it } from 'vitest';
import { phys2D, type RigidBody, type Shape } from '../../src/index.js';
import { add, box, DT, disc, near, steps, weightless } from '../conformance/setting.js';
import { draw, polyline, runs } from './recorder.js';

/** Segments of a circle of a radius, with the default tolerance, at 60 px per metre. */
const circleCount = (radius: number): number => Math.ceil(Math.PI / Math.acos(1 - 0.4 / (60 * radius)));

function colorOf(body: RigidBody): readonly number[] {
  return draw((debug) => debug.drawRigidBody(body))[0]!.color;
}

function bodyOf(shape: Shape, params: object = {}): RigidBody {
  return phys2D.createRigidBody({ shapes: [shape], ...params });
}

describe('outlines', () => {
  it('of polygons are their edges where the body is', () => {
    const body = bodyOf(box(2, 1), { position: [3, 4], rotation: Math.PI / 2 });
    const points = polyline(draw((debug) => debug.drawRigidBody(body)));
    expect(points).toHaveLength(5);
    // The last corner of the box first: turned by a quarter, (-1, 0.5) is at (-0.5, -1).
    near(points.flat(), [2.5, 3, 3.5, 3, 3.5, 5, 2.5, 5, 2.5, 3], 1e-12);
  });

  it('of circles have a tick along the x-axis of the body, unless that is static', () => {
    const circle = phys2D.createCircleShape({ radius: 0.6, origin: [1, 0] });
    const body = bodyOf(circle, { position: [3, 4], rotation: Math.PI / 2 });
    const segments = draw((debug) => debug.drawRigidBody(body));
    expect(segments).toHaveLength(circleCount(0.6) + 1);
    const points = polyline(segments.slice(0, -1));
    for (const [x, y] of points) {
      near(Math.hypot(x - 3, y - 5), 0.6, 1e-12);
    }
    near(segments.at(-1)!.ends, [3, 5.2, 3, 5.6], 1e-12);
    body.setAsStatic();
    expect(draw((debug) => debug.drawRigidBody(body))).toHaveLength(circleCount(0.6));
  });

  it('are up to date between steps and outside of a world, and drawing changes nothing', () => {
    const world = weightless();
    const body = bodyOf(box(1, 1));
    add(world, body);
    body.sleep();
    draw((debug) => debug.drawWorld(world));
    expect(body.sleeping).toBe(true);
    body.setPosition([5, 0]);
    const points = polyline(draw((debug) => debug.drawWorld(world)));
    near(Math.max(...points.map(([x]) => x)), 5.5);
  });

  it('show colliders and sensors as asked for', () => {
    const body = phys2D.createRigidBody({
      shapes: [box(1, 1), box(2, 2, { sensor: true }), disc(1, { sensor: true })],
    });
    const count = (showColliderShapes: boolean, showSensorShapes: boolean): number =>
      draw((debug) => {
        Object.assign(debug, { showColliderShapes, showSensorShapes });
        debug.drawRigidBody(body);
      }).length;
    expect(count(true, true)).toBe(8 + circleCount(1) + 1);
    expect(count(true, false)).toBe(4);
    expect(count(false, true)).toBe(4 + circleCount(1) + 1);
    expect(count(false, false)).toBe(0);
  });
});

describe('colours', () => {
  it.each([
    ['static', false, [1, 0.5, 0.5, 1], [0.9, 0.7, 0.7, 0.6], [1, 0.5, 0.5, 1], [0.9, 0.7, 0.7, 0.6]],
    ['kinematic', false, [0.8, 0.3, 0.8, 1], [0.8, 0.4, 0.8, 0.6], [0.8, 0.4, 0.8, 0.5], [0.8, 0.5, 0.8, 0.4]],
    ['dynamic', false, [0.5, 1, 0.5, 1], [0.7, 0.9, 0.7, 0.6], [0.5, 1, 0.5, 0.5], [0.7, 0.9, 0.7, 0.4]],
    ['static', true, [1, 0.5, 0.5, 1], [0.9, 0.7, 0.7, 0.6], [1, 0.5, 0.5, 1], [0.9, 0.7, 0.7, 0.6]],
    ['kinematic', true, [0.8, 0.3, 0.8, 1], [0.8, 0.4, 0.8, 0.6], [0.8, 0.4, 0.8, 0.5], [0.8, 0.5, 0.8, 0.4]],
    ['dynamic', true, [0.5, 1, 0.5, 1], [0.7, 0.9, 0.7, 0.6], [0.5, 1, 0.5, 0.5], [0.7, 0.9, 0.7, 0.4]],
  ] as const)('of a %s body, bullet: %s', (type, bullet, collider, sensor, sleepingCollider, sleepingSensor) => {
    for (const [isSensor, sleeping, expected] of [
      [false, false, collider],
      [true, false, sensor],
      [false, true, sleepingCollider],
      [true, true, sleepingSensor],
    ] as const) {
      const body = bodyOf(box(1, 1, { sensor: isSensor }), { type, bullet, sleeping });
      expect(colorOf(body)).toEqual(expected);
      add(weightless(), body);
      expect(colorOf(body)).toEqual(expected);
    }
  });
});

describe('of a bullet', () => {
  it.each([
    ['that goes by half its size in a step', { velocity: [60, 0] }, [1, 1, 1, 1]],
    ['that goes by half its size aslant', { velocity: [16, 16] }, [1, 1, 1, 1]],
    ['that goes by less than half its size aslant', { velocity: [14, 14] }, [0.5, 1, 0.5, 1]],
    ['that turns fast', { angularVelocity: 4 }, [1, 1, 1, 1]],
    ['that is slow', { velocity: [10, 0], angularVelocity: 2 }, [0.5, 1, 0.5, 1]],
  ] as const)('%s', (_, params, expected) => {
    const world = weightless();
    const bullet = bodyOf(box(1, 1), { ...params, bullet: true });
    add(world, bullet);
    steps(world, 1);
    expect(colorOf(bullet)).toEqual(expected);
    bullet.bullet = false;
    expect(colorOf(bullet)).toEqual([0.5, 1, 0.5, 1]);
  });
});

describe('details', () => {
  it('of a body are its origin, and the way of the last step', () => {
    const world = weightless();
    const body = bodyOf(box(1, 1), { velocity: [3, -6], linearDrag: 0 });
    add(world, body);
    steps(world, 2);
    const [, detail] = runs(
      draw((debug) => {
        debug.showBodyDetail = true;
        debug.drawRigidBody(body);
      }),
    );
    expect(detail!.color).toEqual([0, 1, 1, 0.5]);
    const dot = detail!.segments.slice(0, -1);
    const [x, y] = body.getPosition();
    for (const point of polyline(dot)) {
      near(Math.hypot(point[0] - x, point[1] - y), 0.5 / 60, 1e-12);
    }
    near(detail!.segments.at(-1)!.ends, [x - 3 * DT, y + 6 * DT, x, y], 1e-12);
  });

  it('of a shape are its bounds, and the origin of a circle', () => {
    const circle = phys2D.createCircleShape({ radius: 0.5, origin: [1, 0] });
    const body = phys2D.createRigidBody({ shapes: [circle, box(2, 2)], position: [5, 5], rotation: Math.PI / 4 });
    const found = runs(
      draw((debug) => {
        debug.showShapeDetail = true;
        debug.drawRigidBody(body);
      }),
    );
    expect(found.map(({ color }) => color[0])).toEqual([0.5, 1, 0.5, 1]);
    const [, ofCircle, , ofBox] = found;
    expect(ofCircle!.color).toEqual([1, 1, 0, 0.5]);
    const half = Math.SQRT1_2;
    near(polyline(ofCircle!.segments.slice(0, 4))[0]!, [5 + half - 0.5, 5 + half - 0.5], 1e-12);
    near(polyline(ofCircle!.segments.slice(0, 4))[2]!, [5 + half + 0.5, 5 + half + 0.5], 1e-12);
    for (const [x, y] of polyline(ofCircle!.segments.slice(4))) {
      near(Math.hypot(x - 5 - half, y - 5 - half), 0.5 / 60, 1e-12);
    }
    expect(ofBox!.segments).toHaveLength(4);
    near(polyline(ofBox!.segments)[0]!, [5 - 2 * half, 5 - 2 * half], 1e-12);
    near(polyline(ofBox!.segments)[2]!, [5 + 2 * half, 5 + 2 * half], 1e-12);
    near(polyline(ofBox!.segments)[2]!, body.computeWorldBounds().slice(2), 1e-12);
  });
});

describe('interpolation', () => {
  it('draws between the placements before and after the last step', () => {
    const world = weightless();
    const body = bodyOf(box(1, 1), { velocity: [6, 0], angularVelocity: 3, linearDrag: 0, angularDrag: 0 });
    add(world, body);
    const outline = (interpolation: number): number[] =>
      draw((debug) => {
        debug.interpolation = interpolation;
        debug.drawWorld(world);
      }).flatMap(({ ends }) => ends);
    const atFirst = outline(1);
    expect(outline(0)).toEqual(atFirst);
    world.step(DT);
    near(outline(0), atFirst, 1e-12);
    const half = bodyOf(box(1, 1), { position: [3 * DT, 0], rotation: 1.5 * DT });
    near(
      outline(0.5),
      draw((debug) => debug.drawRigidBody(half)).flatMap(({ ends }) => ends),
      1e-12,
    );
  });

  it('does not fly a body through the picture that was moved by hand, and lets those rest that are in no world', () => {
    const world = weightless();
    const body = bodyOf(box(1, 1), { velocity: [6, 0], linearDrag: 0 });
    add(world, body);
    world.step(DT);
    body.setPosition([50, 0]);
    const left = (): number =>
      Math.min(
        ...draw((debug) => {
          debug.interpolation = 0;
          debug.drawRigidBody(body);
        }).map(({ ends }) => ends[0]),
      );
    near(left(), 49.5 - 6 * DT, 1e-12);
    world.clear();
    near(left(), 49.5, 1e-12);
  });
});
