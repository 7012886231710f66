import { describe, expect, it } from 'vitest';
import type { Physics2DDebugDraw } from '../../src/debug/index.js';
import { near } from '../conformance/setting.js';
import { draw, polyline, RED } from './recorder.js';

type Point = readonly [x: number, y: number];

/** px per metre in these tests. */
const SCALE = 60;

const distance = ([ax, ay]: Point, [bx, by]: Point): number => Math.hypot(bx - ax, by - ay);

/** How far the middles of the chords of a drawing are from a curve given by an angle → radius, px. */
function farthest(points: readonly Point[], radiusAt: (angle: number) => number): number {
  return Math.max(
    ...points.slice(1).map((point, i) => {
      const middle: Point = [(point[0] + points[i]![0]) / 2, (point[1] + points[i]![1]) / 2];
      const angle = Math.atan2(middle[1], middle[0]);
      return (
        SCALE *
        Math.min(...[-1, 0, 1].map((turn) => Math.abs(Math.hypot(...middle) - radiusAt(angle + 2 * Math.PI * turn))))
      );
    }),
  );
}

function draws(what: (debug: Physics2DDebugDraw) => void): readonly Point[] {
  return polyline(draw(what));
}

describe('lines and rectangles', () => {
  it('are their ends and corners, in their colour', () => {
    expect(draw((debug) => debug.drawLine(1, 2, -3, 4, [0.1, 0.2, 0.3, 0.4]))).toEqual([
      { ends: [1, 2, -3, 4], color: [0.1, 0.2, 0.3, 0.4] },
    ]);
    const rectangle = draw((debug) => debug.drawRectangle(3, 1, -1, 2, new Float32Array(RED)));
    expect(polyline(rectangle)).toEqual([
      [3, 1],
      [-1, 1],
      [-1, 2],
      [3, 2],
      [3, 1],
    ]);
    expect(rectangle.map(({ color }) => color)).toEqual(Array(4).fill([...RED]));
  });
});

describe('circles', () => {
  it.each([0.1, 0.5, 3, 10, 29, 100, 1234, 100_000])(
    'of %d px have as many segments as the error allows, and no more',
    (px) => {
      const points = draws((debug) => debug.drawCircle(2, -3, px / SCALE, RED));
      const count = points.length - 1;
      expect(count).toBe(px < 0.2 ? 3 : Math.max(3, Math.ceil(Math.PI / Math.acos(1 - 0.4 / px))));
      expect(points[0]).toEqual(points[count]);
      for (const [i, [x, y]] of points.entries()) {
        const angle = (2 * Math.PI * i) / count;
        near([x - 2, y + 3], [(px / SCALE) * Math.cos(angle), (px / SCALE) * Math.sin(angle)], 1e-12 * px);
      }
      if (count > 3) {
        const sagitta = (n: number): number => px * (1 - Math.cos(Math.PI / n));
        expect(sagitta(count)).toBeLessThanOrEqual(0.4);
        expect(sagitta(count - 1)).toBeGreaterThan(0.4);
      }
    },
  );

  it('follow circleMaxError', () => {
    const count = (error: number): number =>
      draw((debug) => {
        debug.circleMaxError = error;
        debug.drawCircle(0, 0, 1, RED);
      }).length;
    expect(count(1)).toBe(Math.ceil(Math.PI / Math.acos(1 - 1 / 60)));
    expect(count(0.001)).toBe(Math.ceil(Math.PI / Math.acos(1 - 0.001 / 60)));
    expect(count(1000)).toBe(3);
  });

  it('end, however large and fine', () => {
    expect(draw((debug) => debug.drawCircle(0, 0, 1e300, RED))).toHaveLength(16384);
    const points = draws((debug) => debug.drawCircle(0, 0, 0, RED));
    expect(points).toEqual([
      [0, 0],
      [0, 0],
      [0, 0],
      [0, 0],
    ]);
  });
});

describe('curves', () => {
  const bezier = (t: number): Point => {
    const u = 1 - t;
    return [u * u * 1 + 2 * u * t * 6 + t * t * 3, u * u * 2 + 2 * u * t * -5 + t * t * 4];
  };

  it('are halved until the error is small enough', () => {
    const points = draws((debug) => debug.drawCurve(1, 2, 6, -5, 3, 4, RED));
    const count = points.length - 1;
    expect(Math.log2(count) % 1).toBe(0);
    for (const [i, point] of points.entries()) {
      near(point, bezier(i / count), 1e-12);
    }
    // Of a piece: between the middle of the curve and that of the chord.
    const gap = (n: number): number => {
      const [a, m, b] = [bezier(0), bezier(0.5 / n), bezier(1 / n)];
      return SCALE * distance(m, [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2]);
    };
    expect(gap(count)).toBeLessThan(0.6);
    expect(gap(count / 2)).toBeGreaterThanOrEqual(0.6);
  });

  it('follow curveMaxError, down to one line', () => {
    const count = (error: number): number =>
      draw((debug) => {
        debug.curveMaxError = error;
        debug.drawCurve(0, 0, 1, 0, 1, 1, RED);
      }).length;
    const gap = (SCALE * Math.hypot(1, 1)) / 4;
    expect(count(gap + 1e-9)).toBe(1);
    expect(count(gap - 1e-9)).toBe(2);
    expect(count(gap / 16 + 1e-9)).toBe(4);
    expect(count(1e-300)).toBe(16384);
  });

  it('that are straight are one line', () => {
    expect(draws((debug) => debug.drawCurve(0, 0, 1, 1, 2, 2, RED))).toEqual([
      [0, 0],
      [2, 2],
    ]);
  });
});

describe('spirals', () => {
  it('of millions of turns end, too', () => {
    for (const end of [1e6, 1e7, 1e12]) {
      const count = draw((debug) => debug.drawSpiral(0, 0, 0, end, 1, 3, RED)).length;
      expect(count).toBeLessThan(4 * 16384);
    }
  });

  const spiral = (angle1: number, angle2: number, radius1: number, radius2: number) => (debug: Physics2DDebugDraw) =>
    debug.drawSpiral(0, 0, angle1, angle2, radius1, radius2, RED);

  it('go from end to end, with the radius in proportion to the angle', () => {
    const points = draws(spiral(-1, 2, 1, 3));
    near(points[0]!, [Math.cos(-1), Math.sin(-1)], 1e-12);
    near(points.at(-1)!, [3 * Math.cos(2), 3 * Math.sin(2)], 1e-12);
    expect(farthest(points, (angle) => 1 + (2 / 3) * (angle + 1))).toBeLessThan(1);
    expect(points.length).toBeGreaterThan(8);
  });

  it('pass through the exact points between their pieces', () => {
    const points = draws((debug) => {
      debug.curveMaxError = 1e6;
      spiral(0, 3, 2, 5)(debug);
    });
    const count = Math.ceil(3 / (Math.PI / 4));
    expect(points).toHaveLength(count + 1);
    points.forEach((point, i) => {
      const angle = (3 * i) / count;
      near(point, [(2 + angle) * Math.cos(angle), (2 + angle) * Math.sin(angle)], 1e-12);
    });
  });

  it('are the same from the other end', () => {
    expect(draw(spiral(2, -1, 3, 1))).toEqual(draw(spiral(-1, 2, 1, 3)));
  });

  it('of equal angles are nothing', () => {
    expect(draw(spiral(1, 1, 2, 5))).toEqual([]);
  });

  it('have pieces no longer than spiralMaxArc', () => {
    for (const arc of [0.1, 0.5, 2]) {
      const points = draws((debug) => {
        debug.curveMaxError = 1e6;
        debug.spiralMaxArc = arc;
        spiral(0, 5, 1, 1)(debug);
      });
      expect(points).toHaveLength(Math.ceil(5 / arc) + 1);
    }
  });

  it('around no point, through the origin, and with long pieces stay where they belong', () => {
    for (const [angle1, angle2, radius1, radius2, arc] of [
      [0, 6, 0, 0, 1],
      [0, 6, -2, 2, 1],
      [0, 6, 0, 3, 1],
      [0, 20, 1, 2, 4],
    ] as const) {
      const points = draws((debug) => {
        debug.spiralMaxArc = arc;
        spiral(angle1, angle2, radius1, radius2)(debug);
      });
      const reach = Math.max(Math.abs(radius1), Math.abs(radius2));
      for (const point of points) {
        expect(Math.hypot(...point)).toBeLessThanOrEqual(1.02 * reach);
      }
    }
  });

  it('with a piece that hardly turns are straight there: spiralEpsilon', () => {
    const count = (epsilon: number): number =>
      draw((debug) => {
        debug.spiralEpsilon = epsilon;
        spiral(0, Math.PI / 4, 50, 50)(debug);
      }).length;
    expect(count(Math.sin(Math.PI / 4) - 1e-9)).toBeGreaterThan(1);
    expect(count(Math.sin(Math.PI / 4) + 1e-9)).toBe(1);
  });

  it('of any length end', () => {
    expect(draw(spiral(0, 1e12, 1, 1)).length).toBeGreaterThan(16000);
  });
});

describe('linear springs', () => {
  const spring =
    (coils: number, radius: number, length = 3) =>
    (debug: Physics2DDebugDraw) =>
      debug.drawLinearSpring(1, 2, 1 + 0.6 * length, 2 + 0.8 * length, coils, radius, RED);

  it.each([1, 3, 7])('of %d coils are as many sine waves around the line', (coils) => {
    const points = draws(spring(coils, 0.2));
    near(points[0]!, [1, 2], 1e-12);
    near(points.at(-1)!, [2.8, 4.4], 1e-12);
    const across = points.map(([x, y]) => {
      const along = 0.6 * (x - 1) + 0.8 * (y - 2);
      const aside = 0.6 * (y - 2) - 0.8 * (x - 1);
      near(aside, 0.2 * Math.sin((2 * Math.PI * coils * along) / 3), 1e-12);
      return aside;
    });
    near(Math.max(...across), 0.2, 1e-12);
    near(Math.min(...across), -0.2, 1e-12);
    const crests = across.filter(
      (value, i) => i > 0 && Math.abs(value) > Math.abs(across[i - 1]!) && Math.abs(value) > Math.abs(across[i + 1]!),
    );
    expect(crests).toHaveLength(2 * coils);
  });

  it('have chords as near as curveMaxError asks for', () => {
    for (const radius of [0.05, 0.5, 5]) {
      const points = draws(spring(2, radius));
      const step = (2 * Math.PI * 2) / (points.length - 1);
      expect(SCALE * radius * (1 - Math.cos(step / 2))).toBeLessThanOrEqual(0.6);
    }
  });

  it('are a line without coils, without length, and below minSpringLength', () => {
    expect(draw(spring(0, 1))).toHaveLength(1);
    expect(draw(spring(-2, 1))).toHaveLength(1);
    expect(draw(spring(3, 1, 0.499 / SCALE))).toHaveLength(1);
    expect(draw(spring(3, 1, 0.501 / SCALE)).length).toBeGreaterThan(20);
    const none = draw((debug) => {
      debug.minSpringLength = 0;
      spring(3, 1, 0)(debug);
    });
    expect(none.map(({ ends }) => ends)).toEqual([[1, 2, 1, 2]]);
  });
});

describe('spiral springs', () => {
  const spring =
    (angle1: number, angle2: number, radius1: number, radius2: number, coils: number) => (debug: Physics2DDebugDraw) =>
      debug.drawSpiralSpring(0, 0, angle1, angle2, radius1, radius2, coils, RED);

  it('are spirals with sine waves on the radius', () => {
    const coils = 5;
    const [angle1, angle2, radius1, radius2] = [0.5, 3.5, 2, 2.6];
    const points = draws((debug) => {
      debug.curveMaxError = 1e6;
      spring(angle1, angle2, radius1, radius2, coils)(debug);
    });
    const count = 40 * coils;
    const slope = (radius2 - radius1) / (angle2 - angle1);
    const amplitude = 0.75 * 2 * Math.PI * slope;
    expect(points).toHaveLength(count + 1);
    points.forEach((point, i) => {
      const angle = angle1 + ((angle2 - angle1) * i) / count;
      const radius = radius1 + slope * (angle - angle1) + amplitude * Math.sin((2 * Math.PI * coils * i) / count);
      near(point, [radius * Math.cos(angle), radius * Math.sin(angle)], 1e-9);
    });
  });

  it('bend as the waves do between the points', () => {
    const [coils, radius1, radius2, angle] = [2, 400, 410, 1.5];
    const points = draws(spring(0, angle, radius1, radius2, coils));
    expect(points.length).toBeGreaterThan(3 * 40 * coils);
    const slope = (radius2 - radius1) / angle;
    const radiusAt = (at: number): number =>
      radius1 + slope * at + 0.75 * 2 * Math.PI * slope * Math.sin((2 * Math.PI * coils * at) / angle);
    expect(farthest(points, radiusAt)).toBeLessThan(1);
  });

  it('have at least a piece for each three arcs, and 40 for each coil', () => {
    const count = (angle: number, coils: number): number =>
      draw((debug) => {
        debug.curveMaxError = 1e6;
        spring(0, angle, 1, 2, coils)(debug);
      }).length;
    expect(count(1, 1)).toBe(40);
    expect(count(1000, 1)).toBe(Math.ceil(1000 / (0.75 * Math.PI)));
  });

  it('follow spiralSpringSize: without it, and without coils, they are spirals', () => {
    const radii = (size: number, coils: number): number[] =>
      draws((debug) => {
        debug.spiralSpringSize = size;
        spring(0, 2, 1, 2, coils)(debug);
      }).map((point) => Math.hypot(...point));
    expect(Math.max(...radii(0, 4))).toBeCloseTo(2, 9);
    expect(Math.max(...radii(0.75, 4))).toBeGreaterThan(3);
    expect(draw(spring(0, 2, 1, 2, 0))).toEqual(draw((debug) => debug.drawSpiral(0, 0, 0, 2, 1, 2, RED)));
  });

  it('are the same from the other end; of equal angles nothing', () => {
    expect(draw(spring(2, -1, 3, 1, 4))).toEqual(draw(spring(-1, 2, 1, 3, 4)));
    expect(draw(spring(1, 1, 3, 1, 4))).toEqual([]);
  });
});
