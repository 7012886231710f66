// A field of bodies that lie apart from each other, and ways for rays and boxes through it, as plain data for any engine.
import { generator } from '../dist/bench/scenes.js';

/** m. Side of the square field. */
const SIDE = 200;
/** m. Bodies are this large, measured from their middle, and this far apart from each other and from where a cast starts. */
const SMALLEST = 0.1;
const LARGEST = 2;
const GAP = 0.1;
const RAY_LENGTH = 40;
const CAST_LENGTH = 10;
/** m. Side of the box that is cast. */
export const BOX_SIDE = 0.5;

const shapeMakers = [circle, box, polygon];

/**
 * A third of the bodies each are circles, boxes, and irregular polygons of 3 to 8 corners; every other one is static. Rays and casts start
 * outside all of them, in any direction; (dx, dy) is the whole way. The box of a cast is turned by `angle`.
 */
export function createField({ bodies: bodyCount, rays, casts }) {
  const random = generator(12);
  const between = (from, to) => from + (to - from) * random();
  const bodies = [];
  const taken = [];
  const place = (radius) => {
    for (;;) {
      const at = { x: between(0, SIDE), y: between(0, SIDE), angle: between(-3, 3) };
      if (isFree(taken, at.x, at.y, radius)) {
        return at;
      }
    }
  };
  const way = (radius, length) => {
    const direction = between(-Math.PI, Math.PI);
    return { ...place(radius), dx: length * Math.cos(direction), dy: length * Math.sin(direction) };
  };
  for (let i = 0; i < bodyCount; i += 1) {
    const radius = SMALLEST * (LARGEST / SMALLEST) ** random();
    const at = place(radius);
    bodies.push({ ...at, isStatic: i % 2 === 0, shape: shapeMakers[i % 3](radius, between) });
    taken.push(at.x, at.y, radius);
  }
  return {
    bodies,
    rays: Array.from({ length: rays }, () => way(0, RAY_LENGTH)),
    casts: Array.from({ length: casts }, () => way(BOX_SIDE, CAST_LENGTH)),
  };
}

function isFree(taken, x, y, radius) {
  for (let i = 0; i < taken.length; i += 3) {
    if ((taken[i] - x) ** 2 + (taken[i + 1] - y) ** 2 < (taken[i + 2] + radius + GAP) ** 2) {
      return false;
    }
  }
  return true;
}

function circle(radius) {
  return { kind: 'circle', radius };
}

function box(radius, between) {
  const slant = between(0.25, Math.PI / 2 - 0.25);
  return { kind: 'box', width: 2 * radius * Math.cos(slant), height: 2 * radius * Math.sin(slant) };
}

function polygon(radius, between) {
  const count = Math.floor(between(3, 9));
  const corner = (_, i) => {
    const angle = ((i + between(0, 0.4)) * 2 * Math.PI) / count;
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  };
  return { kind: 'polygon', vertices: Array.from({ length: count }, corner) };
}
