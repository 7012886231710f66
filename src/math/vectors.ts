import { holdsNumbers, noSink } from '../validate.js';

/** Two numbers `[x, y]`: any array, tuple or typed array with at least two. Read at once, never kept. */
export type Vec2Like = ArrayLike<number>;

/** Three numbers `[x, y, w]`. */
export type Vec3Like = ArrayLike<number>;

/** An axis-aligned rectangle `[minX, minY, maxX, maxY]`. */
export type RectLike = ArrayLike<number>;

/** A 2 × 3 matrix `[m0, m1, m2, m3, m4, m5]`: x' = m0·x + m2·y + m4, y' = m1·x + m3·y + m5. */
export type Matrix23Like = ArrayLike<number>;

/** The points origin + direction · f, 0 ≤ f < maxFactor. */
export interface Ray {
  /** Where the ray starts, in world coordinates, m. */
  origin: Vec2Like;
  /** Its direction; need not be a unit vector, must not be zero. */
  direction: Vec2Like;
  /** How far the ray goes, in lengths of `direction`; may be `Infinity`. */
  maxFactor: number;
}

/** A destination for numbers: anything with writable numeric indices. */
export interface NumberSink {
  [index: number]: number;
}

/** A vector as getters return it: `[x, y]`. */
export type Vec2 = [number, number];
/** Three numbers as getters return them, such as `[x, y, angular]`. */
export type Vec3 = [number, number, number];
/** A rectangle as getters return it: `[minX, minY, maxX, maxY]`, m. */
export type Rect = [number, number, number, number];

/** Writes two numbers to `dst` and returns it; without `dst`, returns a new array. `where` is the function to name in errors. */
export function vec2<T extends NumberSink>(x: number, y: number, where: string, dst: T | undefined): T | Vec2 {
  if (dst === undefined) {
    return [x, y];
  }
  if (!holdsNumbers(dst, 2)) throw noSink(where, 'dst', dst, 2);
  try {
    dst[0] = x;
    dst[1] = y;
  } catch {
    throw noSink(where, 'dst', dst, 2);
  }
  return dst;
}

/** Writes three numbers to `dst` and returns it; without `dst`, returns a new array. `where` is the function to name in errors. */
export function vec3<T extends NumberSink>(
  x: number,
  y: number,
  w: number,
  where: string,
  dst: T | undefined,
): T | Vec3 {
  if (dst === undefined) {
    return [x, y, w];
  }
  if (!holdsNumbers(dst, 3)) throw noSink(where, 'dst', dst, 3);
  try {
    dst[0] = x;
    dst[1] = y;
    dst[2] = w;
  } catch {
    throw noSink(where, 'dst', dst, 3);
  }
  return dst;
}
