// Offsets into the numbers of a shape.

/** The world bounds, as of the last `place`. */
export const MIN_X = 0;
export const MIN_Y = 1;
export const MAX_X = 2;
export const MAX_Y = 3;

/**
 * For a circle, its centre follows, turned with the body and relative to the body's origin. It is not a field of the class: one that only
 * circles have is boxed where the shape may be a polygon.
 */
export const CENTRE_X = 4;
export const CENTRE_Y = 5;
export const CIRCLE_NUMBERS = 6;
/**
 * For a polygon, its edges follow, corner by corner, turned with the body and relative to the body's origin: the corner, and the outward
 * normal of the edge that starts there.
 */
export const EDGES = 4;
/** The normal among the numbers of a corner, after x and y; and how many numbers there are, as in `Polygon.localEdges`. */
export const EDGE_NX = 2;
export const EDGE_NY = 3;
export const EDGE_STRIDE = 4;
