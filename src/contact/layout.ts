/** Offsets into `Manifold.numbers` of what the contacts keep there, after the 16 numbers of the manifold itself. */

/** Impulses of the first point: in the last sub-step, where the next starts from, and in the whole step. N·s */
export const NORMAL = 16;
export const TANGENT = 17;
export const STEP_NORMAL = 18;
export const STEP_TANGENT = 19;
/** From a number of the first point to that of the second. */
export const IMPULSES = 4;
/** Rolling impulse of the last sub-step and of the whole step. N·m·s */
export const ROLL = 24;
export const STEP_ROLL = 25;
/** The combined material. */
export const ELASTICITY = 26;
export const STATIC_FRICTION = 27;
export const DYNAMIC_FRICTION = 28;
export const ROLLING_FRICTION = 29;
/** m. What the separations of a contact that is foreseen are less than those at the time when it comes. */
export const FORESIGHT = 31;
/** m/s. How fast the surfaces come together; only kept right where a `hit` is listened for. */
export const APPROACH = 30;
