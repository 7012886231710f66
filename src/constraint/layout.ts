/** A pose, as `Constraint.measure` is given one for each of its bodies: offsets and stride. */
export const X = 0;
export const Y = 1;
export const COS = 2;
export const SIN = 3;
/** Not wrapped. */
export const ANGLE = 4;
/** As the stride of the records of bodies in the solver, which has one offset for both. */
export const POSE = 8;

/** A row of the Jacobian of two bodies, as `Constraint.measure` writes them: what multiplies the velocities of A and of B; and how many numbers it has. */
export const ROW_AX = 0;
export const ROW_AY = 1;
export const ROW_AW = 2;
export const ROW_BX = 3;
export const ROW_BY = 4;
export const ROW_BW = 5;
export const ROW_SIZE = 6;
