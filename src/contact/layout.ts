/** Offsets into the record of a pair of what the contacts keep there, after the 24 numbers of the collision itself: see `collide/layout.ts`. */

/** Impulses of the first point: what the next step starts from, about that of the last sub-step, and that of the whole step. N·s */
export const NORMAL = 24;
export const TANGENT = 25;
export const STEP_NORMAL = 26;
export const STEP_TANGENT = 27;
/** From a number of the first point to that of the second. */
export const IMPULSES = 4;
/** Rolling impulse of the last sub-step and of the whole step. N·m·s */
export const ROLL = 32;
export const STEP_ROLL = 33;
/** The combined material. */
export const ELASTICITY = 34;
export const STATIC_FRICTION = 35;
export const DYNAMIC_FRICTION = 36;
export const ROLLING_FRICTION = 37;
/** m/s. How fast the surfaces come together; only kept right where a `hit` is listened for. */
export const APPROACH = 38;
/** m. What the separations of a contact that is foreseen are less than those at the time when it comes, of both points. */
export const FORESIGHT = 39;
