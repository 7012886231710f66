/** Offsets into the record of a pair of what the contacts keep there, amid the numbers of the collision itself: see `collide/layout.ts`. */

/** Impulses of the first point: what the next step starts from, about that of the last sub-step, and that of the whole step. N·s */
export const NORMAL = 13;
export const TANGENT = 14;
export const STEP_NORMAL = 15;
export const STEP_TANGENT = 16;
/** From a number of the first point to that of the second. */
export const IMPULSES = 4;
/** Rolling impulse of the last sub-step and of the whole step. N·m·s */
export const ROLL = 21;
export const STEP_ROLL = 22;
/** The combined material. */
export const ELASTICITY = 23;
export const STATIC_FRICTION = 24;
export const DYNAMIC_FRICTION = 25;
export const ROLLING_FRICTION = 26;
/** m/s. How fast the surfaces come together; only kept right where a `hit` is listened for. */
export const APPROACH = 39;

/** How many numbers a manifold has that is held, in an array of its own: see `at-end.ts`. */
export const HELD_NUMBERS = 8;
