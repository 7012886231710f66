// What the bits of a pair say. In a file without imports, so that bundlers inline the numbers. In snapshots others stand in place of those that they do not keep: see `state/layout.ts`.

export const ACTIVE = 1;
export const SLEEPING = 2;
export const ACCEPTED = 4;
export const PERSISTENT = 8;
export const NEAR = 16;
export const DEAD = 32;
export const LISTED = 64;
export const SENSOR = 128;
export const AWAKE = 1 << 22;
export const ROCKS = 1 << 23;
export const STRAINS = 1 << 24;

/** From which bit on the small numbers stand: four bits of what was fixed by hand, two of each other. */
export const FIXED = 12;
export const USED = 16;
export const FRESH = 18;
export const SHOWN = 20;

/** What the solver finds … */
export const USE = ROCKS | (3 << USED) | (3 << FRESH);

/** … and what snapshots keep. */
export const KEPT = ACTIVE | SLEEPING | ACCEPTED | PERSISTENT | LISTED | USE | (15 << FIXED) | (3 << SHOWN);
