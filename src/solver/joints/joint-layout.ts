/**
 * Offsets; a file without imports, as only then the numbers stand in the loops themselves.
 *
 * Joints: the packed form of constraints, in the order in which they are solved. A record begins with what is common to all, of which
 * the first three numbers are those of softness.ts; the rest depends on the kernel that solves it.
 */
export const SOFTNESS = 0;
export const FEEDBACK = 1;
export const RATE = 2;
/** Largest correcting speed. */
export const MAX_BIAS = 3;
/** N·s. An impulse of a sub-step is cut to this. */
export const LIMIT = 4;
/** N·s. An impulse of the step above this breaks the joint. */
export const BREAK = 5;
/** An error above this breaks the joint. */
export const MAX_ERROR = 6;
/** s⁻¹. What a position correction is multiplied by to become momentum. */
export const CARRY = 7;
/** 1 if position errors are corrected. */
export const PUSH = 8;
/** 1 if LIMIT or BREAK is finite. */
export const CHECKED = 9;
/** 1 if the last position iteration did without turning. */
export const SNAPPED = 10;
/** 1 if a large error is corrected without turning. */
export const SNAPS = 11;
/** m, rad. A larger error is corrected by no more at once: see `reachLess`; below 0, so much of it is left open: see `correctShare`. */
export const REACH = 12;
const HEAD = 13;

/**
 * Rigid point joints: what they keep from step to step, without such a head, as they are two rows with unit columns, so that their arms say all: anchors in the
 * coordinates of their bodies, of immovable ones in the world, the impulse of the last sub-step …
 */
export const KEPT_ANCHOR_AX = 0;
export const KEPT_ANCHOR_AY = 1;
export const KEPT_ANCHOR_BX = 2;
export const KEPT_ANCHOR_BY = 3;
export const KEPT_IMPULSE_X = 4;
export const KEPT_IMPULSE_Y = 5;
/** … and what the last step gave: an impulse to B, its opposite to A, and what turned each. */
export const KEPT_SUM_X = 6;
export const KEPT_SUM_Y = 7;
export const KEPT_SUM_WA = 8;
export const KEPT_SUM_WB = 9;
/** Which of the records for a step is its own. */
export const KEPT_SLOT = 10;
/** Where the origins are of those of its bodies that are immovable, else 0, of A and then of B: their arms are from that of the world. */
export const KEPT_ORIGIN_AX = 11;
export const KEPT_ORIGIN_AY = 12;
export const KEPT_STRIDE = 15;

/**
 * Their records for a step lie two by two, as those of contacts (`layout.ts`). What velocity iterations use stands first: arms, impulse and K⁻¹ …
 */
export const ARM_AX = 0;
export const ARM_AY = 2;
export const ARM_BX = 4;
export const ARM_BY = 6;
export const IMPULSE_X = 8;
export const IMPULSE_Y = 10;
export const I11 = 12;
export const I12 = 14;
export const I22 = 16;
/** … then what position iterations use: arms where the last exact sweep found them, the error that these make linear in the motion, corrections … */
export const PLACED_AX = 18;
export const PLACED_AY = 20;
export const PLACED_BX = 22;
export const PLACED_BY = 24;
export const OFFSET_X = 26;
export const OFFSET_Y = 28;
export const PUSH_X = 30;
export const PUSH_Y = 32;
/** … the error at the start of the sub-step; 1 if a large one is corrected without turning … */
export const ERROR_X = 34;
export const ERROR_Y = 36;
export const POINT_SNAPS = 38;
/** … anchors … */
export const ANCHOR_AX = 40;
export const ANCHOR_AY = 42;
export const ANCHOR_BX = 44;
export const ANCHOR_BY = 46;
/** … and what the step gave so far; the momentum of corrections, as CARRY. */
export const SUM_X = 48;
export const SUM_Y = 50;
export const SUM_WA = 52;
export const SUM_WB = 54;
export const POINT_CARRY = 56;
/** How far either body was turned in the sub-step when the last exact sweep found its arm. */
export const PLACED_WA = 58;
export const PLACED_WB = 60;
/** How many numbers a record has. */
export const POINT_STRIDE = 31;

/** Kernels: rigid point joints that do not break … */
export const POINT = 0;
/** … angles, motors, and points beside others, that do not break … */
export const TURN = 1;
/** … distances, and angles that may break … */
export const ROW = 2;
/** … lines … */
export const LINE = 3;
/** … welds, and points that are soft or may break … */
export const ANCHORED = 4;
/** … any number of rows and bodies … */
export const BLOCK = 5;
/** … and the same by callbacks. */
export const CUSTOM = 6;

/**
 * These have, after the head, what velocity iterations use: impulse, bias, range of the impulse, ratio and 1 / K …
 */
export const TURN_IMPULSE = 13;
export const TURN_BIAS = 14;
export const TURN_LOW = 15;
export const TURN_HIGH = 16;
export const TURN_RATIO = 17;
export const TURN_MASS = 18;
/** … then what position iterations use: the correction of this sub-step, the value at its start, bounds … */
export const TURN_PUSH = 19;
export const TURN_VALUE = 20;
export const TURN_LOWER = 21;
export const TURN_UPPER = 22;
/** … then: 1 if there are bounds; what of the value is due to bodies that cannot move; what the step gave to A and to B so far. */
export const TURN_BOUNDED = 23;
export const TURN_STILL = 24;
export const TURN_GIVEN_A = 25;
export const TURN_GIVEN_B = 26;
/** rad. Of a point that keeps an angle: that, from which bounds are a whole number of turns away; else NaN. */
export const TURN_ANGLE = 27;
/** The impulse that the step began with. */
export const TURN_BEGAN = 28;
/** rad/s. Of a motor, before its bounds are looked at. */
export const TURN_RATE = 29;
export const TURN_STRIDE = 30;

/** Where things are in the record of any other joint, of D rows and N members. */
export class BlockLayout {
  /** λ, corrections of this sub-step, bias … */
  readonly impulse: number;
  readonly push: number;
  readonly bias: number;
  /** … error (in position iterations less its linear part) … */
  readonly error: number;
  /** … scratch, λ of the step, momentum of corrections of the step: D each. */
  readonly work: number;
  readonly total: number;
  readonly carried: number;
  /** Range of the last row's impulse. */
  readonly low: number;
  readonly high: number;
  /** Jacobian of velocity iterations, and of position iterations. */
  readonly jacobian: number;
  readonly turned: number;
  /** K, factored. */
  readonly matrix: number;
  /** What the step gave to each member so far. */
  readonly given: number;
  readonly size: number;

  constructor(
    readonly rows: number,
    readonly members: number,
  ) {
    this.impulse = HEAD;
    this.push = HEAD + rows;
    this.bias = HEAD + 2 * rows;
    this.error = HEAD + 3 * rows;
    this.work = HEAD + 4 * rows;
    this.total = HEAD + 5 * rows;
    this.carried = HEAD + 6 * rows;
    this.low = HEAD + 7 * rows;
    this.high = this.low + 1;
    this.jacobian = this.low + 2;
    this.turned = this.jacobian + 3 * members * rows;
    this.matrix = this.turned + 3 * members * rows;
    this.given = this.matrix + rows * rows;
    this.size = this.given + 3 * members;
  }
}
