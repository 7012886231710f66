/** Numbers per corner in `Polygon.edges`: the corner, and the outward normal of the edge that starts there. */
export const EDGE_STRIDE = 4;
