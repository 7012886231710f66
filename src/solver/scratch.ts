import { BODY_STRIDE, ONE_STRIDE, TWO_STRIDE } from './layout.js';
import type { Loops } from './loops.js';

/** Bytes. Below it WebAssembly has numbers of its own. */
const START = 2048;

/** How much there is room for at first. */
const FEWEST = 64;

/** A buffer, and the loops over contacts that work on it. */
export interface Room {
  readonly buffer: ArrayBuffer;
  readonly loops: Loops;
}

/**
 * What the loops over contacts read and write, side by side in one buffer, as those in WebAssembly have to have it. None of it outlives a step, so worlds share it. It
 * grows by doubling, into another buffer: a memory of WebAssembly that grew would take its buffer from those who have it, and once there was such a case V8 asks at each access to any typed
 * array, which is a tenth of a step.
 */
export class Scratch {
  /** Who has it for a step. */
  user: object | null = null;
  loops: Loops;
  /** `velocity` and `motion` of `SolverData`, the records of contacts of one point and of two, … */
  doubles: readonly Float64Array<ArrayBuffer>[] = [];
  /** … and of these the offsets of the two bodies' records. */
  offsets: readonly Int32Array<ArrayBuffer>[] = [];
  private bodies = FEWEST;
  private ones = FEWEST;
  private twos = FEWEST;

  /** Given what makes room for so many bytes. */
  constructor(private readonly allot: (size: number) => Room) {
    this.loops = this.lay();
  }

  /** Makes room for so many bodies and contacts of one point and of two; what there was stays. */
  reserve(bodies: number, ones: number, twos: number): void {
    if (bodies > this.bodies || ones > this.ones || twos > this.twos) {
      this.bodies = doubledTo(bodies, this.bodies);
      this.ones = doubledTo(ones, this.ones);
      this.twos = doubledTo(twos, this.twos);
      this.loops = this.lay();
    }
  }

  private lay(): Loops {
    const { bodies, ones, twos, doubles, offsets } = this;
    const ofBodies = BODY_STRIDE * bodies;
    const lengths = [ofBodies, ofBodies, ONE_STRIDE * ones, TWO_STRIDE * twos];
    const { buffer, loops } = this.allot(START + 8 * (lengths.reduce((sum, length) => sum + length) + ones + twos));
    let at = START;
    const place = <A extends Float64Array | Int32Array>(array: A, old: A | undefined): A => {
      if (old !== undefined) array.set(old);
      at += array.byteLength;
      return array;
    };
    this.doubles = lengths.map((length, i) => place(new Float64Array(buffer, at, length), doubles[i]));
    this.offsets = [ones, twos].map((count, i) => place(new Int32Array(buffer, at, 2 * count), offsets[i]));
    return loops;
  }
}

function doubledTo(count: number, from: number): number {
  let size = from;
  while (size < count) {
    size *= 2;
  }
  return size;
}
