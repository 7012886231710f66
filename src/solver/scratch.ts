import { POINT_STRIDE } from './joints/joint-layout.js';
import type { PointKernels } from './joints/kernels/points.js';
import { BODY_STRIDE, ONE_STRIDE, TWO_STRIDE } from './layout.js';
import type { Loops } from './loops.js';

/** Bytes. Below this, WebAssembly keeps numbers of its own. */
const START = 2048;

/** Initial room for bodies, contacts and joints, each. */
const FEWEST = 64;

/**
 * A buffer, and the loops that work on it: over bodies and contacts, and over rigid point joints and their bodies, if there are others than
 * those in TypeScript.
 */
export interface Room {
  readonly buffer: ArrayBuffer;
  readonly loops: Loops;
  readonly pointKernels: PointKernels | null;
}

/**
 * The arrays that the loops read and write, side by side in one buffer, as the loops in WebAssembly need them. None of it outlives a step,
 * so worlds share it. It grows by doubling, into another buffer. A memory of WebAssembly that grew would detach its old buffer, and once
 * that has happened V8 checks for it at each access to any typed array, which is a tenth of a step.
 */
export class Scratch {
  /** Who has it for a step. */
  user: object | null = null;
  room: Room;
  /**
   * `velocity`, `motion`, `pose` and `drive` of `SolverData`; then the records of contacts of one point, of contacts of two, and of rigid
   * point joints; …
   */
  doubles: readonly Float64Array<ArrayBuffer>[] = [];
  /** … and for these three the offsets of the two bodies' records. */
  offsets: readonly Int32Array<ArrayBuffer>[] = [];
  private bodies = FEWEST;
  private ones = FEWEST;
  private twos = FEWEST;
  private points = FEWEST;

  /** `allot` makes a room of so many bytes. */
  constructor(private readonly allot: (size: number) => Room) {
    this.room = this.lay();
  }

  /** Makes room for so many bodies, contacts of one point and of two, and rigid point joints. What is there stays. */
  reserve(bodies: number, ones: number, twos: number, points: number): void {
    if (bodies > this.bodies || ones > this.ones || twos > this.twos || points > this.points) {
      this.bodies = doubledTo(bodies, this.bodies);
      this.ones = doubledTo(ones, this.ones);
      this.twos = doubledTo(twos, this.twos);
      this.points = doubledTo(points, this.points);
      this.room = this.lay();
    }
  }

  private lay(): Room {
    const { bodies, ones, twos, points, doubles, offsets } = this;
    const ofBodies = BODY_STRIDE * bodies;
    const lengths = [
      ofBodies,
      ofBodies,
      ofBodies,
      ofBodies,
      ONE_STRIDE * ones,
      TWO_STRIDE * twos,
      POINT_STRIDE * points,
    ];
    const counts = [ones, twos, points];
    const room = this.allot(START + 8 * [...lengths, ...counts].reduce((sum, length) => sum + length));
    const { buffer } = room;
    let at = START;
    const place = <A extends Float64Array | Int32Array>(array: A, old: A | undefined): A => {
      if (old !== undefined) array.set(old);
      at += array.byteLength;
      return array;
    };
    this.doubles = lengths.map((length, i) => place(new Float64Array(buffer, at, length), doubles[i]));
    this.offsets = counts.map((count, i) => place(new Int32Array(buffer, at, 2 * count), offsets[i]));
    return room;
  }
}

function doubledTo(count: number, from: number): number {
  let size = from;
  while (size < count) {
    size *= 2;
  }
  return size;
}
