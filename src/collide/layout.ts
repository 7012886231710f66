/**
 * Offsets into `Manifold.numbers`. One array a pair holds all its numbers side by side, because collision, packing and storing walk
 * through all pairs in every step and would wait for memory otherwise.
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
/** What the contacts keep with a manifold begins here: see `contact/layout.ts`. */
export const MANIFOLD_NUMBERS = 16;
export const PAIR_NUMBERS = 33;
