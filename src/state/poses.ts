import type { RigidBody } from '../body.js';
import { integer, options, typeError } from '../validate.js';

/** How many numbers a body has in a pose buffer. */
export const POSE_STRIDE = 4;

/** Options of `PoseBuffer.create`. */
export interface PoseBufferParams {
  /** How many bodies there is room for, an integer from 1 to 1e9. Default: as many as `poses` has room for, or 1024. */
  capacity?: number | undefined;
  /**
   * The array to write to, with room for `capacity` bodies. On a `SharedArrayBuffer`, another thread can read it. Default: a new
   * `Float32Array`.
   */
  poses?: Float32Array | Float64Array | undefined;
}

/**
 * The poses of bodies as one array of numbers, for a renderer: x, y, cosine and sine of the rotation of each body, at four times its index.
 * A body keeps its index as long as it is tracked, even when it is removed from its world: `untrack` it then. A free index has four zeros.
 * If it is set as `world.poses`, it is updated at the end of every step, before events.
 *
 * A thread that reads while another one steps may see some bodies one step ahead of others; each number is whole.
 */
export class PoseBuffer {
  /** How many bodies there is room for. */
  readonly capacity: number;
  /** x and y in m, cosine and sine of the rotation: those of the body with index i begin at `poses[4 * i]`. */
  readonly poses: Float32Array | Float64Array;
  private readonly bodies: (RigidBody | null)[] = [];
  private readonly indices = new Map<RigidBody, number>();
  private readonly free: number[] = [];

  /** @internal use `create` */
  constructor(params?: PoseBufferParams) {
    const where = 'PoseBuffer.create';
    const { capacity, poses } = options(where, params, false);
    const isList = poses instanceof Float32Array || poses instanceof Float64Array;
    const room = isList ? Math.max(1, Math.floor(poses.length / POSE_STRIDE)) : 1024;
    this.capacity = integer(where, 'capacity', capacity === undefined ? room : capacity, 1);
    if (poses !== undefined && !(isList && poses.length >= POSE_STRIDE * this.capacity)) {
      throw typeError(where, 'poses', `a float array of ${POSE_STRIDE * this.capacity} numbers`, poses);
    }
    this.poses = poses ?? new Float32Array(POSE_STRIDE * this.capacity);
  }

  /** A buffer that tracks no body yet. @throws if an option is not valid, or `poses` has too little room. */
  static create(params?: PoseBufferParams): PoseBuffer {
    return new PoseBuffer(params);
  }

  /**
   * Tracks a body, in a world or not. @returns its index, the same one if it is tracked already. @throws RangeError if there is no room.
   */
  track(body: RigidBody): number {
    const where = 'PoseBuffer.track';
    checkBody(where, body);
    const known = this.indices.get(body);
    if (known !== undefined) {
      return known;
    }
    if (this.indices.size === this.capacity) {
      throw new RangeError(`${where}: there is room for ${this.capacity} bodies, and all of it is taken`);
    }
    const index = this.free.pop() ?? this.bodies.length;
    this.bodies[index] = body;
    this.indices.set(body, index);
    this.write(index, body);
    return index;
  }

  /** Frees the index of a body. @returns whether it was tracked. */
  untrack(body: RigidBody): boolean {
    checkBody('PoseBuffer.untrack', body);
    const index = this.indices.get(body);
    if (index === undefined) {
      return false;
    }
    this.indices.delete(body);
    this.bodies[index] = null;
    this.free.push(index);
    this.poses.fill(0, POSE_STRIDE * index, POSE_STRIDE * (index + 1));
    return true;
  }

  /** The index of a body; −1 if it is not tracked. */
  indexOf(body: RigidBody): number {
    checkBody('PoseBuffer.indexOf', body);
    return this.indices.get(body) ?? -1;
  }

  /** Writes the poses of all tracked bodies. `world.poses` is updated at the end of each step; call this after `restore` or a teleport. */
  update(): void {
    for (let i = 0; i < this.bodies.length; i += 1) {
      const body = this.bodies[i]!;
      if (body !== null) {
        this.write(i, body);
      }
    }
  }

  private write(index: number, body: RigidBody): void {
    const { poses } = this;
    const at = POSE_STRIDE * index;
    poses[at] = body.x;
    poses[at + 1] = body.y;
    poses[at + 2] = body.cos;
    poses[at + 3] = body.sin;
  }
}

/** Checks a body by its methods, as its class is in the bundle of the engine, which may be another. */
function checkBody(where: string, body: RigidBody): void {
  if (typeof body?.getRotation !== 'function') {
    throw typeError(where, 'body', 'a RigidBody', body);
  }
}
