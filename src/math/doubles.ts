/** How many numbers a slab has. */
const SLAB = 8192;

/**
 * Allots room for numbers side by side, in the order in which they are walked through. With a buffer for each, the thousands of objects of
 * the engine would take three times the memory, and time to wait for it. A slab is freed when nothing in it is used any more.
 */
export class Slab {
  /** The slab that `take` last allotted from. */
  numbers = new Float64Array(0);
  private end = 0;

  /** Allots `count` numbers, all 0. @returns where they begin in `numbers`. */
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

/** An array of `count` numbers, all 0: a part of a slab, unless they are many. */
export function doubles(count: number): Float64Array {
  if (count > SLAB / 64) {
    return new Float64Array(count);
  }
  const start = slab.take(count);
  return slab.numbers.subarray(start, start + count);
}

/** The capacity to grow to from `count`: half as many again, as with twice as many a third would be empty on average. */
export function grown(count: number): number {
  return Math.ceil(1.5 * count);
}

/** Copies a typed array to the start of a longer one, and returns that. */
export function widened<A extends Float64Array | Int32Array | Uint8Array>(from: A, to: A): A {
  to.set(from);
  return to;
}
