/**
 * Offsets into the records of joints. This file has no imports, as only then the bundler writes the numbers into the loops themselves.
 *
 * A record is the packed form of one constraint; records are in the order in which joints are solved. It begins with a head that is common
 * to all kernels, the first three numbers of which are those of softness.ts; the rest depends on the kernel that solves it.
 */
export const SOFTNESS = 0;
export const FEEDBACK = 1;
export const RATE = 2;
/** The largest speed with which an error is corrected. */
export const MAX_BIAS = 3;
/** N·s. The impulse of a sub-step is clamped to this. */
export const LIMIT = 4;
/** N·s. If the impulse of the step exceeds this, the joint breaks. */
export const BREAK = 5;
/** If the error exceeds this, the joint breaks. */
export const MAX_ERROR = 6;
/** s⁻¹. A position correction times this is the momentum made of it. */
export const CARRY = 7;
/** 1 if position errors are corrected. */
export const PUSH = 8;
/** 1 if LIMIT or BREAK is finite. */
export const CHECKED = 9;
/** 1 if the last position iteration moved the bodies without turning them. */
export const SNAPPED = 10;
/** 1 if a large error is corrected without turning the bodies. */
export const SNAPS = 11;
/**
 * m, rad. The most that is corrected of an error at once, see `reachLess`; if it is below 0, its absolute value is left open instead, see
 * `correctShare`.
 */
export const REACH = 12;
const HEAD = 13;

/**
 * What rigid point joints keep from step to step. They have no such head, as their two rows have unit columns, so that their arms are the
 * whole Jacobian. First the anchors, in the coordinates of their bodies, on immovable bodies in those of the world; and the impulse of the
 * last sub-step …
 */
export const KEPT_ANCHOR_AX = 0;
export const KEPT_ANCHOR_AY = 1;
export const KEPT_ANCHOR_BX = 2;
export const KEPT_ANCHOR_BY = 3;
export const KEPT_IMPULSE_X = 4;
export const KEPT_IMPULSE_Y = 5;
/** … and what the last step gave: an impulse to B, its opposite to A, and an angular impulse to each. */
export const KEPT_SUM_X = 6;
export const KEPT_SUM_Y = 7;
export const KEPT_SUM_WA = 8;
export const KEPT_SUM_WB = 9;
/** The index of its record for a step. */
export const KEPT_SLOT = 10;
/**
 * The origins of A and of B, if they are immovable, else 0: the angular impulse of an immovable body is summed up about the origin of the
 * world.
 */
export const KEPT_ORIGIN_AX = 11;
export const KEPT_ORIGIN_AY = 12;
export const KEPT_STRIDE = 15;

/**
 * Their records for a step are interleaved two by two, as those of contacts (`layout.ts`). First what velocity iterations use: arms,
 * impulse and K⁻¹ …
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
/**
 * … then what position iterations use: the arms at the last exact sweep, the part of the error that is constant in the linear sweeps after
 * it, corrections, how far each body had turned in the sub-step at that exact sweep, rad …
 */
export const PLACED_AX = 18;
export const PLACED_AY = 20;
export const PLACED_BX = 22;
export const PLACED_BY = 24;
export const OFFSET_X = 26;
export const OFFSET_Y = 28;
export const PUSH_X = 30;
export const PUSH_Y = 32;
export const PLACED_WA = 34;
export const PLACED_WB = 36;
/** … the error at the start of the sub-step; 1 if a large one is corrected without turning the bodies … */
export const ERROR_X = 38;
export const ERROR_Y = 40;
export const POINT_SNAPS = 42;
/** … anchors … */
export const ANCHOR_AX = 44;
export const ANCHOR_AY = 46;
export const ANCHOR_BX = 48;
export const ANCHOR_BY = 50;
/** … what the step gave so far; and the same as CARRY. */
export const SUM_X = 52;
export const SUM_Y = 54;
export const SUM_WA = 56;
export const SUM_WB = 58;
export const POINT_CARRY = 60;
/** How many numbers a record has. */
export const POINT_STRIDE = 31;

/** Kernels: rigid point joints that do not break … */
export const POINT = 0;
/** … angles, motors, and points that keep an angle (`order/pinned.ts`), that do not break … */
export const TURN = 1;
/** … distances … */
export const DISTANCE = 2;
/** … lines … */
export const LINE = 3;
/** … welds, and points that are soft or may break … */
export const ANCHORED = 4;
/** … joints with any number of rows and bodies, angles and motors that may break among them … */
export const BLOCK = 5;
/** … and custom constraints, which do the same by callbacks. */
export const CUSTOM = 6;

/**
 * Records of TURN. After the head come, as in a `BlockLayout` of one row: impulse, the correction of this sub-step, bias; then what velocity
 * iterations use besides: range of the impulse, ratio and 1 / K …
 */
export const TURN_IMPULSE = 13;
export const TURN_PUSH = 14;
export const TURN_BIAS = 15;
export const TURN_LOW = 16;
export const TURN_HIGH = 17;
export const TURN_RATIO = 18;
export const TURN_MASS = 19;
/** … then what position iterations use: the value at the start of the sub-step, bounds … */
export const TURN_VALUE = 20;
export const TURN_LOWER = 21;
export const TURN_UPPER = 22;
/** … then: 1 if there are bounds; the part of the value that is due to bodies that cannot move; what the step gave to A and to B so far. */
export const TURN_BOUNDED = 23;
export const TURN_STILL = 24;
export const TURN_GIVEN_A = 25;
export const TURN_GIVEN_B = 26;
/** rad. The angle that a point keeps, from which its bounds are a whole number of turns away; else NaN. */
export const TURN_ANGLE = 27;
/** The impulse with which the step began. */
export const TURN_BEGAN = 28;
/** rad/s. The rate of a motor, before it is limited by stops. */
export const TURN_RATE = 29;
export const TURN_STRIDE = 30;

/**
 * The own numbers of a distance: the anchors of A and B, the direction from one to the other when they were last far enough apart to have
 * one, bounds.
 */
export const DISTANCE_ANCHORS = 0;
export const DISTANCE_NX = 4;
export const DISTANCE_NY = 5;
export const DISTANCE_LOWER = 6;
export const DISTANCE_UPPER = 7;
export const DISTANCE_OWN = 8;

/** The layout of the record of any other joint, with D rows and N members. */
export class BlockLayout {
  /** λ, corrections of this sub-step, bias: first of all, as in records of TURN … */
  readonly impulse: number;
  readonly push: number;
  readonly bias: number;
  /** … error (in position iterations without its linear part) … */
  readonly error: number;
  /** … scratch, λ of the step so far, momentum of corrections of the step so far: D numbers each. */
  readonly work: number;
  readonly total: number;
  readonly carried: number;
  /** Range of the last row's impulse … */
  readonly low: number;
  readonly high: number;
  /** … and what the farther of its two bounds adds to `bias`, and to `error`; infinite if there is none, and for springs. */
  readonly farBias: number;
  readonly farError: number;
  /** The Jacobian of velocity iterations, and that of position iterations. */
  readonly jacobian: number;
  readonly turned: number;
  /** K, factored. */
  readonly matrix: number;
  /** What the step gave to each member so far. */
  readonly given: number;
  /** rad. By how much each member had turned in the sub-step when `turned` was written. */
  readonly placed: number;
  /** What only its kernel knows of: of a distance from DISTANCE_ANCHORS on. */
  readonly own: number;
  readonly size: number;

  constructor(
    readonly rows: number,
    readonly members: number,
    owned = 0,
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
    this.farBias = this.low + 2;
    this.farError = this.low + 3;
    this.jacobian = this.low + 4;
    this.turned = this.jacobian + 3 * members * rows;
    this.matrix = this.turned + 3 * members * rows;
    this.given = this.matrix + rows * rows;
    this.placed = this.given + 3 * members;
    this.own = this.placed + members;
    this.size = this.own + owned;
  }
}
