import { EDGE_STRIDE } from '../../src/geometry/layout.js';
import type { Outline } from '../../src/geometry/outline.js';
import { phys2D, type Shape, type Vec2 } from '../../src/index.js';
import { generator } from '../scenes/mixed.js';
import type { Form } from './reference.js';

/** Random numbers of one seed. */
export class Chance {
  readonly next: () => number;

  constructor(seed: number) {
    this.next = generator(seed);
  }

  span(from: number, to: number): number {
    return from + (to - from) * this.next();
  }

  /** Evenly spread in the logarithm. */
  size(from: number, to: number): number {
    return from * (to / from) ** this.next();
  }

  index(count: number): number {
    return Math.floor(count * this.next());
  }
}

const SHAPES: ((chance: Chance, size: number) => Shape)[] = [
  (_, size) => circle(size / 2, [0, 0]),
  (chance, size) => circle(size / 2, [chance.span(-size, size), chance.span(-size, size)]),
  (chance, size) => polygon(phys2D.createBoxVertices(size, chance.span(0.05, 1) * size)),
  (_, size) => polygon(phys2D.createBoxVertices(size, size)),
  (chance, size) => polygon(phys2D.createRegularPolygonVertices(size, chance.span(0.1, 1) * size, 3 + chance.index(8))),
  (chance, size) => polygon(onEllipse(chance, size, chance.span(0.1, 1) * size, 3 + chance.index(6))),
  (chance, size) => polygon(onEllipse(chance, size, chance.size(1e-6, 1e-1) * size, 3 + chance.index(4))),
  (chance, size) => polygon(phys2D.createBoxVertices(size, chance.size(1e-6, 1e-1) * size)),
  (chance, size) => polygon(needle(size, chance.size(1e-6, 1e-1) * size, chance.next())),
];

/** A shape of a random kind and about that size: discs, boxes, ellipses, slivers, needles, some far off their origin. */
export function randomShape(chance: Chance, size: number): Shape {
  if (chance.next() < 0.01) {
    return polygon(phys2D.createRegularPolygonVertices(size, size, 64));
  }
  const shape = SHAPES[chance.index(SHAPES.length)]!(chance, size);
  if (chance.next() < 0.2) {
    shape.translate([chance.span(-2, 2) * size, chance.span(-2, 2) * size]);
  }
  return shape;
}

function circle(radius: number, origin: Vec2): Shape {
  return phys2D.createCircleShape({ radius, origin });
}

function polygon(vertices: Vec2[]): Shape {
  return phys2D.createPolygonShape({ vertices });
}

function onEllipse(chance: Chance, width: number, height: number, count: number): Vec2[] {
  const first = chance.span(0, 6);
  return Array.from({ length: count }, (_, i) => {
    const angle = first + ((i + chance.span(0, 0.7)) * 2 * Math.PI) / count;
    return [(width / 2) * Math.cos(angle), (height / 2) * Math.sin(angle)];
  });
}

function needle(length: number, width: number, at: number): Vec2[] {
  return [
    [-length / 2, 0],
    [length / 2, 0],
    [(at - 0.5) * length, width],
  ];
}

/** The form that an outline has. */
export function formOf({ corners, count, radius }: Outline): Form {
  const flat = new Float64Array(2 * count);
  for (let i = 0; i < count; i += 1) {
    flat[2 * i] = corners[EDGE_STRIDE * i]!;
    flat[2 * i + 1] = corners[EDGE_STRIDE * i + 1]!;
  }
  return { corners: flat, radius };
}
