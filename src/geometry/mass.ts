/**
 * Area, inertia and centre of a clockwise polygon given as `[x0, y0, x1, y1, …]`, by summing over the triangles that each edge makes with a
 * reference point (Green's theorem). Clockwise as seen on a screen with y down: the sums are positive.
 */

/**
 * The reference point, the origin or a point near the polygon; and the sums over the triangles: twice the area, six times the first
 * moments, twelve times the second moment. Scratch.
 */
const sums = { atX: 0.5, atY: 0.5, area: 0.5, x: 0.5, y: 0.5, second: 0.5 };

/**
 * One coordinate of the reference point: for a polygon that is farther from the origin than it is large, the middle of its bounds, as about
 * the origin the triangles would all but cancel; else 0.
 */
function middleIfFar(vertices: ArrayLike<number>, axis: number): number {
  let min = Infinity;
  let max = -Infinity;
  for (let i = axis; i < vertices.length; i += 2) {
    min = Math.min(min, vertices[i]!);
    max = Math.max(max, vertices[i]!);
  }
  const middle = min + (max - min) / 2;
  return Math.abs(middle) > max - min ? middle : 0;
}

function sum(vertices: ArrayLike<number>): void {
  const atX = middleIfFar(vertices, 0);
  const atY = middleIfFar(vertices, 1);
  let area = 0;
  let x = 0;
  let y = 0;
  let second = 0;
  const { length } = vertices;
  for (let i = 0, j = length - 2; i < length; j = i, i += 2) {
    const px = vertices[j]! - atX;
    const py = vertices[j + 1]! - atY;
    const qx = vertices[i]! - atX;
    const qy = vertices[i + 1]! - atY;
    const cross = px * qy - py * qx;
    area += cross;
    x += (px + qx) * cross;
    y += (py + qy) * cross;
    second += cross * (px * px + py * py + qx * qx + qy * qy + px * qx + py * qy);
  }
  sums.atX = atX;
  sums.atY = atY;
  sums.area = area;
  sums.x = x;
  sums.y = y;
  sums.second = second;
}

/** Area, m². */
export function polygonArea(vertices: ArrayLike<number>): number {
  sum(vertices);
  return sums.area / 2;
}

/** Second moment of the area about the origin, divided by the area, m². */
export function polygonMasslessInertia(vertices: ArrayLike<number>): number {
  sum(vertices);
  const { atX, atY, area, x, y, second } = sums;
  // Parallel axes: with the reference point at d from the origin, 2 · d · (the centre relative to it) + d² is added.
  return second / (6 * area) + atX * ((2 * x) / (3 * area) + atX) + atY * ((2 * y) / (3 * area) + atY);
}

/** Writes the centre of area into `out[0]`, `out[1]`. */
export function polygonCentre(vertices: ArrayLike<number>, out: { [index: number]: number }): void {
  sum(vertices);
  out[0] = sums.atX + sums.x / (3 * sums.area);
  out[1] = sums.atY + sums.y / (3 * sums.area);
}
