import type { validate } from '../../src/audit/index.js';
import type { Arbiter, Constraint, Physics2DDevice, RigidBody, Shape, World } from '../../src/index.js';

/** What programs throw on purpose. */
class Stop extends Error {}

/** Errors that a step may throw: of handlers and callbacks that stop, write no numbers, or step their own world. */
const EXPECTED = /^World\.step: must not be called|^CustomConstraint\.\w+ of |^stop$/;

/** What programs are made of: objects by kind and number, and what is done with them. */
export class Stage {
  readonly w: (World | undefined)[] = [];
  readonly b: (RigidBody | undefined)[] = [];
  readonly s: (Shape | undefined)[] = [];
  readonly c: (Constraint | undefined)[] = [];
  readonly m: unknown[] = [];
  readonly h: unknown[] = [];
  readonly utils;
  /** The statement that runs. */
  at = 0;
  private began = process.cpuUsage();

  constructor(
    readonly phys2D: Physics2DDevice,
    private readonly check: typeof validate,
    private readonly limit: number,
  ) {
    this.utils = phys2D.createCollisionUtils();
  }

  /** Called before each statement and at the end: all worlds are consistent, and the last statement did not take long. */
  next(at: number): void {
    // Not the time on the clock: others may be at work.
    if (process.cpuUsage(this.began).user > 1000 * this.limit) {
      throw new Error(`took longer than ${this.limit} ms`);
    }
    this.judge();
    this.at = at;
    this.began = process.cpuUsage();
  }

  judge(): void {
    for (const world of this.w) {
      if (world !== undefined) {
        this.check(world);
      }
    }
  }

  readonly all = <T>(...things: (T | undefined)[]): T[] => things.filter((thing) => thing !== undefined);

  readonly step = (world: World | undefined, dt: number): void => {
    try {
      world?.step(dt);
    } catch (error) {
      if (!(error instanceof Error && error.message.match(EXPECTED))) {
        throw error;
      }
    }
  };

  readonly stop = (): never => {
    throw new Stop('stop');
  };

  /** A handler that acts so many times at most: else bodies would multiply without end. */
  readonly few = (times: number, action: (...args: unknown[]) => void) => {
    let left = times;
    return (...args: unknown[]): void => {
      left -= 1;
      if (left >= 0) {
        action(...args);
      }
    };
  };

  /** Sets the bounds of a constraint that has some. */
  readonly bind = (constraint: Constraint | undefined, first: number, second: number): void => {
    if (constraint !== undefined && 'setLowerBound' in constraint) {
      const least = constraint.type === 'DISTANCE' ? 0 : -Infinity;
      constraint.setUpperBound(Infinity);
      constraint.setLowerBound(Math.max(least, Math.min(first, second)));
      constraint.setUpperBound(Math.max(0, first, second));
    }
  };

  readonly move = (body: RigidBody | undefined, world: World | undefined): void => {
    if (body !== undefined && world !== undefined) {
      body.world?.removeRigidBody(body);
      world.addRigidBody(body);
    }
  };

  /** A world that is restored at once is the same; from its own handlers and callbacks it cannot be saved. */
  readonly save = (world: World | undefined): void => {
    try {
      const hash = world?.hash();
      world?.restore(world.snapshot());
      if (world?.hash() !== hash) {
        throw new Error('restored to another state');
      }
    } catch (error) {
      if (!(error instanceof Error && error.message.includes(': must not be called from a handler'))) {
        throw error;
      }
    }
  };

  /** Calls every getter, and everything else that changes nothing and needs no arguments. */
  readonly look = (thing: object | undefined): void => {
    const names = new Set<string>();
    for (let type = thing; type && type !== Object.prototype; type = Object.getPrototypeOf(type) as object) {
      Object.getOwnPropertyNames(type).forEach((name) => void names.add(name));
    }
    for (const name of names) {
      const value = (thing as Record<string, unknown>)[name];
      if (name.match(/^(?:get|is|compute)[A-Z]/) && name !== 'getImpulseForBody' && typeof value === 'function') {
        value.call(thing, name === 'getVelocityAtPoint' ? [1, 2] : undefined);
      }
    }
    if (names.has('contacts')) {
      (thing as Arbiter).contacts.forEach(this.look);
    }
    const body = this.b.find((one) => one !== undefined);
    if (body !== undefined && names.has('getImpulseForBody')) {
      (thing as Constraint).getImpulseForBody(body);
    }
    if (names.has('transformLocalPointToWorld')) {
      const one = thing as RigidBody;
      one.transformLocalPointToWorld(one.transformWorldPointToLocal([1, 2]));
      one.transformLocalVectorToWorld(one.transformWorldVectorToLocal([1, 2]));
    }
  };
}
