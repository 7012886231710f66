/**
 * Steps at a fixed rate, whatever the frame rate.
 *
 * @module phys2d/runner
 */

import type { RigidBody } from './body.js';
import { ANGLE, writePose, X, Y } from './body-pose.js';
import { type NumberSink, type Vec2, vec2 } from './math/vectors.js';
import type { Recorder } from './state/recorder.js';
import { callable, integer, nonNegative, options, positive, typeError } from './validate.js';
import type { World } from './world.js';

/** The pose that `readPose` writes: scratch. */
const pose = /* @__PURE__ */ new Float64Array(3);

/** Options of `FixedStepRunner.create`. */
export interface FixedStepRunnerParams {
  /** The world to step, which nobody else should step; or its `Recorder`, through which it is stepped. */
  world: World | Recorder;
  /** Length of each step, s, > 0. Default 1/60. */
  deltaTime?: number | undefined;
  /** The largest number of steps in one frame, integer from 1 to 1e9. Default 5. */
  maxSteps?: number | undefined;
}

/**
 * Steps a world at a fixed rate, whatever the frame rate of the screen: a game runs at the same speed at 30, 60 and 144 Hz, and gives the
 * same bits. Call `advance` once a frame with the time that has passed, and draw bodies where `getPosition` and `getRotation` say. That is
 * between their placements before and after the last step, so that they move smoothly, up to one step behind.
 *
 * After G. Fiedler, "Fix Your Timestep!", 2004.
 */
export class FixedStepRunner {
  /** The world that it steps. */
  readonly world: World;
  /** The length of each step, s. */
  readonly deltaTime: number;
  /** The largest number of steps in one frame. */
  readonly maxSteps: number;
  /** The time that has passed and is not simulated yet, s; less than `deltaTime`. */
  private waiting = 0;
  /** Steps yet to be made; between two frames more than 0 only if a handler threw. */
  private due = 0;
  /** The world, or the recorder through which it is stepped. */
  private readonly stepped: World | Recorder;
  private advancing = false;

  /** @internal use `create` */
  constructor(params: FixedStepRunnerParams) {
    const where = 'FixedStepRunner.create';
    const { world: stepped, deltaTime = 1 / 60, maxSteps = 5 } = options(where, params, true);
    const world = 'world' in Object(stepped) ? (stepped as Recorder).world : (stepped as World);
    if (typeof stepped?.step !== 'function' || typeof world?.refuseInside !== 'function') {
      throw typeError(where, 'world', 'a World, or the Recorder of one', stepped);
    }
    this.world = world;
    this.stepped = stepped;
    this.deltaTime = positive(where, 'deltaTime', deltaTime);
    this.maxSteps = integer(where, 'maxSteps', maxSteps, 1);
  }

  /** A runner of a world. @throws if an option is not valid. */
  static create(params: FixedStepRunnerParams): FixedStepRunner {
    return new FixedStepRunner(params);
  }

  /**
   * The share of a step, from 0 to less than 1, that has passed since the last one: for `Physics2DDebugDraw.interpolation`, and for your
   * own drawing.
   */
  get interpolation(): number {
    return this.waiting / this.deltaTime;
  }

  /**
   * Makes the steps that are due after another `elapsed` seconds (>= 0). Steps beyond `maxSteps`, as after a pause, are dropped: the game
   * is late then, but it does not freeze. If a handler throws, the steps not yet made are due in the next frame.
   *
   * @param beforeStep called before each step: the place for forces and input.
   * @returns how many steps were made.
   * @throws Error when called from a handler of the world, or from `beforeStep`: nothing has changed then.
   */
  advance(elapsed: number, beforeStep?: (world: World) => void): number {
    const where = 'FixedStepRunner.advance';
    nonNegative(where, 'elapsed', elapsed);
    if (beforeStep !== undefined) {
      callable(where, 'beforeStep', beforeStep);
    }
    this.world.refuseInside(where);
    if (this.advancing) {
      throw new Error(`${where}: must not be called from beforeStep`);
    }
    const time = this.waiting + elapsed;
    this.waiting = time % this.deltaTime;
    this.due = Math.min(this.due + Math.round((time - this.waiting) / this.deltaTime), this.maxSteps);
    let made = 0;
    this.advancing = true;
    try {
      for (; this.due > 0; made += 1) {
        beforeStep?.(this.world);
        this.due -= 1;
        this.stepped.step(this.deltaTime);
      }
    } finally {
      this.advancing = false;
    }
    return made;
  }

  /** Where to draw the origin of a body, m. */
  getPosition(body: RigidBody): Vec2;
  getPosition<T extends NumberSink>(body: RigidBody, dst: T): T;
  getPosition<T extends NumberSink>(body: RigidBody, dst?: T): T | Vec2 {
    this.readPose('FixedStepRunner.getPosition', body);
    return vec2(pose[X]!, pose[Y]!, 'FixedStepRunner.getPosition', dst);
  }

  /** The rotation to draw a body with, clockwise on screen, rad. */
  getRotation(body: RigidBody): number {
    this.readPose('FixedStepRunner.getRotation', body);
    return pose[ANGLE]!;
  }

  private readPose(where: string, body: RigidBody): void {
    if (typeof body?.getRotation !== 'function') {
      throw typeError(where, 'body', 'a RigidBody', body);
    }
    writePose(body, this.interpolation, pose);
  }
}
