/**
 * Area, inertia and centre of a clockwise polygon given as `[x0, y0, x1, y1, …]`, by summing the triangles that each
 * edge makes with the origin (Green's theorem). Clockwise as seen on screen with y down: the sums are positive.
 */

export function polygonArea(vertices: ArrayLike<number>): number {
  let sum = 0;
  const length = vertices.length;
  for (let i = 0, j = length - 2; i < length; j = i, i += 2) {
    sum += vertices[j]! * vertices[i + 1]! - vertices[j + 1]! * vertices[i]!;
  }
  return sum / 2;
}

/** Second moment of the area about the origin, divided by the area, m². */
export function polygonMasslessInertia(vertices: ArrayLike<number>): number {
  let numerator = 0;
  let denominator = 0;
  const length = vertices.length;
  for (let i = 0, j = length - 2; i < length; j = i, i += 2) {
    const px = vertices[j]!;
    const py = vertices[j + 1]!;
    const qx = vertices[i]!;
    const qy = vertices[i + 1]!;
    const cross = px * qy - py * qx;
    numerator += cross * (px * px + py * py + qx * qx + qy * qy + px * qx + py * qy);
    denominator += cross;
  }
  return numerator / (6 * denominator);
}

/** Writes the centre of area into `out[0]`, `out[1]`. */
export function polygonCentre(vertices: ArrayLike<number>, out: { [index: number]: number }): void {
  let x = 0;
  let y = 0;
  let denominator = 0;
  const length = vertices.length;
  for (let i = 0, j = length - 2; i < length; j = i, i += 2) {
    const px = vertices[j]!;
    const py = vertices[j + 1]!;
    const qx = vertices[i]!;
    const qy = vertices[i + 1]!;
    const cross = px * qy - py * qx;
    x += (px + qx) * cross;
    y += (py + qy) * cross;
    denominator += cross;
  }
  out[0] = x / (3 * denominator);
  out[1] = y / (3 * denominator);
}
