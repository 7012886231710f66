import { plain } from './solver/loops.js';
import { type Room, Scratch } from './solver/scratch.js';

/** What `WorldParams.kernels` is: `simdKernels`. */
export class Kernels {
  /** Held by the worlds that used it: with them it goes. */
  private shared: WeakRef<Scratch> | null = null;

  /** @internal */
  constructor(private readonly allot: (size: number) => Room) {}

  /**
   * Whether WebAssembly with 128-bit vectors is there and may be used (a page's `Content-Security-Policy` has to allow `'wasm-unsafe-eval'`). Where not, worlds solve
   * contacts and joints in plain TypeScript, with the same results to the bit.
   */
  isSupported(): boolean {
    return this.find().room.loops !== plain;
  }

  /** @internal arrays for a step, for as long as no one else has them: within the step callbacks may step other worlds */
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

/** Whether someone can have it for a step; with what a step left that threw its own world goes on. */
function isFree(scratch: Scratch | null, user: object): scratch is Scratch {
  return scratch !== null && (scratch.user === null || scratch.user === user);
}

/** @internal */
export function allotPlain(size: number): Room {
  return { buffer: new ArrayBuffer(size), loops: plain, pointKernels: null };
}

/** @internal */
export const plainKernels = /* @__PURE__ */ new Kernels(allotPlain);
