/**
 * Offsets into the record of a pair. All its numbers lie side by side in one slab, because collision, packing and storing walk through all
 * pairs in every step and would wait for memory otherwise. A function that works on a record takes the slab and where the record begins,
 * `n` and `o`.
 */

/** Input of the kernels: from body A's origin to body B's, m, and the angles of both, rad. */
export const DX = 0;
export const DY = 1;
export const ANGLE_A = 2;
export const ANGLE_B = 3;
/** Unit normal from A to B. */
export const NX = 4;
export const NY = 5;
/** The contact points, half-way into the overlap, relative to the origin of body A; and their separations, negative where the surfaces overlap. m */
export const X0 = 6;
export const Y0 = 7;
export const S0 = 8;
/** Stride from the numbers of the first point to those of the second. */
export const POINT = 3;
export const X1 = 9;
export const Y1 = 10;
export const S1 = 11;
/** Number of points, 0 to 2. Of two, the first lies lower along the tangent (−ny, nx). */
export const COUNT = 12;
// The numbers in between are those of the contacts, see `contact/layout.ts`.

/**
 * The features of the two points: the corners that limit the overlap at either end, as 2 · index, + 1 for a corner of B. With a circle the
 * first is 0, and what follows it is not used: that is for two polygons only.
 */
export const ID0 = 27;
export const ID1 = 28;
/** The two edges that face each other. */
export const EDGE_A = 29;
export const EDGE_B = 30;
/** Where to look first for a separating axis: 2 · edge, + 1 for an edge of B; −1: nowhere. */
export const AXIS = 31;
/**
 * The reference face: 0 if B's edge was clipped to A's, 1 if A's was clipped to B's, −1 if neither; and for which shapes it was chosen, the
 * sum of their `geometryStamp`.
 */
export const FACE = 32;
export const FACE_STAMP = 33;
/** The origin of body B in the coordinates of body A now, … */
export const LOCAL_X = 34;
export const LOCAL_Y = 35;
/** … the same when the reference face was chosen, and the angle of B against A then. */
export const FACE_X = 36;
export const FACE_Y = 37;
export const FACE_TURN = 38;
/** How many numbers a record has; the last one is of the contacts. */
export const PAIR_NUMBERS = 40;
/**
 * Stride from record to record: whole cache lines of eight numbers, so that a record spans no more lines than it must, and what two circles
 * use of it one less.
 */
export const PAIR_STRIDE = 40;
