/**
 * Offsets into the record of a pair: all its numbers side by side in one slab, because collision, packing and storing walk through all pairs
 * in every step and would wait for memory otherwise. A function that is given a record takes the slab and where the record begins, `n` and `o`.
 */

/** Input of the kernels: from body A's origin to body B's, and both rotations. */
export const DX = 0;
export const DY = 1;
export const ANGLE_A = 2;
export const ANGLE_B = 3;
/** Unit normal from A to B. */
export const NX = 4;
export const NY = 5;
/** Points half-way into the overlap, relative to the origin of body A, and their separation, negative where the surfaces overlap. */
export const X0 = 6;
export const Y0 = 7;
export const S0 = 8;
/** From a number of the first point to that of the second. */
export const POINT = 3;
export const X1 = 9;
export const Y1 = 10;
export const S1 = 11;
/** Number of points, 0 to 2. With two, the first lies lower along the tangent (−ny, nx). */
export const COUNT = 12;
// What is between is kept by the contacts, see `contact/layout.ts`.

/** The corners that limit the overlap at either end: 2 · index, + 1 for a corner of B. Of two circles the first is 0; what follows it only polygons have. */
export const ID0 = 27;
export const ID1 = 28;
/** The two edges that face each other. */
export const EDGE_A = 29;
export const EDGE_B = 30;
/** Where to look first for a separating axis: 2 · edge, + 1 for an edge of B; −1: nowhere. */
export const AXIS = 31;
/** Whose edge the other's was clipped to: 0 A's, 1 B's, −1: there was no such choice; and for which shapes. */
export const FACE = 32;
export const FACE_STAMP = 33;
/** Where body B's origin is in the coordinates of body A, … */
export const LOCAL_X = 34;
export const LOCAL_Y = 35;
/** … where it was when the facing edges were chosen, and how far B was turned against A. */
export const FACE_X = 36;
export const FACE_Y = 37;
export const FACE_TURN = 38;
/** How many there are; the last one is of the contacts. */
export const PAIR_NUMBERS = 40;
/** From record to record: so many in whole cache lines of eight, so that a record takes no more than it has to, and those of circles one less. */
export const PAIR_STRIDE = 40;
