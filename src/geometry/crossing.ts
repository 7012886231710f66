/**
 * The input of `crosses`: x and y of the displacement, m, and by how much more than nothing the bounds may be apart, m. It writes the share
 * of the displacement after which they meet, …
 */
export const crossing = /* @__PURE__ */ new Float64Array(4);
/** … here. */
export const REACHED = 3;

/**
 * Whether bounds in `a` from `i` on meet those in `b` from `j` on as they go along the displacement, and after which share of it: along
 * each axis they overlap for an interval of it (slabs; Kay & Kajiya 1986).
 */
export function crosses(a: ArrayLike<number>, i: number, b: ArrayLike<number>, j: number): boolean {
  let from = 0;
  let to = 1;
  for (let axis = 0; axis < 2; axis += 1) {
    const min = b[j + axis]! - a[i + axis + 2]! - crossing[2]!;
    const max = b[j + axis + 2]! - a[i + axis]! + crossing[2]!;
    const way = crossing[axis]!;
    if (way !== 0) {
      from = Math.max(from, Math.min(min / way, max / way));
      to = Math.min(to, Math.max(min / way, max / way));
    } else if (min > 0 || max < 0) {
      return false;
    }
  }
  crossing[REACHED] = from;
  return from <= to;
}
