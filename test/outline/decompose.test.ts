import { describe, expect, it } from 'vitest';
import { phys2D, type RigidBody, type RigidBodyParams, type Shape, type Vec2 } from '../../src/index.js';
import { decomposeOutline, simplifyOutline } from '../../src/outline/index.js';
import { generator } from '../scenes/mixed.js';

type Outline = readonly Vec2[];

function areaOf(outline: Outline): number {
  const [firstX, firstY] = outline[0]!;
  return outline.reduce((sum, [x, y], i) => {
    const [nextX, nextY] = outline[(i + 1) % outline.length]!;
    return sum + ((x - firstX) * (nextY - firstY) - (nextX - firstX) * (y - firstY)) / 2;
  }, 0);
}

function isInside(outline: Outline, [x, y]: Vec2): boolean {
  let inside = false;
  outline.forEach(([ax, ay], i) => {
    const [bx, by] = outline[(i + 1) % outline.length]!;
    if (ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax)) {
      inside = !inside;
    }
  });
  return inside;
}

/** How many corners bend inwards: each needs a cut, and a cut serves two at best. */
function notches(outline: Outline): number {
  const sign = Math.sign(areaOf(outline));
  return outline.filter(([x, y], i) => {
    const [ax, ay] = outline[(i + outline.length - 1) % outline.length]!;
    const [bx, by] = outline[(i + 1) % outline.length]!;
    return sign * ((x - ax) * (by - y) - (y - ay) * (bx - x)) < -1e-12;
  }).length;
}

/** Every part makes a polygon; all are the inside once, and of given vertices. */
function check(outline: Outline, holes: readonly Outline[] = [], tolerance = 1e-9): Vec2[][] {
  const parts = decomposeOutline(outline, holes);
  const given = new Set([outline, ...holes].flat().map(String));
  let area = 0;
  for (const part of parts) {
    expect(areaOf(part)).toBeGreaterThan(0);
    const shape = phys2D.createPolygonShape({ vertices: part });
    expect(shape.computeArea()).toBeCloseTo(areaOf(part), 9);
    expect(part.every((vertex) => given.has(String(vertex)))).toBe(true);
    area += areaOf(part);
  }
  const whole = Math.abs(areaOf(outline)) - holes.reduce((sum, hole) => sum + Math.abs(areaOf(hole)), 0);
  expect(Math.abs(area / whole - 1)).toBeLessThan(tolerance);
  return parts;
}

/** That many vertices around the origin at irregular angles and distances. */
function star(random: () => number, count: number, least = 0.2): Vec2[] {
  return Array.from({ length: count }, (_, i): Vec2 => {
    const angle = ((i + 0.8 * random()) * 2 * Math.PI) / count;
    const radius = least + (1 - least) * random();
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  });
}

const shapes: Record<string, { outline: Outline; parts: number }> = {
  'a triangle': {
    outline: [
      [0, 0],
      [1, 0],
      [0, 1],
    ],
    parts: 1,
  },
  'a box with vertices within its edges, and one given twice': {
    outline: [
      [0, 0],
      [0.5, 0],
      [1, 0],
      [1, 1],
      [1, 1],
      [0.25, 1],
      [0, 1],
      [0, 0],
    ],
    parts: 1,
  },
  'an L': {
    outline: [
      [0, 0],
      [2, 0],
      [2, 1],
      [1, 1],
      [1, 2],
      [0, 2],
    ],
    parts: 2,
  },
  'a U': {
    outline: [
      [0, 0],
      [1, 0],
      [1, 2],
      [2, 2],
      [2, 0],
      [3, 0],
      [3, 3],
      [0, 3],
    ],
    parts: 3,
  },
  'a plus': {
    outline: [
      [1, 0],
      [2, 0],
      [2, 1],
      [3, 1],
      [3, 2],
      [2, 2],
      [2, 3],
      [1, 3],
      [1, 2],
      [0, 2],
      [0, 1],
      [1, 1],
    ],
    parts: 3,
  },
  'an arrow': {
    outline: [
      [0, 0],
      [2, 1],
      [0, 2],
      [1, 1],
    ],
    parts: 2,
  },
};

describe.each(Object.entries(shapes))('%s', (_, { outline, parts }) => {
  it.each([0, 1, 2, 3])('is cut into as few parts as can be, from its vertex %i on, either way round', (first) => {
    const shifted = [...outline.slice(first), ...outline.slice(0, first)];
    expect(check(shifted)).toHaveLength(parts);
    expect(check([...shifted].reverse())).toHaveLength(parts);
  });

  it('is cut in the same way wherever it is, and turned', () => {
    for (const [angle, x] of [
      [0.3, 0],
      [1, 1000],
      [2, -1e6],
    ] as const) {
      const moved = outline.map(
        ([vx, vy]): Vec2 => [
          x + Math.cos(angle) * vx - Math.sin(angle) * vy,
          x + Math.sin(angle) * vx + Math.cos(angle) * vy,
        ],
      );
      expect(check(moved).length).toBeLessThanOrEqual(parts + 1);
    }
  });
});

describe('outlines at random', () => {
  it('are cut into parts that are all of them, about as many as corners that bend inwards', () => {
    let parts = 0;
    let inwards = 0;
    for (let seed = 1; seed <= 300; seed += 1) {
      const random = generator(seed);
      const outline = star(random, 4 + Math.floor(60 * random()), 0.05 + 0.5 * random());
      parts += check(outline).length;
      inwards += notches(outline);
    }
    console.log(`decomposeOutline: ${(parts / inwards).toFixed(2)} parts for each corner that bends inwards`);
    expect(parts / inwards).toBeLessThan(1.05);
  });

  it('of a grid, with many corners in a line, too', () => {
    for (let seed = 1; seed <= 200; seed += 1) {
      const random = generator(seed);
      const columns = 3 + Math.floor(12 * random());
      const heights = Array.from({ length: columns }, () => 1 + Math.floor(4 * random()));
      const outline: Vec2[] = [[0, 0]];
      heights.forEach((height, i) => void outline.push([i, -height], [i + 1, -height]));
      outline.push([columns, 0]);
      check(outline);
    }
  });

  it.each([1e-10, 1e-9, 1e-8, 1e-7, 1e-3])(
    'of a square of many corners that are off its edges by up to %f m',
    (noise) => {
      for (let seed = 1; seed <= 60; seed += 1) {
        const random = generator(seed);
        const off = () => noise * (random() - 0.5);
        const outline: Vec2[] = [];
        for (const [[x, y], [dx, dy]] of [
          [
            [0, 0],
            [1, 0],
          ],
          [
            [1, 0],
            [0, 1],
          ],
          [
            [1, 1],
            [-1, 0],
          ],
          [
            [0, 1],
            [0, -1],
          ],
        ] as const) {
          for (let k = 0; k < 40; k += 1) outline.push([x + (dx * k) / 40 + off(), y + (dy * k) / 40 + off()]);
        }
        check(outline, [], 1e-7);
      }
    },
  );

  it('with holes', () => {
    for (let seed = 1; seed <= 100; seed += 1) {
      const random = generator(seed);
      const outline = star(random, 12, 0.9).map(([x, y]): Vec2 => [10 * x, 10 * y]);
      const holes = Array.from({ length: 1 + Math.floor(6 * random()) }, (_, i) => {
        const [cx, cy] = [2.4 * ((i % 3) - 1) * 2, 2.5 * (Math.floor(i / 3) - 0.5) * 2];
        return star(random, 3 + Math.floor(8 * random())).map(([x, y]): Vec2 => [cx + 1.8 * x, cy + 1.8 * y]);
      });
      const around = holes.filter((hole) => isInside(hole, [0, 0]) || Math.abs(areaOf(hole)) > 0.05);
      const parts = check(outline, around);
      for (let i = 0; i < 50; i += 1) {
        const point: Vec2 = [20 * random() - 10, 20 * random() - 10];
        const covered = parts.filter((part) => isInside(part, point)).length;
        expect(covered).toBe(isInside(outline, point) && !around.some((hole) => isInside(hole, point)) ? 1 : 0);
      }
    }
  });

  it('with thousands of vertices, as of a coast, each near few others', () => {
    const random = generator(12);
    const coast = Array.from({ length: 3000 }, (_, i): Vec2 => {
      const angle = (i * 2 * Math.PI) / 3000;
      const radius = 10 + 0.2 * random() + 3 * Math.sin(5 * angle);
      return [radius * Math.cos(angle), radius * Math.sin(angle)];
    });
    expect(check(coast).length).toBeLessThan(1.2 * notches(coast));
    // All vertices asked for each took a minute, where this takes seconds.
  }, 30_000);

  it('which wind a thousand times', () => {
    const outline: Vec2[] = [];
    for (let i = 0; i <= 500; i += 1) {
      const angle = 0.1 * i;
      outline.push([(1 + angle) * Math.cos(angle), (1 + angle) * Math.sin(angle)]);
    }
    for (let i = 500; i >= 0; i -= 1) {
      const angle = 0.1 * i;
      outline.push([(2 + angle) * Math.cos(angle), (2 + angle) * Math.sin(angle)]);
    }
    expect(check(outline).length).toBeLessThan(700);
  });
});

describe('corners that nearly meet, though they are no neighbours', () => {
  it.each([1e-6, 2e-9, 1e-9, 9e-10, 1e-10, 1e-12, 1e-15])('%f m apart are in no part together', (gap) => {
    const hourglass: Outline = [
      [-1, -1],
      [1, -1],
      [gap / 2, 0],
      [1, 1],
      [-1, 1],
      [-gap / 2, 0],
    ];
    expect(check(hourglass)).toHaveLength(2);
    expect(check([...hourglass].reverse())).toHaveLength(2);
    const notched: Outline = [
      [0, 0],
      [4, 0],
      [4, 4],
      [0, 4],
      [0, 3],
      [1, 2],
      [0, 1],
    ];
    const hole: Outline = [
      [1 + gap, 2],
      [2, 1],
      [3, 2],
      [2, 3],
    ];
    expect(check(notched, [hole]).length).toBeLessThanOrEqual(7);
  });

  it('are in no part together where there are many, nor is a part that is a point', () => {
    for (let seed = 1; seed <= 200; seed += 1) {
      const random = generator(seed);
      const count = 3 + Math.floor(5 * random());
      const outline: Vec2[] = [];
      for (let i = 0; i < count; i += 1) {
        const [angle, width] = [(i * 2 * Math.PI) / count, Math.PI / count];
        const gap = 10 ** (-8 - 4 * random());
        outline.push([gap * Math.cos(angle - width), gap * Math.sin(angle - width)]);
        outline.push([Math.cos(angle - width / 2), Math.sin(angle - width / 2)]);
        outline.push([Math.cos(angle + width / 2), Math.sin(angle + width / 2)]);
      }
      check(outline);
    }
  });
});

describe('what is refused', () => {
  it.each<[string, unknown, RegExp]>([
    ['no list', 7, /^decomposeOutline: outline must be .* got 7$/],
    ['a vertex that is none', [[0, 0], [1, 0], 'b'], /^decomposeOutline: outline\[2\] must be/],
    [
      'two corners',
      [
        [0, 0],
        [1, 0],
        [0.5, 0],
      ],
      /^decomposeOutline: outline must have at least 3 corners, got /,
    ],
    [
      'a bow',
      [
        [0, 0],
        [1, 1],
        [1, 0],
        [0, 1],
      ],
      /^decomposeOutline: edges must neither cross nor touch, got the edge from vertex 0 of outline meeting that from vertex 2 of outline$/,
    ],
    [
      'an outline that touches itself at a corner',
      [
        [0, 0],
        [2, 0],
        [1, 1],
        [2, 2],
        [0, 2],
        [1, 1],
      ],
      /edges must neither cross nor touch/,
    ],
    [
      'one that goes back on itself',
      [
        [0, 0],
        [2, 0],
        [1, 0],
        [1, 1],
      ],
      /edges must neither cross nor touch|at least 3 corners/,
    ],
  ])('%s', (_, outline, message) => {
    expect(() => decomposeOutline(outline as Outline)).toThrow(message);
  });

  const square = (size: number, x = 0): Vec2[] => phys2D.createBoxVertices(size, size).map(([a, b]) => [a + x, b]);

  it('holes that are not inside, within each other, or meet the outline', () => {
    expect(() => decomposeOutline(square(1), [square(0.5, 5)])).toThrow(/holes\[0\] must be inside the outline/);
    expect(() => decomposeOutline(square(9), [square(2), square(1)])).toThrow(/holes\[1\] must be inside the outline/);
    expect(() => decomposeOutline(square(2), [square(1, 1)])).toThrow(/of outline meeting .* of holes\[0\]/);
  });

  it('a negative tolerance', () => {
    expect(() => simplifyOutline(square(1), -1)).toThrow('simplifyOutline: tolerance must be');
  });
});

const smooth = phys2D.createMaterial({ elasticity: 0, staticFriction: 0, dynamicFriction: 0 });

/** What is below a surface, down to a depth, cut into strips where that bends, and whole. */
function below(surface: readonly Vec2[], depth: number): { strips: Vec2[][]; outline: Vec2[] } {
  const [first, last] = [surface[0]!, surface.at(-1)!];
  const strips = surface
    .slice(1)
    .map(([x, y], i): Vec2[] => [surface[i]!, [x, y], [x, depth], [surface[i]![0], depth]]);
  return { strips, outline: [...surface, [last[0], depth], [first[0], depth]] };
}

/** Where something is that has slid for 4 s over pieces of ground, without friction, from 6 m/s on. */
function slideOver(parts: readonly (readonly Vec2[])[], make: () => Shape, params: RigidBodyParams): RigidBody {
  const world = phys2D.createWorld({ gravity: [0, 10] });
  const shapes = parts.map((vertices) => phys2D.createPolygonShape({ vertices, material: smooth }));
  world.addRigidBody(phys2D.createRigidBody({ type: 'static', shapes }));
  const body = phys2D.createRigidBody({ shapes: [make()], velocity: [6, 0], ...params });
  world.addRigidBody(body);
  for (let i = 0; i < 240; i += 1) {
    world.step(1 / 60);
  }
  return body;
}

describe('a landscape', () => {
  const surface = Array.from({ length: 61 }, (_, i): Vec2 => [i, 0.1 * i - 1.2 * Math.sin(0.35 * i)]);
  const { strips, outline } = below(surface, 12);

  it.each([
    ['a ball', () => phys2D.createCircleShape({ radius: 0.4 })],
    ['a box', () => phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(0.8, 0.5) })],
  ])('carries %s as one that is cut into strips does', (_, make) => {
    const ends = [strips, decomposeOutline(outline)].map((parts) =>
      slideOver(parts, make, { position: [5, -1.7] }).getPosition(),
    );
    expect(ends[1]![0]).toBeGreaterThan(15);
    expect(Math.hypot(ends[1]![0] - ends[0]![0], ends[1]![1] - ends[0]![1])).toBeLessThan(0.3);
  });

  /** J/kg. Its energy then, without drag. */
  function energyAfter(parts: readonly (readonly Vec2[])[], make: () => Shape, position: Vec2): number {
    const body = slideOver(parts, make, { position, linearDrag: 0, angularDrag: 0 });
    const [vx, vy] = body.getVelocity();
    return 0.5 * (vx * vx + vy * vy) - 10 * body.getPosition()[1];
  }

  // Where it was not looked at corners of grounds, nor at what of a velocity goes into them, the worst of sixty lost 15 J/kg more than on strips.
  it('takes no more from what slides over it than strips do: sixty of them', () => {
    const makes = [
      () => phys2D.createCircleShape({ radius: 0.4 }),
      () => phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(0.8, 0.5) }),
      () => phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(0.4, 0.4) }),
    ];
    const more: number[] = [];
    for (let seed = 1; seed <= 60; seed += 1) {
      const random = generator(seed);
      const [high, wave, phase, slope] = [0.6 + random(), 0.2 + 0.3 * random(), 6 * random(), 0.05 + 0.1 * random()];
      const width = seed % 2 === 0 ? 0.5 : 1;
      const depth = (x: number) => slope * x - high * Math.sin(wave * x + phase);
      const surface = Array.from({ length: 60 / width + 1 }, (_, i): Vec2 => [i * width, depth(i * width)]);
      const { strips, outline } = below(surface, 14);
      const make = makes[seed % 3]!;
      const from: Vec2 = [5, depth(5) - 0.6];
      more.push(energyAfter(strips, make, from) - energyAfter(decomposeOutline(outline), make, from));
    }
    more.sort((a, b) => a - b);
    console.log(
      `sixty landscapes: ${more[30]!.toFixed(3)} J/kg more in the median, ${more[59]!.toFixed(2)} in the worst`,
    );
    expect(more[30]).toBeLessThan(0.02);
    expect(more[59]).toBeLessThan(1.5);
  });
});

describe('simplifyOutline', () => {
  it('keeps what is farther off than the tolerance, and leaves out the rest', () => {
    const outline = Array.from({ length: 360 }, (_, i): Vec2 => {
      const angle = (i * Math.PI) / 180;
      return [Math.cos(angle), Math.sin(angle)];
    });
    const simple = simplifyOutline(outline, 0.01);
    expect(simple.length).toBeGreaterThan(15);
    expect(simple.length).toBeLessThan(40);
    expect(simplifyOutline(outline, 0)).toEqual(outline);
    expect(simplifyOutline(outline, 10)).toHaveLength(3);
  });

  it('of tens of thousands of vertices takes no square of them', () => {
    // A step of pixels at each vertex, as of what was traced from a picture.
    const outline = Array.from({ length: 20_000 }, (_, i): Vec2 => {
      const angle = (i * Math.PI) / 10_000;
      return [Math.cos(angle) + 3e-4 * (i % 2), Math.sin(angle)];
    });
    const simple = simplifyOutline(outline, 1e-3);
    expect(simple.length).toBeGreaterThan(40);
    expect(simple.length).toBeLessThan(200);
    check(simple);
    // Half a minute where each of them is asked for each that goes.
  }, 15_000);

  it('of outlines at random stays near, and never crosses itself', () => {
    for (let seed = 1; seed <= 100; seed += 1) {
      const random = generator(seed);
      const outline = star(random, 80, 0.3);
      const tolerance = 0.3 * random();
      const simple = simplifyOutline(outline, tolerance);
      check(simple);
      for (const vertex of outline) {
        const distances = simple.map((from, i) => distanceTo(vertex, from, simple[(i + 1) % simple.length]!));
        expect(Math.min(...distances)).toBeLessThanOrEqual(tolerance + 1e-12);
      }
    }
  });
});

function distanceTo([x, y]: Vec2, [ax, ay]: Vec2, [bx, by]: Vec2): number {
  const [dx, dy] = [bx - ax, by - ay];
  const share = Math.max(0, Math.min(1, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy)));
  return Math.hypot(x - ax - share * dx, y - ay - share * dy);
}

it('needles that are as thin as rounding are no parts', () => {
  const outline: [number, number][] = [
    [10, 10],
    [9.671040643890992, 10.944344080316782],
    [10.000001888687503, 10.000000657920602],
    [9.671042532578495, 10.94434473823738],
    [10.009446270544819, 10.00329058988543],
    [9.680580404467195, 10.947667237271954],
    [9.032103241075237, 12.839644342989441],
    [8.068775347285237, 12.50407095361668],
  ];
  check(outline, [], 1e-7);
  check([...outline].reverse(), [], 1e-7);
});
