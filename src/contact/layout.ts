/** Offsets into the record of a pair, of what contacts keep there, amid the numbers of the collision itself: see `collide/layout.ts`. */

/**
 * Impulses of the first point, N·s: NORMAL and TANGENT warm start the next step, about those of the last sub-step; STEP_… are those of the
 * whole step.
 */
export const NORMAL = 13;
export const TANGENT = 14;
export const STEP_NORMAL = 15;
export const STEP_TANGENT = 16;
/** Stride from the impulses of the first point to those of the second. */
export const IMPULSES = 4;
/** Rolling impulse of the last sub-step and of the whole step. N·m·s */
export const ROLL = 21;
export const STEP_ROLL = 22;
/** The combined material: mixed from both shapes, or set by hand. */
export const ELASTICITY = 23;
export const STATIC_FRICTION = 24;
export const DYNAMIC_FRICTION = 25;
export const ROLLING_FRICTION = 26;
/** Approach speed of the surfaces, m/s; only kept where a `hit` is listened for. */
export const APPROACH = 39;

/** A held manifold, in an array of its own, see `at-end.ts`: the normal; position and penetration of the first point … */
export const HELD_NX = 0;
export const HELD_NY = 1;
export const HELD_X = 2;
export const HELD_Y = 3;
export const HELD_PENETRATION = 4;
/** … the stride to those of the second; and how many numbers there are. */
export const HELD_POINT = 3;
export const HELD_NUMBERS = 8;
