/** Offsets into the numbers of a shape. First the world bounds: minX, minY, maxX, maxY; right after `place`. Refused: radius and centre of a circle, too; no gain. */
export const BOUNDS = 4;
/** Of a polygon then, corner by corner, turned with the body and relative to its origin: the corner, and the outward normal of the edge that starts there. */
export const EDGES = 4;
/** Numbers per corner there and in `Polygon.localEdges`. */
export const EDGE_STRIDE = 4;
