/** The pose of a body, as given to `Constraint.measure`: offsets and stride. */
export const X = 0;
export const Y = 1;
export const COS = 2;
export const SIN = 3;
/** Not wrapped. */
export const ANGLE = 4;
/** The same stride as the records of bodies in the solver, so that one offset serves for both. */
export const POSE = 8;

/**
 * A row of the Jacobian of two bodies, as written by `Constraint.measure`: the factors of the velocities of A and B, and how many numbers
 * there are.
 */
export const ROW_AX = 0;
export const ROW_AY = 1;
export const ROW_AW = 2;
export const ROW_BX = 3;
export const ROW_BY = 4;
export const ROW_BW = 5;
export const ROW_SIZE = 6;
