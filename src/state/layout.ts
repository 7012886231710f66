// What is where in the words of a snapshot. In a file without imports, so that bundlers inline the numbers.

/** Bits of the first word of a pair. */
export const ACTIVE = 1;
export const SLEEPING = 2;
export const ACCEPTED = 4;
export const PERSISTENT = 8;
export const AGAIN = 16;
/** There are impulses. */
export const SOLVED = 32;
export const LISTED = 64;
/** As the last pair of its kind. */
export const USUAL = 128;
/** There are rolling impulses, too. */
export const ROLLED = 1 << 22;
export const ROCKS = 1 << 23;
/** From which bit on its small numbers stand, and where all end. */
export const COUNT = 8;
export const FACE = 10;
export const FIXED = 12;
export const USED = 16;
export const FRESH = 18;
export const SHOWN = 20;
export const FLAGS_END = 24;

/** What a tape is for at the moment. */
export const WRITE = 0;
export const READ = 1;
export const CHECK = 2;
export const HASH = 3;
