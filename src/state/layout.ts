// What is where in the words of a snapshot. In a file without imports, so that bundlers inline the numbers.

/** Bits of the first word of a pair, beside those of `KEPT` in `contact/bits.ts`. */
export const AGAIN = 16;
/** There are impulses. */
export const SOLVED = 32;
/** As the last pair of its kind. */
export const USUAL = 128;
/** There are rolling impulses, too. */
export const ROLLED = 1 << 22;
/** The manifold at the end of the latest step is held. */
export const HELD = 1 << 24;
/** From which bit on its small numbers stand, and where all end. */
export const COUNT = 8;
export const FACE = 10;
export const FLAGS_END = 25;

/** What a tape is for at the moment. */
export const WRITE = 0;
export const READ = 1;
export const CHECK = 2;
export const HASH = 3;
