// How box trees and pairs are laid out in arrays. In a file without imports, so that bundlers inline the numbers.

/** No node. */
export const NONE = -1;

/** In place of a kin: one that no leaf has, nor any node above leaves of several kins. */
export const STRANGER = -2;

/** Numbers per box: minX, minY, maxX, maxY. */
export const BOX = 4;

/** By how many levels two sibling subtrees may differ in height: more allows better trees, less keeps the worst ones lower. */
export const MAX_LEAN = 4;

/** In place of the height of a node: FREE, it is not in use; WAITING, it is a leaf without a place in the tree. */
export const FREE = 254;
export const WAITING = 255;

/** State of a handle: its leaf, −1 once removed; whether it is in the static tree, … */
export const LEAF = 0;
export const STATIC = 1;
/** … the first link of its pairs; the last search in which it was met, … */
export const FIRST = 2;
export const MARK = 3;
/** … and 1 if it is in the list for `perform`, as its pairs may have changed, else −1. STATE is how many numbers there are. */
export const MOVED = 4;
export const STATE = 5;

/** A pair: its two handles, and the integer that `perform` got for it, 0 for none. PAIR is how many numbers there are. */
export const END_A = 0;
export const END_B = 1;
export const NOTE = 2;
export const PAIR = 3;
