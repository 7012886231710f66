// After Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", 1997.

/** Share of the sum of the absolute products: if the difference exceeds it, its sign is right. */
const ROUNDING = 3.3306690738754716e-16;
/** 2²⁷ + 1: cuts a number into two halves whose products are exact. */
const SPLIT = 134217729;

/**
 * On which side of the line from a to b the point c lies: twice the area of the triangle a b c, positive if it turns from the x- to the
 * y-axis. The sign is exact, and so is whether it is 0.
 */
export function orient(ax: number, ay: number, bx: number, by: number, cx: number, cy: number): number {
  const left = (ax - cx) * (by - cy);
  const right = (ay - cy) * (bx - cx);
  const area = left - right;
  if (Math.abs(area) > ROUNDING * (Math.abs(left) + Math.abs(right))) {
    return area;
  }
  const sum: number[] = [];
  addProduct(sum, ax, by);
  addProduct(sum, -ax, cy);
  addProduct(sum, -cx, by);
  addProduct(sum, -ay, bx);
  addProduct(sum, ay, cx);
  addProduct(sum, cy, bx);
  // The last part is larger than all others together.
  return sum.at(-1) ?? 0;
}

/** Adds the exact product of two numbers to a sum of parts that do not overlap. */
function addProduct(sum: number[], a: number, b: number): void {
  const product = a * b;
  const highA = high(a);
  const highB = high(b);
  const lowA = a - highA;
  const lowB = b - highB;
  add(sum, lowA * lowB - (product - highA * highB - lowA * highB - highA * lowB));
  add(sum, product);
}

function high(a: number): number {
  const large = SPLIT * a;
  return large - (large - a);
}

/** Adds a number to a sum of parts, which are sorted from the smallest on, and leaves out parts that are 0. */
function add(sum: number[], value: number): void {
  let rest = value;
  let count = 0;
  for (const part of sum) {
    const both = rest + part;
    const share = both - rest;
    const lost = rest - (both - share) + (part - share);
    if (lost !== 0) {
      sum[count] = lost;
      count += 1;
    }
    rest = both;
  }
  sum.length = count;
  if (rest !== 0) sum.push(rest);
}
