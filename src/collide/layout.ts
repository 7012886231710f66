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
/** Placement for which the facing edges were chosen. */
export const FACE_DX = 12;
export const FACE_DY = 13;
export const FACE_ANGLE_A = 14;
export const FACE_ANGLE_B = 15;
/** Number of points, 0 to 2. With two, the first lies lower along the tangent (−ny, nx). */
export const COUNT = 16;
/** The corners that limit the overlap at either end: 2 · index, + 1 for a corner of B. */
export const ID0 = 17;
export const ID1 = 18;
/** The two edges that face each other. */
export const EDGE_A = 19;
export const EDGE_B = 20;
/** Where to look first for a separating axis: 2 · edge, + 1 for an edge of B; −1: nowhere. */
export const AXIS = 21;
/** Whose edge the other's was clipped to: 0 A's, 1 B's, −1: there was no such choice; and for which shapes. */
export const FACE = 22;
export const FACE_STAMP = 23;
/** With what the contacts keep there from 24 on: see `contact/layout.ts`. */
export const PAIR_NUMBERS = 41;
