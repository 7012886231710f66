import { DYNAMIC, KINEMATIC, STATIC } from './body-kind.js';
import type { Vec2Like } from './math/vectors.js';
import { Shape } from './shape/shape.js';
import type { UserDataOf } from './user-data.js';
import { boolean, finite, nonNegative, optional, options, positiveOrInfinite, typeError, vector } from './validate.js';

/** How a body moves; see `RigidBodyParams.type`. */
export type BodyType = 'dynamic' | 'kinematic' | 'static';

/** Options of `createRigidBody`. */
export interface RigidBodyParams {
  /** 'dynamic' is moved by forces and contacts, 'kinematic' by its velocity alone, 'static' not at all. Default 'dynamic'. */
  type?: BodyType | undefined;
  /** Shapes to attach, in order; one that has a body already is skipped. Default none. */
  shapes?: ArrayLike<Shape> | undefined;
  /**
   * Mass, kg, > 0. Does not set `inertia`, which still follows from the density of the shapes: set both, or a density instead. With
   * `Infinity` nothing moves or stops the body, neither gravity nor walls. Default: computed from the shapes, and kept in step with them.
   */
  mass?: number | undefined;
  /**
   * Moment of inertia about the body origin, kg·m², > 0; with `Infinity` nothing turns the body. Default: computed from the density of the
   * shapes, and kept in step with them.
   */
  inertia?: number | undefined;
  /** Stays asleep when added to a world. Default `false`. */
  sleeping?: boolean | undefined;
  /** Whether it falls asleep by itself once it rests. While it does not, what it touches or is tied to stays awake, too. Default `true`. */
  allowSleeping?: boolean | undefined;
  /**
   * Continuous collision with other dynamic bodies: it does not pass through them when it is fast. Nothing passes through static and
   * kinematic bodies anyway. Default `false`.
   */
  bullet?: boolean | undefined;
  /** World position of the body origin, m. Default `[0, 0]`. */
  position?: Vec2Like | undefined;
  /** Rotation, clockwise on screen, rad. Default 0. */
  rotation?: number | undefined;
  /** Velocity of the body origin, m/s; ignored for 'static'. Default `[0, 0]`. */
  velocity?: Vec2Like | undefined;
  /** Angular velocity, clockwise on screen, rad/s; ignored for 'static'. Default 0. */
  angularVelocity?: number | undefined;
  /** Force, N; acts in every step until changed. Default `[0, 0]`. */
  force?: Vec2Like | undefined;
  /** Torque, N·m; acts in every step until changed. Default 0. */
  torque?: number | undefined;
  /** Share of the velocity lost per second, >= 0; 1 and more stop the body in each step. Default 0.05. */
  linearDrag?: number | undefined;
  /** Share of the angular velocity lost per second, >= 0. Default 0.05. */
  angularDrag?: number | undefined;
  /** How much of the world's gravity acts on it: 0 none, −1 the opposite, 2 twice as much. Default 1. */
  gravityScale?: number | undefined;
  /**
   * Velocity of its surface, as of a conveyor belt, m/s: x along the surface, clockwise around the body; y along its outward normal.
   * Default `[0, 0]`.
   */
  surfaceVelocity?: Vec2Like | undefined;
  /** Anything of yours. Default `null`. */
  userData?: UserDataOf<'body'> | undefined;
}

const KINDS: Readonly<Record<string, number>> = { dynamic: DYNAMIC, kinematic: KINEMATIC, static: STATIC };
const ZERO: Vec2Like = [0, 0];

/** Checks all options and fills in the defaults; mass and inertia are −1 where they follow the shapes. */
export function checkedParams(params: RigidBodyParams | undefined) {
  const where = 'createRigidBody';
  const given = options(where, params, false);
  const type = optional(given.type, 'dynamic');
  if (typeof type !== 'string' || !Object.hasOwn(KINDS, type)) {
    throw typeError(where, 'type', "'dynamic', 'kinematic' or 'static'", type);
  }
  return {
    kind: KINDS[type]!,
    shapes: checkedShapes(where, given.shapes),
    position: vector(where, 'position', optional(given.position, ZERO), 2),
    rotation: finite(where, 'rotation', optional(given.rotation, 0)),
    velocity: vector(where, 'velocity', optional(given.velocity, ZERO), 2),
    angularVelocity: finite(where, 'angularVelocity', optional(given.angularVelocity, 0)),
    force: vector(where, 'force', optional(given.force, ZERO), 2),
    torque: finite(where, 'torque', optional(given.torque, 0)),
    linearDrag: nonNegative(where, 'linearDrag', optional(given.linearDrag, 0.05)),
    angularDrag: nonNegative(where, 'angularDrag', optional(given.angularDrag, 0.05)),
    gravityScale: finite(where, 'gravityScale', optional(given.gravityScale, 1)),
    surfaceVelocity: vector(where, 'surfaceVelocity', optional(given.surfaceVelocity, ZERO), 2),
    mass: given.mass === undefined ? -1 : positiveOrInfinite(where, 'mass', given.mass),
    inertia: given.inertia === undefined ? -1 : positiveOrInfinite(where, 'inertia', given.inertia),
    sleeping: boolean(where, 'sleeping', optional(given.sleeping, false)),
    allowSleeping: boolean(where, 'allowSleeping', optional(given.allowSleeping, true)),
    bullet: boolean(where, 'bullet', optional(given.bullet, false)),
    userData: given.userData === undefined ? null : given.userData,
  };
}

function checkedShapes(where: string, value: ArrayLike<Shape> | undefined): Shape[] {
  if (value === undefined) {
    return [];
  }
  if (typeof value !== 'object' || value === null || typeof value.length !== 'number') {
    throw typeError(where, 'shapes', 'an array of Shapes', value);
  }
  const shapes = Array.isArray(value) ? value.slice() : Array.from(value);
  for (let i = 0; i < shapes.length; i += 1) {
    if (!(shapes[i] instanceof Shape)) {
      throw typeError(where, `shapes[${i}]`, 'a Shape', shapes[i]);
    }
  }
  return shapes;
}
