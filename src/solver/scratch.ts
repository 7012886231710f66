import { BODY_STRIDE, ONE_STRIDE, TWO_STRIDE } from './layout.js';
import type { Loops } from './loops.js';

/** Bytes. Below it WebAssembly has numbers of its own. */
const START = 1024;

/** Bytes of a page of WebAssembly memory. */
const PAGE = 65536;

/** How much there is room for at first. */
const FEWEST = 64;

/** `WebAssembly.Memory`, which the types of the language do not have. */
export interface Memory {
  readonly buffer: ArrayBuffer;
  grow(pages: number): number;
}

/**
 * What the loops over contacts read and write, side by side in one buffer, as those in WebAssembly have to have it. None of it outlives a step, so worlds share it. It
 * grows by doubling.
 */
export class Scratch {
  /** Who has it for a step. */
  user: object | null = null;
  /** `velocity` and `motion` of `SolverData`, the records of contacts of one point and of two, … */
  doubles = [0, 0, 0, 0].map((length) => new Float64Array(length));
  /** … and of these the offsets of the two bodies' records. */
  offsets = [0, 0].map((length) => new Int32Array(length));
  private bodies = FEWEST;
  private ones = FEWEST;
  private twos = FEWEST;

  /** Without a memory it makes itself buffers. */
  constructor(
    readonly loops: Loops,
    private readonly pages: Memory | null = null,
  ) {
    this.lay();
  }

  /** Makes room for so many bodies and contacts of one point and of two; what there was stays. */
  reserve(bodies: number, ones: number, twos: number): void {
    if (bodies > this.bodies || ones > this.ones || twos > this.twos) {
      this.bodies = doubledTo(bodies, this.bodies);
      this.ones = doubledTo(ones, this.ones);
      this.twos = doubledTo(twos, this.twos);
      this.lay();
    }
  }

  private lay(): void {
    const { bodies, ones, twos } = this;
    // Copies, as a memory that grows takes itself from the arrays that were in it.
    const doubles = this.doubles.map((array) => array.slice());
    const offsets = this.offsets.map((array) => array.slice());
    const ofBodies = BODY_STRIDE * bodies;
    const lengths = [ofBodies, ofBodies, ONE_STRIDE * ones, TWO_STRIDE * twos];
    const buffer = this.bufferOf(START + 8 * (lengths.reduce((sum, length) => sum + length) + ones + twos));
    let at = START;
    this.doubles = lengths.map((length, i) => {
      const array = new Float64Array(buffer, at, length);
      array.set(doubles[i]!);
      at += array.byteLength;
      return array;
    });
    this.offsets = [ones, twos].map((count, i) => {
      const array = new Int32Array(buffer, at, 2 * count);
      array.set(offsets[i]!);
      at += array.byteLength;
      return array;
    });
  }

  private bufferOf(size: number): ArrayBuffer {
    const { pages } = this;
    if (pages === null) {
      return new ArrayBuffer(size);
    }
    const missing = size - pages.buffer.byteLength;
    if (missing > 0) {
      pages.grow(Math.ceil(missing / PAGE));
    }
    return pages.buffer;
  }
}

function doubledTo(count: number, from: number): number {
  let size = from;
  while (size < count) {
    size *= 2;
  }
  return size;
}
