/** Numbers in one slab. */
const SLAB = 8192;

let slab = new Float64Array(0);
let left = 0;

/**
 * Room for some numbers, zero. What the engine has thousands of lies side by side in slabs, as it is walked through: each in a buffer of its own would
 * take three times as much memory, and wait for it. A slab is freed when nothing in it is used any more.
 */
export function doubles(count: number): Float64Array {
  if (count > SLAB / 64) {
    return new Float64Array(count);
  }
  if (count > left) {
    slab = new Float64Array(SLAB);
    left = SLAB;
  }
  left -= count;
  return slab.subarray(SLAB - left - count, SLAB - left);
}
