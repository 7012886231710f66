// The layout of words in a snapshot. In a file without imports, so that bundlers inline the numbers.

/** Bits of the first word of a pair, beside those of `KEPT` in `contact/bits.ts`. */
export const AGAIN = 16;
/** There are impulses. */
export const SOLVED = 32;
/** The usual numbers are those of the last pair of its kind, see `isUsual`. */
export const USUAL = 128;
/** There are rolling impulses, too. */
export const ROLLED = 1 << 22;
/** The pair holds the manifold of the end of the latest step. */
export const HELD = 1 << 24;
/** The bits at which its small numbers begin, and the end of all bits. */
export const COUNT = 8;
export const FACE = 10;
export const FLAGS_END = 25;

/** The modes of a tape. */
export const WRITE = 0;
export const READ = 1;
export const CHECK = 2;
export const HASH = 3;
