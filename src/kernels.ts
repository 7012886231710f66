import { plain } from './solver/loops.js';
import { type Room, Scratch } from './solver/scratch.js';

/** The type of `WorldParams.kernels`: `simdKernels`. */
export class Kernels {
  /** The arrays that worlds share. Only held by the worlds that used them: without these they are collected. */
  private shared: WeakRef<Scratch> | null = null;

  /** @internal */
  constructor(private readonly allot: (size: number) => Room) {}

  /**
   * Whether WebAssembly with 128-bit vectors is available and allowed (a page's `Content-Security-Policy` has to allow
   * `'wasm-unsafe-eval'`). If not, worlds solve contacts and joints in plain TypeScript, with the same results to the bit.
   */
  isSupported(): boolean {
    return this.find().room.loops !== plain;
  }

  /** @internal lends arrays for a step, unless another world has them: callbacks within a step may step other worlds */
  lend(user: object, latest: Scratch | null): Scratch {
    let scratch = latest;
    if (!isFree(scratch, user)) scratch = this.find();
    if (!isFree(scratch, user)) scratch = this.renew();
    scratch.user = user;
    return scratch;
  }

  private find(): Scratch {
    return this.shared?.deref() ?? this.renew();
  }

  private renew(): Scratch {
    const scratch = new Scratch(this.allot);
    this.shared = new WeakRef(scratch);
    return scratch;
  }
}

/** Whether `user` can have it for a step. A world whose step threw goes on with its own. */
function isFree(scratch: Scratch | null, user: object): scratch is Scratch {
  return scratch !== null && (scratch.user === null || scratch.user === user);
}

/** @internal */
export function allotPlain(size: number): Room {
  return { buffer: new ArrayBuffer(size), loops: plain, pointKernels: null };
}

/** @internal */
export const plainKernels = /* @__PURE__ */ new Kernels(allotPlain);
