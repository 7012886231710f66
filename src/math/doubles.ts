/** Numbers in one slab. */
const SLAB = 8192;

/**
 * Room for numbers that lie side by side, as they are walked through: what the engine has thousands of would take three times as much memory, and wait for
 * it, with a buffer each. A slab is freed when nothing in it is used any more.
 */
export class Slab {
  /** The one that was taken of last. */
  numbers = new Float64Array(0);
  private end = 0;

  /** Takes room for so many numbers, zero. @returns where it begins in `numbers`. */
  take(count: number): number {
    if (this.end + count > this.numbers.length) {
      this.numbers = new Float64Array(Math.max(count, SLAB));
      this.end = 0;
    }
    const start = this.end;
    this.end += count;
    return start;
  }
}

const slab = /* @__PURE__ */ new Slab();

/** Some numbers, zero: a part of a slab, unless they are many. */
export function doubles(count: number): Float64Array {
  if (count > SLAB / 64) {
    return new Float64Array(count);
  }
  const start = slab.take(count);
  return slab.numbers.subarray(start, start + count);
}

/** How many to make room for where there were so many: half as many again, as of twice as many a third is empty on the average. */
export function grown(count: number): number {
  return Math.ceil(1.5 * count);
}

/** The contents of a typed array in a longer one. */
export function widened<A extends Float64Array | Int32Array | Uint8Array>(from: A, to: A): A {
  to.set(from);
  return to;
}
