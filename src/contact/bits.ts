// The bits of `PairState.bits`. In a file without imports, so that bundlers inline the numbers. A snapshot stores other bits in place of
// those not in KEPT: see `state/layout.ts`.

/** The shapes interacted in the latest step. */
export const ACTIVE = 1;
/** They interact still, but both bodies sleep. */
export const SLEEPING = 2;
/** The collision takes effect; `preSolve` handlers may clear it. */
export const ACCEPTED = 4;
/** ACCEPTED holds until the interaction ends. */
export const PERSISTENT = 8;
/** A speculative contact: the surfaces are apart, but may meet in this step. */
export const NEAR = 16;
/** Cut off, as a shape or body was taken away. */
export const DEAD = 32;
/** The pair is among the arbiters of both shapes. */
export const LISTED = 64;
/** One of the shapes is a sensor. */
export const SENSOR = 128;
/** All contacts of the two bodies were looked at since the shapes were noted to be deep in each other, see `wedged.ts`. */
export const LOOKED_AT = 256;
/** The pair is among the awake ones, or on its way there: `Pairs.sorted`. */
export const AWAKE = 1 << 22;
/** Two edges turn slowly against each other under load, as in a column that sways. */
export const ROCKS = 1 << 23;
/** The contact bore far more in the latest step than its bodies weigh: `strain` is above 0. */
export const STRAINS = 1 << 24;

/**
 * Lowest bits of the small numbers: FIXED, four bits, which material values were set by hand; two bits each, one a point, USED (by the
 * velocity solver) and FRESH (used for the first time); SHOWN, two bits, how many points `contacts` lists.
 */
export const FIXED = 12;
export const USED = 16;
export const FRESH = 18;
export const SHOWN = 20;
/** Which points were used before this step: of impacts in it those are fresh that were not. */
export const USED_BEFORE = 25;

/** What the solver writes after a step. */
const USE = ROCKS | (3 << USED) | (3 << FRESH);

/** The same with what it knows of the step before. */
export const NOTED = USE | (3 << USED_BEFORE);

/** What snapshots keep. */
export const KEPT = ACTIVE | SLEEPING | ACCEPTED | PERSISTENT | LISTED | USE | (15 << FIXED) | (3 << SHOWN);
