import type { RigidBody } from '../body.js';
import type { Physics2DDebugDraw } from '../debug/draw.js';
import type { NumberSink } from '../math/vectors.js';
import type { Tape } from '../state/tape.js';
import { callable, instance, integer, options, rangeError, typeError } from '../validate.js';
import { BaseConstraint } from './constraint.js';
import type { ConstraintParams } from './params.js';
import { checkedBody } from './two-body.js';

/** Reads or writes `data[index + …]`; `this` is the constraint. Must change nothing but `data` and variables of its own. */
export type CustomCallback = (this: CustomConstraint, data: NumberSink & ArrayLike<number>, index: number) => void;

/**
 * Options of `createCustomConstraint`, with D = `dimension` and N = number of bodies. What a callback does not write is 0.
 *
 * Calls in a step: `positionConstants`, `position` (if not stiff), `jacobian`; in each velocity iteration `velocityClamp`; in each position
 * iteration, if stiff and there is a `position`: `positionConstants`, `position`, `jacobian`, `positionClamp`.
 */
export interface CustomConstraintParams extends ConstraintParams {
  /** Number of rows D, integer >= 1. */
  dimension: number;
  /** At least one; copied. A body may be listed twice. */
  bodies: ArrayLike<RigidBody>;
  /**
   * Writes the derivative of the error by the velocities: `data[index + d * 3 * N + 3 * k + c]` for row d, body k and component c (0:
   * x-velocity, 1: y-velocity, 2: angular velocity).
   */
  jacobian: CustomCallback;
  /** Writes the error C to `data[index + d]`. Without it the constraint is one of velocities alone, J·v = 0. */
  position?: CustomCallback | undefined;
  /** Called before the others, to compute what they share. Default: nothing is. */
  positionConstants?: ((this: CustomConstraint) => void) | undefined;
  /**
   * Limits the impulse `data[index + d]`, in place: the impulse of this sub-step so far times the number of sub-steps, as if the whole step
   * were like it. Without it there is no limit but `maxForce`.
   */
  velocityClamp?: CustomCallback | undefined;
  /** Limits the correction impulse `data[index + d]` of this position iteration, in place. Without it there is no limit. */
  positionClamp?: CustomCallback | undefined;
  /**
   * The variables that callbacks keep from step to step, if any: `snapshot` saves them with the world, `restore` writes them back in place,
   * and `hash` includes them. Default: nothing.
   */
  state?: Float64Array | undefined;
  /** Draws the constraint, for `Physics2DDebugDraw`. `stiff` is the option of that name. Without it the constraint is not drawn. */
  debugDraw?: ((this: CustomConstraint, debug: Physics2DDebugDraw, stiff: boolean) => void) | undefined;
}

type CallbackName = 'position' | 'jacobian' | 'velocityClamp' | 'positionClamp';

/** A constraint defined by callbacks: any number of rows and bodies, through the same solver as the built-in kinds. */
export class CustomConstraint extends BaseConstraint {
  /** Tells the kinds apart. */
  readonly type = 'CUSTOM';
  /** The bodies, in the order of the Jacobian's columns. Do not modify. */
  readonly bodies: RigidBody[];

  /** @internal a callback threw, or wrote what is not a finite number: left out for the rest of the step */
  failed = false;
  /** @internal */
  readonly callbacks: CustomConstraintParams;
  /** The array that callbacks see; of this constraint alone, so that a wrong index does no harm elsewhere. */
  private readonly data: Float64Array;

  /** @internal use `createCustomConstraint` */
  constructor(params: CustomConstraintParams) {
    const where = 'createCustomConstraint';
    const given = options(where, params, true);
    const dimension = integer(where, 'dimension', given.dimension, 1);
    const bodies = checkedBodies(where, given.bodies);
    callable(where, 'jacobian', given.jacobian);
    for (const name of ['position', 'positionConstants', 'velocityClamp', 'positionClamp', 'debugDraw'] as const) {
      if (given[name] !== undefined) {
        callable(where, name, given[name]);
      }
    }
    if (given.state !== undefined) {
      instance(where, 'state', given.state, Float64Array, 'a Float64Array');
    }
    super(where, dimension, bodies, params);
    this.bodies = [...bodies];
    this.callbacks = { ...params };
    this.positional = params.position !== undefined;
    this.data = new Float64Array(3 * dimension * bodies.length);
  }

  /** @internal The name is that of an option, so every bundle keeps it. */
  get debugDraw(): CustomConstraintParams['debugDraw'] {
    return this.callbacks.debugDraw;
  }

  /** @internal The error is only asked for where it is used: if the constraint is elastic, and in position iterations. */
  measure(_pose: Float64Array, out: Float64Array, c: number, j: number, withError: boolean): void {
    const { positionConstants } = this.callbacks;
    if (positionConstants !== undefined) {
      this.attempt(() => positionConstants.call(this));
    }
    if (withError && this.positional) {
      this.call('position', out, c, this.dimension, false);
    }
    this.call('jacobian', out, j, this.data.length, false);
  }

  /** @internal has a clamp callback, which must exist, change D numbers in place */
  clamp(name: 'velocityClamp' | 'positionClamp', out: Float64Array, at: number): void {
    this.call(name, out, at, this.dimension, true);
  }

  /** @internal what callbacks do cannot be known */
  override get drives(): boolean {
    return !this.isElastic;
  }

  /** @internal */
  override keep(tape: Tape): void {
    const { state } = this.callbacks;
    tape.size(this.dimension, 'a custom constraint of it has another dimension');
    tape.size(this.members.length, 'a custom constraint of it has more or fewer bodies');
    tape.size(state?.length ?? 0, 'the state of a custom constraint of it has another length');
    super.keep(tape);
    if (state !== undefined) {
      tape.list(state);
    }
  }

  private call(name: CallbackName, out: Float64Array, at: number, count: number, inPlace: boolean): void {
    const { data } = this;
    data.fill(0);
    for (let i = 0; inPlace && i < count; i += 1) {
      data[i] = out[at + i]!;
    }
    this.attempt(() => this.callbacks[name]!.call(this, data, 0));
    for (let i = 0; i < count && !this.failed; i += 1) {
      if (!Number.isFinite(data[i])) {
        const where = `CustomConstraint.${name} of world.constraints[${this.index}]`;
        this.fail(rangeError(where, `data[index + ${i}]`, 'a finite number', data[i]));
      }
    }
    for (let i = 0; i < count && !this.failed; i += 1) {
      out[at + i] = data[i]!;
    }
  }

  private attempt(callback: () => void): void {
    if (!this.failed) {
      try {
        callback();
      } catch (error) {
        this.fail(error);
      }
    }
  }

  private fail(error: unknown): void {
    this.failed = true;
    this.owner!.events.fail(error);
  }
}

function checkedBodies(where: string, value: unknown): RigidBody[] {
  const list = value as ArrayLike<unknown> | null | undefined;
  if (typeof list !== 'object' || list === null || !(list.length >= 1)) {
    throw typeError(where, 'bodies', 'an array of at least one RigidBody', value);
  }
  return Array.from(list, (body, i) => checkedBody(where, `bodies[${i}]`, body));
}
