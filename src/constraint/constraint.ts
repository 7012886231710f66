import { RigidBody } from '../body.js';
import { FAR } from '../config.js';
import {
  addListener,
  bitOf,
  type Listeners,
  NO_LISTENERS,
  OF_CONSTRAINTS,
  plainListener,
  removeListener,
} from '../listeners.js';
import { type NumberSink, type Vec3, vec3 } from '../math/vectors.js';
import type { JointData } from '../solver/joints/joint-data.js';
import type { JointSolver } from '../solver/joints/joints.js';
import type { Island } from '../solver/sleep.js';
import type { Tape } from '../state/tape.js';
import type { UserDataOf } from '../user-data.js';
import { boolean, callable, instance, notNaN, optional, rangeError } from '../validate.js';
import type { World } from '../world.js';
import type { AngleConstraint } from './angle.js';
import type { CustomConstraint } from './custom.js';
import type { DistanceConstraint } from './distance.js';
import type { LineConstraint } from './line.js';
import type { MotorConstraint } from './motor.js';
import { type ConstraintConfig, type ConstraintParams, checkedConfig } from './params.js';
import type { PointConstraint } from './point.js';
import type { PulleyConstraint } from './pulley.js';
import type { WeldConstraint } from './weld.js';

/** The kinds of constraints. */
export type ConstraintType = 'POINT' | 'WELD' | 'ANGLE' | 'DISTANCE' | 'LINE' | 'MOTOR' | 'PULLEY' | 'CUSTOM';

/** The events of a constraint. */
export type ConstraintEventType = 'wake' | 'sleep' | 'break';

/** Called without arguments, `this` = the constraint. */
export type ConstraintHandler = (this: Constraint) => void;

/** A constraint of any kind. Where `constraint.type === 'MOTOR'`, it is a {@link MotorConstraint} and has a rate. */
export type Constraint =
  | AngleConstraint
  | CustomConstraint
  | DistanceConstraint
  | LineConstraint
  | MotorConstraint
  | PointConstraint
  | PulleyConstraint
  | WeldConstraint;

/** @internal what a constraint keeps from step to step */
export interface Numbers {
  /** The impulse λ of the last sub-step, which warm starts the next one. */
  readonly impulse: Float64Array;
  /** The impulses that the latest step gave to each member: x, y, angular. */
  readonly given: Float64Array;
}

/**
 * A relation between bodies that the solver maintains. It acts while it is in a world, enabled and awake, and all its dynamic bodies are in
 * that world. Static and kinematic bodies serve as anchors wherever they are, but a kinematic one moves or drives something only in a
 * world. All setters wake the constraint if they change anything.
 *
 * Each kind is defined in one place, `measure`: its position error C, one number per dimension, and the derivative of C by the velocities
 * of its bodies, the Jacobian J. All else is common: the solver drives C to zero with impulses Jᵀλ.
 */
export abstract class BaseConstraint {
  /** The kind of constraint, which tells the classes apart. */
  abstract readonly type: ConstraintType;
  /** The number of components of its error. */
  readonly dimension: number;
  /** Anything of yours. */
  userData: UserDataOf<'constraint'>;

  /** @internal its bodies in the order of the Jacobian's columns; one may be listed twice */
  readonly members: readonly RigidBody[];
  /** @internal */
  stiff = true;
  /** @internal */
  frequency = 10;
  /** @internal */
  damping = 1;
  /** @internal */
  maxForce = Infinity;
  /** @internal */
  maxError = Infinity;
  /** @internal */
  removeOnBreak = true;
  /** @internal */
  breakUnderForce = false;
  /** @internal */
  breakUnderError = false;
  /** @internal */
  ignoreInteractions = false;
  /** @internal whether it has a position error; if not, `measure` writes the velocity that J·v has to cancel in its place */
  positional = true;
  /** @internal whether it is a second point between the same bodies, which only keeps their angle: see `pinned.ts` */
  keepsAngle = false;
  /** @internal bounds of the last component of the error, if `bounded`; all others, and it too if not, are to be 0 */
  lower = 0;
  /** @internal */
  upper = 0;
  /** @internal */
  bounded = false;

  /** @internal the solver of constraints, set when it is created: a bundle without constraints has none */
  solver: JointSolver | null = null;
  /** @internal */
  owner: World | null = null;
  /** @internal */
  asleep: boolean;
  /** @internal its `wake` event waits for the next step */
  woken = false;
  /** @internal */
  enabled: boolean;
  /** @internal index in the world's list */
  index = -1;
  /** @internal index in the world's list of live ones, −1 while not in it */
  liveIndex = -1;
  /** @internal grows with each addition to a world: decides between equals. Keeps its name */
  order = 0;
  /** @internal the island it fell asleep with */
  island: Island | null = null;
  /** @internal */
  listeners: Listeners<ConstraintHandler> = NO_LISTENERS;
  private readonly numbers: Numbers;
  private keeper: JointData | null = null;
  private place = 0;
  private fetched = 0;
  /** @internal for how many steps on end its whole impulse has exceeded what `maxForce` allows */
  overloadedSteps = 0;
  /**
   * @internal if it and the constraints connected to it could not all be met in the last step: how many times these hold on to something
   * static or kinematic; else 0
   */
  unmetAnchors = 0;
  /** @internal it was changed, so that its error may have other causes than the motion of its bodies */
  fresh = true;
  /** @internal … after a step in which it was solved: it gets a whole step to reach what it now asks for */
  shifted = false;
  /** @internal the energy that a spring may give back, J; Infinity: whatever it holds */
  stored = Infinity;

  /** @internal */
  constructor(where: string, dimension: number, members: readonly RigidBody[], params: ConstraintParams) {
    const config = checkedConfig(where, params);
    this.asleep = boolean(where, 'sleeping', optional(params.sleeping, false));
    this.enabled = !boolean(where, 'disabled', optional(params.disabled, false));
    this.userData = params.userData === undefined ? null : params.userData;
    this.dimension = dimension;
    this.members = members;
    this.numbers = {
      impulse: new Float64Array(dimension),
      given: new Float64Array(3 * members.length),
    };
    Object.assign(this, config);
  }

  /**
   * @internal Writes error and Jacobian to `out`, which is 0 there, for the placements of its N bodies in `pose` (see layout.ts). The error
   * of row d goes to `c + d`; it may be left out unless `withError`. For a constraint of velocities alone it is the negative of the wanted
   * velocity. The derivatives by x, y and angle of body k go to `j + 3·N·d + 3·k` and the two places after it.
   */
  abstract measure(pose: Float64Array, out: Float64Array, c: number, j: number, withError: boolean): void;

  /** @internal */
  get impulse(): Float64Array {
    return this.fetch().impulse;
  }

  /** @internal */
  get given(): Float64Array {
    return this.fetch().given;
  }

  /** @internal From now on `keeper` has its numbers, and they are fetched when asked for: most never are. */
  keepAt(keeper: JointData, place: number): void {
    this.fetch();
    this.keeper = keeper;
    this.place = place;
    this.fetched = keeper.solved;
  }

  /** @internal Fetches its numbers from `keeper` for the last time, if that has them. */
  leave(keeper: JointData): void {
    if (this.keeper === keeper) {
      this.fetch();
      this.keeper = null;
    }
  }

  /** @internal what it keeps from step to step, up to date */
  fetch(): Numbers {
    const { keeper, numbers } = this;
    if (keeper !== null && this.fetched !== keeper.solved) {
      this.fetched = keeper.solved;
      this.solver!.fetchNumbers(keeper, this.place, numbers);
    }
    return numbers;
  }

  /** The world the constraint is in, or `null`. */
  get world(): World | null {
    return this.owner;
  }

  /** Whether it is asleep, together with its bodies or because it was put to sleep. */
  get sleeping(): boolean {
    return this.asleep;
  }

  /** Changes the options given and keeps the others. Wakes the constraint. */
  configure(params: ConstraintConfig): void {
    const config = checkedConfig('Constraint.configure', params);
    const { owner } = this;
    if (owner !== null) this.solver!.listIgnoring(this.self, false);
    if (config.ignoreInteractions) owner?.changeFilters();
    Object.assign(this, config);
    if (!this.breakUnderForce || this.maxForce === Infinity) this.overloadedSteps = 0;
    if (owner !== null) {
      this.solver!.listIgnoring(this.self, true);
      owner.jointsStale = true;
    }
    this.rouse();
  }

  /** Whether it is enabled: acts when it is in a world. */
  isEnabled(): boolean {
    return this.enabled;
  }

  /** Whether it is disabled: does nothing, even in a world. */
  isDisabled(): boolean {
    return !this.enabled;
  }

  /** Enables the constraint; it starts without earlier impulses. In a world wakes its bodies. */
  enable(): void {
    if (this.enabled) {
      return;
    }
    if (this.owner !== null) {
      this.solver!.switchOn(this.owner, this.self);
    } else {
      this.enabled = true;
      this.asleep = false;
    }
  }

  /** Disables the constraint; it stays in the world. Wakes its bodies if it was asleep. */
  disable(): void {
    if (!this.enabled) {
      return;
    }
    this.wake();
    if (this.owner !== null) {
      this.solver!.switchOff(this.owner, this.self);
    } else {
      this.enabled = false;
      this.forget();
    }
  }

  /** Wakes the constraint, without a `wake` event for itself, and its bodies. Outside a world only clears the flag. */
  wake(): void {
    if (this.owner === null) {
      this.asleep = false;
    } else {
      this.solver!.wakeConstraint(this.owner, this.self, true);
    }
  }

  /** Takes this one constraint out of the simulation, without an event. Outside a world only sets the flag. */
  sleep(): void {
    if (this.owner === null) {
      this.asleep = true;
    } else {
      this.solver!.sleepConstraint(this.owner, this.self);
    }
  }

  /**
   * The impulse `[jx, jy, jw]` that a body received in the latest step, N·s and N·m·s, jw about the body's origin; zeros for a body that
   * the constraint does not use, and once it is broken.
   */
  getImpulseForBody(body: RigidBody): Vec3;
  getImpulseForBody<T extends NumberSink>(body: RigidBody, dst: T): T;
  getImpulseForBody<T extends NumberSink>(body: RigidBody, dst?: T): T | Vec3 {
    instance('Constraint.getImpulseForBody', 'body', body, RigidBody, 'a RigidBody');
    let x = 0;
    let y = 0;
    let w = 0;
    const { given, members } = this;
    members.forEach((member, k) => {
      if (member === body) {
        x += given[3 * k]!;
        y += given[3 * k + 1]!;
        w += given[3 * k + 2]!;
      }
    });
    return vec3(x, y, w, 'Constraint.getImpulseForBody', dst);
  }

  /** Adds a handler. @returns `false` for an unknown type or a handler already present. Otherwise wakes the constraint without an event. */
  addEventListener(eventType: ConstraintEventType, handler: ConstraintHandler): boolean {
    callable('Constraint.addEventListener', 'handler', handler);
    return addListener(this, plainListener(bitOf(eventType, OF_CONSTRAINTS), handler), this);
  }

  /** Removes a handler. @returns whether it was there. */
  removeEventListener(eventType: ConstraintEventType, handler: ConstraintHandler): boolean {
    callable('Constraint.removeEventListener', 'handler', handler);
    return removeListener(this, plainListener(bitOf(eventType, OF_CONSTRAINTS), handler), this);
  }

  /** @internal the automatic wake, after a change: with a `wake` event if the constraint was asleep */
  rouse(): void {
    this.touch();
    if (this.owner === null) {
      this.asleep = false;
    } else {
      this.solver!.wakeConstraint(this.owner, this.self, false);
    }
  }

  /** @internal notes that its error may now have other causes than the motion of its bodies */
  touch(): void {
    this.shifted ||= !this.fresh;
    this.fresh = true;
    if (this.owner !== null) {
      this.owner.jointsTouched = true;
      this.owner.jointsStale ||= this.members.some((body) => body.owner !== this.owner);
    }
  }

  /** @internal the slot of a member in the solver's arrays; 0 for what the constraint's world cannot move */
  slotOf(body: RigidBody): number {
    return body.owner === this.owner ? body.slot : 0;
  }

  /** @internal forgets earlier impulses: when it acts again, whatever its error is, it is as new */
  forget(): void {
    for (const numbers of Object.values(this.fetch())) {
      numbers.fill(0);
    }
    this.overloadedSteps = 0;
    this.unmetAnchors = 0;
    this.fresh = true;
    this.shifted = false;
  }

  /** @internal writes what influences the future to a tape, or reads it; kinds that have more override it */
  keep(tape: Tape): void {
    this.stiff = tape.flag(this.stiff);
    this.removeOnBreak = tape.flag(this.removeOnBreak);
    this.breakUnderForce = tape.flag(this.breakUnderForce);
    this.breakUnderError = tape.flag(this.breakUnderError);
    this.ignoreInteractions = tape.flag(this.ignoreInteractions);
    this.asleep = tape.flag(this.asleep);
    this.woken = tape.flag(this.woken);
    this.enabled = tape.flag(this.enabled);
    this.fresh = tape.flag(this.fresh);
    this.shifted = tape.flag(this.shifted);
    this.keepsAngle = tape.flag(this.keepsAngle);
    this.overloadedSteps = tape.integer(this.overloadedSteps, 0, 0x3fffffff);
    this.unmetAnchors = tape.integer(this.unmetAnchors, 0, 0x3fffffff);
    this.stored = tape.number(this.stored);
    this.frequency = tape.number(this.frequency);
    this.damping = tape.number(this.damping);
    this.maxForce = tape.number(this.maxForce);
    this.maxError = tape.number(this.maxError);
    this.lower = tape.number(this.lower);
    const lower = tape.latest();
    this.upper = tape.number(this.upper);
    tape.require(!tape.checks || lower <= tape.latest());
    tape.list(this.impulse);
    tape.list(this.given);
  }

  /** @internal the lower bound, or −Infinity where it cannot be passed anyway */
  lowerLimit(): number {
    return this.lower;
  }

  /** @internal whether it is a spring */
  get isElastic(): boolean {
    return this.positional && !this.stiff;
  }

  /** @internal whether it may give its bodies energy that the solver cannot account for; rigid constraints, brakes and springs do not */
  get drives(): boolean {
    return false;
  }

  /** @internal itself as the union of all kinds: there are no others, which the compiler cannot know here */
  private get self(): Constraint {
    return this as unknown as Constraint;
  }

  /** @internal its class, for messages */
  get className(): string {
    return `${this.type[0]}${this.type.slice(1).toLowerCase()}Constraint`;
  }

  /** @internal */
  protected setLower(lowerBound: number): void {
    const where = `${this.className}.setLowerBound`;
    this.setBounds(where, 'lowerBound', this.checkedBound(where, 'lowerBound', lowerBound), this.upper);
  }

  /** @internal */
  protected setUpper(upperBound: number): void {
    const where = `${this.className}.setUpperBound`;
    this.setBounds(where, 'upperBound', this.lower, this.checkedBound(where, 'upperBound', upperBound));
  }

  /** @internal checks a single bound */
  protected checkedBound(where: string, name: string, bound: number): number {
    return notNaN(where, name, bound);
  }

  private setBounds(where: string, name: string, lower: number, upper: number): void {
    checkBounds(where, name, lower, upper);
    if (lower !== this.lower || upper !== this.upper) {
      this.lower = lower;
      this.upper = upper;
      this.rouse();
    }
  }
}

/** @internal throws unless the bounds are in order; `name` is the bound to blame */
export function checkBounds(where: string, name: string, lower: number, upper: number): void {
  if (lower > FAR) {
    throw rangeError(where, 'lowerBound', `a number of at most ${FAR}`, lower);
  }
  if (upper < -FAR) {
    throw rangeError(where, 'upperBound', `a number of at least ${-FAR}`, upper);
  }
  if (lower > upper) {
    const isLower = name === 'lowerBound';
    const rule = isLower ? `<= upperBound (${upper})` : `>= lowerBound (${lower})`;
    throw rangeError(where, name, rule, isLower ? lower : upper);
  }
}

/** By its type, as naming the class would put it into every bundle that has a world. */
export function isCustom(constraint: Constraint): constraint is CustomConstraint {
  return constraint.type === 'CUSTOM';
}

/** The class of all constraints, for `instanceof`. Constraints are made by `createPointConstraint` and the like. */
export const Constraint = BaseConstraint as unknown as abstract new (...args: never[]) => Constraint;
