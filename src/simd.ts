import { allotPlain, Kernels } from './kernels.js';
import type { PointKernels } from './solver/joints/kernels/points.js';
import { CROWDED, PRESSED } from './solver/layout.js';
import { type Loops, plain } from './solver/loops.js';
import type { Room } from './solver/scratch.js';
import { CODE } from './solver/simd-code.js';

/** What of WebAssembly is needed. */
interface Runtime {
  readonly Module: new (code: Uint8Array) => object;
  readonly Memory: new (size: { initial: number }) => { readonly buffer: ArrayBuffer };
  readonly Instance: new (module: object, imports: object) => { readonly exports: unknown };
}

/** The kernels: addresses of records, of the offsets of bodies, of `velocity` or `motion`, or of both; from one index to another. */
interface Exports {
  addForces: (velocity: number, drive: number, from: number, to: number) => void;
  moveOn: (velocity: number, motion: number, drive: number, from: number, to: number) => void;
  advance: (velocity: number, motion: number, drive: number, from: number, to: number) => number;
  advancePoses: (velocity: number, motion: number, pose: number, from: number, to: number) => number;
  warmStartOne: WarmStart;
  warmStartTwo: WarmStart;
  solveVelocityOne: Sweep;
  solveVelocityTwo: Sweep;
  solvePositionOne: Sweep;
  solvePositionTwo: Sweep;
  warmStartPoints: (records: number, bodies: number, v: number, pose: number, from: number, to: number) => number;
  solveVelocityPoints: Sweep;
  pushPoints: Sweep;
  pushPointsLinearly: Sweep;
  finishPoints: Sweep;
}

type WarmStart = (records: number, bodies: number, v: number, q: number, from: number, to: number) => void;
type Sweep = (records: number, bodies: number, vOrQ: number, from: number, to: number) => number;

/** Where they expect the length of the sub-step or a share, and after that the worst error of either lane. */
const STEP = 8;

/** Bytes of a page of memory. */
const PAGE = 65536;

/** `null` where there is no WebAssembly, or none with 128-bit vectors, or it is not allowed to be used; it is tried once, as a page may report each attempt. */
let compiled: object | null | undefined;

function compile({ Module }: Runtime): object | null {
  try {
    return new Module(decode(CODE));
  } catch {
    return null;
  }
}

/** Room in a memory of WebAssembly, or else plain room. */
function allotMemory(size: number): Room {
  try {
    const runtime = (globalThis as unknown as { WebAssembly: Runtime }).WebAssembly;
    const { Memory, Instance } = runtime;
    if (compiled === undefined) compiled = compile(runtime);
    if (compiled !== null) {
      const memory = new Memory({ initial: Math.ceil(size / PAGE) });
      const { exports } = new Instance(compiled, { env: { memory } });
      return {
        buffer: memory.buffer,
        loops: loopsOf(exports as Exports, new Float64Array(memory.buffer, STEP, 1)),
        pointKernels: pointKernelsOf(exports as Exports, new Float64Array(memory.buffer, STEP, 3)),
      };
    }
  } catch {
    // There is no WebAssembly, or no address left for another memory.
  }
  return allotPlain(size);
}

/**
 * The length of the sub-step goes to the kernels by way of memory: numbers with a fraction that are handed to WebAssembly are boxed once there was more than one instance, as after
 * the arrays grew.
 */
function loopsOf(kernels: Exports, step: Float64Array): Loops {
  return {
    ...plain,
    addForces: ({ velocity, drive }, from, to) => kernels.addForces(velocity.byteOffset, drive.byteOffset, from, to),
    moveOn: ({ velocity, motion, drive }, from, to, h) => {
      step[0] = h;
      kernels.moveOn(velocity.byteOffset, motion.byteOffset, drive.byteOffset, from, to);
    },
    advance: (data, from, to) => {
      const { velocity, motion, drive } = data;
      for (let k = from; k < to; k += 1) {
        k = kernels.advance(velocity.byteOffset, motion.byteOffset, drive.byteOffset, k, to);
        if (k < to) plain.advance(data, k, k + 1);
      }
    },
    warmStartOne: ({ one: { records, bodies }, velocity, motion }, from, to, h) => {
      step[0] = h;
      kernels.warmStartOne(records.byteOffset, bodies.byteOffset, velocity.byteOffset, motion.byteOffset, from, to);
    },
    warmStartTwo: ({ two: { records, bodies }, velocity, motion }, from, to, h) => {
      step[0] = h;
      kernels.warmStartTwo(records.byteOffset, bodies.byteOffset, velocity.byteOffset, motion.byteOffset, from, to);
    },
    solveVelocityOne: ({ one: { records, bodies }, velocity }, from, to, h) => {
      step[0] = h;
      return kernels.solveVelocityOne(records.byteOffset, bodies.byteOffset, velocity.byteOffset, from, to) !== 0;
    },
    solveVelocityTwo: ({ two: { records, bodies }, velocity }, from, to, h) => {
      step[0] = h;
      return kernels.solveVelocityTwo(records.byteOffset, bodies.byteOffset, velocity.byteOffset, from, to) !== 0;
    },
    solvePositionOne: (data, from, to) => {
      const { one, motion } = data;
      const { records, bodies } = one;
      const found = kernels.solvePositionOne(records.byteOffset, bodies.byteOffset, motion.byteOffset, from, to);
      data.deepCircles |= found & (CROWDED | PRESSED);
      return (found & 1) !== 0;
    },
    solvePositionTwo: ({ two: { records, bodies }, motion }, from, to) =>
      kernels.solvePositionTwo(records.byteOffset, bodies.byteOffset, motion.byteOffset, from, to) !== 0,
  };
}

/** Likewise: the share that becomes momentum, and the worst errors so far. */
function pointKernelsOf(kernels: Exports, step: Float64Array): PointKernels {
  return {
    warmStart: ({ points, pointBodies, velocity, pose, joints: { worst } }, from, to) => {
      step[1] = worst[0]!;
      step[2] = worst[1]!;
      const done = kernels.warmStartPoints(
        points.byteOffset,
        pointBodies.byteOffset,
        velocity.byteOffset,
        pose.byteOffset,
        from,
        to,
      );
      worst[0] = step[1]!;
      worst[1] = step[2]!;
      return done;
    },
    solveVelocity: ({ points, pointBodies, velocity }, from, to) =>
      kernels.solveVelocityPoints(points.byteOffset, pointBodies.byteOffset, velocity.byteOffset, from, to),
    push: ({ points, pointBodies, motion, joints: { worst } }, from, to) => {
      step[1] = worst[0]!;
      step[2] = worst[1]!;
      const done = kernels.pushPoints(points.byteOffset, pointBodies.byteOffset, motion.byteOffset, from, to);
      worst[0] = step[1]!;
      worst[1] = step[2]!;
      return done;
    },
    pushLinearly: ({ points, pointBodies, motion }, from, to) =>
      kernels.pushPointsLinearly(points.byteOffset, pointBodies.byteOffset, motion.byteOffset, from, to),
    finish: ({ points, pointBodies, velocity, joints: { share } }, from, to) => {
      step[0] = share[0]!;
      return kernels.finishPoints(points.byteOffset, pointBodies.byteOffset, velocity.byteOffset, from, to);
    },
    advancePoses: ({ velocity, motion, pose, joints: { h } }, from, to) => {
      step[0] = h;
      return kernels.advancePoses(velocity.byteOffset, motion.byteOffset, pose.byteOffset, from, to);
    },
  };
}

/**
 * The reverse of `encode` in `simd/build.mjs`: most bytes are one sign, from `(` to `~` without the backslash; others are 86 or 172 more than
 * theirs, which follows a `#` or a `$`. It is half as long as hexadecimal digits, and compresses better than these and Base64.
 */
function decode(text: string): Uint8Array {
  const bytes = new Uint8Array(text.length);
  let count = 0;
  let more = 0;
  for (let i = 0; i < text.length; i += 1) {
    const sign = text.charCodeAt(i);
    if (sign < 40) {
      more = 86 * (sign - 34);
    } else {
      bytes[count] = more + sign - (sign > 92 ? 57 : 56);
      count += 1;
      more = 0;
    }
  }
  return bytes.subarray(0, count);
}

/**
 * For `createWorld({ kernels: simdKernels })`: contacts and the joints of nets are solved two at a time, by WebAssembly with 128-bit vectors where there is such, with the same results to
 * the bit. Worlds that `phys2D` makes have it.
 */
export const simdKernels: Kernels = /* @__PURE__ */ new Kernels(allotMemory);
