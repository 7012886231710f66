import type { RigidBody } from '../body.js';
import type { Constraint } from '../constraint/constraint.js';
import type { Shape } from '../shape/shape.js';
import { boolean, integer, positive, typeError } from '../validate.js';
import type { World } from '../world.js';

/** What can be called through a recorder: the world, a body, a shape, a constraint. */
type Recorded = World | RigidBody | Shape | Constraint;

/**
 * A recorded call. It refers to the object and to objects among the arguments themselves, so a recording is only for the program that made
 * it.
 */
export interface RecordedCall {
  /** The object that it was made on. */
  readonly object: Recorded;
  /** The name of a method; or of a setting that was set to the only argument. */
  readonly method: string;
  /** The arguments. Arrays and plain objects, and those in them, are copies. */
  readonly args: readonly unknown[];
}

/** The settings that `Recorder.set` sets: of a world and, the last two, of a body. */
export type RecordedSetting = 'substeps' | 'velocityIterations' | 'positionIterations' | 'allowSleeping' | 'bullet';

const SETTINGS: readonly RecordedSetting[] = [
  'substeps',
  'velocityIterations',
  'positionIterations',
  'allowSleeping',
  'bullet',
];

/** A method with two signatures; one with a single signature has it twice. */
type Overloads<A extends unknown[], B extends unknown[], R, S> = { (...args: A): R; (...args: B): S };

/** A snapshot, and the calls that were made after it, step by step. */
export interface Recording {
  /** The world as it was when the recording began. */
  readonly snapshot: ArrayBuffer;
  /** One frame for each step, in order. */
  readonly frames: readonly RecordedStep[];
}

/** The calls that a game made before a step, and the step. */
export interface RecordedStep {
  /** In the order in which they were made. */
  readonly calls: readonly RecordedCall[];
  /**
   * Not `null` if one of the calls added something, which may be in another state by now, or changed shapes of a body that is in no world.
   * A replay does not make that call and those after it, but restores the world as it was after them.
   */
  readonly added: {
    /** Index of the first such call. */
    readonly first: number;
    /** Hash of the world before it. */
    readonly before: string;
    /** Snapshot after all calls. */
    readonly after: ArrayBuffer;
  } | null;
  /** Length of the step, s. */
  readonly deltaTime: number;
  /** `world.hash()` after the step. */
  readonly hash: string;
}

/**
 * Records what a game does to a world. Make its calls through `call`, `set` and `step`; `replay` makes them again, from the same snapshot,
 * and compares the hashes.
 *
 * What handlers do is not recorded, not even through `call` and `set`, as handlers are called again in a replay. So the listeners have to
 * be the same all the time. What a handler adds, it has to create anew each time, and to find in the world later, rather than keep: where
 * something is added through the recorder, a replay goes on with the bodies of the recording. If something is added before a step, or
 * shapes of a body that is in no world are changed, the recording keeps a snapshot of the world for that step.
 */
export class Recorder {
  /** The world as it was when the recording began. */
  readonly snapshot: ArrayBuffer;
  /** The world that it records. */
  readonly world: World;
  private readonly frames: RecordedStep[] = [];
  private calls: RecordedCall[] = [];
  /** The first call since the last step that adds something, and the hash before it; the snapshot is set by the step. */
  private adding: { first: number; before: string; after: ArrayBuffer } | null = null;

  /** @internal use `create` */
  constructor(world: World) {
    if (typeof world?.snapshot !== 'function') {
      throw typeError('Recorder.create', 'world', 'a World', world);
    }
    this.world = world;
    this.snapshot = world.snapshot();
  }

  /** Starts a recording of a world, between two steps. */
  static create(world: World): Recorder {
    return new Recorder(world);
  }

  /**
   * Calls a method of the world or of one of its bodies, shapes or constraints, and records it: `recorder.call(body, 'applyImpulse', [0,
   * -5])`. Arrays and plain objects among the arguments are copied, also typed arrays, and those inside others. @returns what the method
   * returns.
   */
  call<T extends Recorded, K extends keyof T>(
    object: T,
    method: K & string,
    ...args: T[K] extends Overloads<infer A, infer B, unknown, unknown> ? A | B : never
  ): T[K] extends Overloads<never, never, infer R, infer S> ? R | S : never {
    const where = 'Recorder.call';
    const made = methodOf(where, object, method);
    const kept = args.map(copyOf);
    // A body, shape or constraint that is added may be in another state by the time of a replay, as it is in no snapshot; nor are shapes of
    // a body that is in no world.
    if ((method.startsWith('add') || changesOutside(this.world, object, method)) && !this.world.busy) {
      this.adding ??= { first: this.calls.length, before: this.world.hash(), after: this.snapshot };
    }
    const result = made.apply(object, args);
    this.note({ object, method, args: kept });
    return result as never;
  }

  /** Sets a property of the world or of one of its bodies, and records it: `recorder.set(world, 'substeps', 2)`. */
  set(object: World | RigidBody, setting: RecordedSetting, value: number | boolean): void {
    Object.assign(object, { [setting]: checkedValue('Recorder.set', object, setting, value) });
    this.note({ object, method: setting, args: [value] });
  }

  private note(call: RecordedCall): void {
    if (!this.world.busy) {
      this.calls.push(call);
    }
  }

  /** Steps the world, and records its hash; also if a handler throws, as the step is done all the same. */
  step(deltaTime: number): void {
    const { world, adding } = this;
    const { timeStamp } = world;
    if (adding !== null) adding.after = world.snapshot();
    try {
      world.step(deltaTime);
    } finally {
      if (world.timeStamp !== timeStamp) {
        this.frames.push({ calls: this.calls, added: adding, deltaTime, hash: world.hash() });
        this.calls = [];
        this.adding = null;
      }
    }
  }

  /** What was recorded up to the last step. */
  get recording(): Recording {
    return { snapshot: this.snapshot, frames: [...this.frames] };
  }
}

/**
 * Restores a world to where a recording began, and makes the recorded calls and steps again. What handlers throw in a step is not passed
 * on, as the step is done all the same.
 *
 * @returns the index of the first step whose hash differs from the recorded one, from 0; −1 if there is none.
 * @throws TypeError for what is no recording, or names what is no method or setting of the object; RangeError for a damaged snapshot, or a
 * setting that is out of range. Nothing has changed then, unless it is the snapshot of a step that is damaged.
 */
export function replay(world: World, recording: Recording): number {
  if (typeof world?.restore !== 'function') {
    throw typeError('replay', 'world', 'a World', world);
  }
  const { snapshot, frames }: Partial<Recording> = recording ?? {};
  if (!(snapshot instanceof ArrayBuffer) || !Array.isArray(frames)) {
    throw typeError('replay', 'recording', 'the recording of a Recorder', recording);
  }
  frames.forEach((frame, i) => {
    if (!isFrame(frame)) {
      throw typeError('replay', `recording.frames[${i}]`, 'a frame of a Recorder', frame);
    }
    positive('replay', `recording.frames[${i}].deltaTime`, frame.deltaTime);
    frame.calls.forEach(again);
  });
  world.restore(snapshot);
  return frames.findIndex(({ calls, added, deltaTime, hash }: RecordedStep) => {
    for (const call of calls.slice(0, added?.first)) again(call)();
    if (added) {
      if (world.hash() !== added.before) return true;
      world.restore(added.after);
    }
    stepAgain(world, deltaTime);
    return world.hash() !== hash;
  });
}

function isFrame(frame: RecordedStep | null): boolean {
  const { calls, added, hash } = Object(frame) as Partial<RecordedStep>;
  return (
    Array.isArray(calls) &&
    calls.every((call: RecordedCall | null) => Array.isArray(call?.args)) &&
    (added === null || (Number.isInteger(added?.first) && added?.after instanceof ArrayBuffer)) &&
    typeof hash === 'string'
  );
}

function stepAgain(world: World, deltaTime: number): void {
  const { timeStamp } = world;
  try {
    world.step(deltaTime);
  } catch (error) {
    if (world.timeStamp === timeStamp) {
      throw error;
    }
  }
}

/** Whether a call may change shapes of a body that is not in the world. */
function changesOutside(world: World, object: Recorded, method: string): boolean {
  if ('shapes' in object) {
    return object.world !== world && (method === 'removeShape' || method === 'alignWithOrigin');
  }
  return 'body' in object && object.body?.world !== world && !/^(?:get|is|compute)/.test(method);
}

/** A copy of an argument that callers may change and use again: arrays and plain objects, with those that are in them. */
function copyOf(argument: unknown): unknown {
  if (Array.isArray(argument)) {
    return argument.map(copyOf);
  }
  if (typeof argument === 'object' && argument !== null && Object.getPrototypeOf(argument) === Object.prototype) {
    return Object.fromEntries(Object.entries(argument).map(([key, value]) => [key, copyOf(value)]));
  }
  return ArrayBuffer.isView(argument) && 'slice' in argument ? (argument as Float64Array).slice() : argument;
}

/** A method of an object that can be recorded; not one that every object has. */
function methodOf(where: string, object: Recorded, method: string): (...args: unknown[]) => unknown {
  const isName = typeof method === 'string' && !(method in Object.prototype);
  const made = isName ? object?.[method as keyof Recorded] : undefined;
  if (typeof made !== 'function') {
    throw typeError(where, 'method', 'the name of a method of object', method);
  }
  if (/^(?:step|restore)$|EventListener$/.test(method)) {
    throw new Error(
      `${where}: ${method} is not to be called so: step has its own method, and restore and listeners cannot be recorded`,
    );
  }
  return made as unknown as (...args: unknown[]) => unknown;
}

/** The value for a setting, if it is one of those that `Recorder.set` sets. */
function checkedValue(where: string, object: Recorded, setting: string, value: unknown): unknown {
  if (!isSetting(setting)) {
    throw typeError(where, 'setting', `one of ${SETTINGS.join(', ')}`, setting);
  }
  const holder = Object(object) as Record<RecordedSetting, unknown>;
  if (!(setting in holder)) {
    throw typeError(where, 'object', `something that has ${setting}`, object);
  }
  const isFlag = typeof holder[setting] === 'boolean';
  return isFlag ? boolean(where, 'value', value) : integer(where, 'value', value, 1);
}

function isSetting(name: string): name is RecordedSetting {
  return (SETTINGS as readonly string[]).includes(name);
}

/** A function that makes a call again. @throws if it cannot be made. */
function again({ object, method, args }: RecordedCall): () => unknown {
  const where = 'replay';
  if (isSetting(method)) {
    const value = checkedValue(where, object, method, args[0]);
    return () => Object.assign(object, { [method]: value });
  }
  const made = methodOf(where, object, method);
  return () => made.apply(object, args.map(copyOf));
}
