/** A pose, as `Constraint.measure` is given one for each of its bodies: offsets and stride. */
export const X = 0;
export const Y = 1;
export const COS = 2;
export const SIN = 3;
/** Not wrapped. */
export const ANGLE = 4;
/** As the stride of the records of bodies in the solver, which has one offset for both. */
export const POSE = 8;
