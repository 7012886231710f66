// Offsets into the numbers of a shape. First the world bounds: minX, minY, maxX, maxY; right after `place`.

/** Of a circle then its centre, turned with the body and relative to its origin. A field that only circles have is boxed where the shape may be a polygon. */
export const CENTRE_X = 4;
export const CENTRE_Y = 5;
export const CIRCLE_NUMBERS = 6;
/** Of a polygon instead, corner by corner, turned with the body and relative to its origin: the corner, and the outward normal of the edge that starts there. */
export const EDGES = 4;
/** Of the normal among the numbers of a corner, which come after x and y; and how many there are, as in `Polygon.localEdges`. */
export const EDGE_NX = 2;
export const EDGE_NY = 3;
export const EDGE_STRIDE = 4;
