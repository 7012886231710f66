// How the box trees and their pairs lie in arrays. In a file without imports, so that bundlers inline the numbers.

/** No node. */
export const NONE = -1;

/** In place of a kin: that of no leaf, nor of leaves of several kins. */
export const STRANGER = -2;

/** Numbers per box: minX, minY, maxX, maxY. */
export const BOX = 4;

/** Levels by which two subtrees may differ in height: more allows better trees, less makes the worst ones less high. */
export const MAX_LEAN = 4;

/** In place of the height of a node: it is not in use; it is a leaf without a place in the tree. */
export const FREE = 254;
export const WAITING = 255;

/** Of a handle: its leaf in the tree of its kind, −1 once removed; whether that is the static one, */
export const LEAF = 0;
export const STATIC = 1;
/** … the first link of its pairs, the last search in which it was met, */
export const FIRST = 2;
export const MARK = 3;
/** … and whether it is in the list of `perform`, as its pairs may have changed; else −1. */
export const MOVED = 4;
export const STATE = 5;

/** Of a pair: its handles, and its note, see `perform`; 0: none. */
export const END_A = 0;
export const END_B = 1;
export const NOTE = 2;
export const PAIR = 3;
