// What the page and the worker agree on.

/** Boxes, and their side in metres. */
export const COUNT = 200;
export const SIZE = 0.5;
/** Numbers of each in the pose buffer: `POSE_STRIDE` of phys2d/state. */
export const STRIDE = 4;
/** Where the steps are counted. */
export const STEPS = 0;
