/**
 * Offsets into the packed arrays that the iterations of a step run on. A file without imports: only then the bundler puts its numbers into
 * the loops themselves, which is worth a quarter of a step.
 *
 * Bodies: slot 0 stands for everything that can neither move nor be moved; awake dynamic bodies follow, then awake kinematic ones. A body
 * has a record in `velocity`, one in `motion`, one in `drive`, and one in `pose` if there are joints: a run of numbers at a multiple of its
 * stride.
 */
export const BODY_STRIDE = 8;

/** `velocity`: what velocity iterations read and write. */
export const VX = 0;
export const VY = 1;
export const W = 2;
/** Inverse mass and inertia, in `velocity` and in `motion` at the same offsets. Loops read them into mA, mB, iA and iB. */
export const INV_MASS = 3;
export const INV_INERTIA = 4;
/** Cosine − 1 and sine of the turn since the start of the step; in `velocity`, where contacts read anyway. */
export const COS_LESS_ONE = 5;
export const SIN = 6;
/**
 * In `velocity`: while contacts are packed, how near the body is to strained contacts, see `markHard`; later, in `bounce.ts`, the round in
 * which it bounces, negative.
 */
export const MARK = 7;
/** Thresholds of that mark: all contacts are hard from the first, and none from the second. */
export const ALL_HARD = 0;
export const NONE_HARD = 1e9;

/** `motion`: displacement within this sub-step (velocity · h, then position corrections) … */
export const QX = 0;
export const QY = 1;
export const QW = 2;
/** … and since the start of the step, without this sub-step's. */
export const DX = 5;
export const DY = 6;
export const DW = 7;

/** `drive`: what integration adds and takes in each sub-step. */
export const GAIN_X = 0;
export const GAIN_Y = 1;
export const GAIN_W = 2;
export const KEEP_LINEAR = 3;
export const KEEP_ANGULAR = 4;
/** Square of the radius of gyration times REST_SPIN_WEIGHT; negative for bodies without rest damping … */
export const REST_RADIUS = 5;
/** … which bodies without a contact do not have either: 1 if the body has one. */
export const TOUCHED = 6;
/** The normal impulses with which all contacts of the body together start the step, N·s. */
export const LOAD = 7;

/**
 * Bits of `SolverData.traits`. The first three are for contacts: a joint that is no custom constraint holds the body, it has several
 * shapes, its surface moves. The others mark bodies of groups of joints while these are looked at.
 */
export const LINKED = 1;
export const COMPOUND = 2;
export const RUBS = 4;
export const MEMBER = 8;
export const HELD = 16;

/**
 * Contacts. With normal n, tangent t = (−n.y, n.x) and arm r, `RN` = r × n and `RT` = r × t = r · n are all that the solver needs of r:
 * n · (R(θ) r) = RT·cos θ + RN·sin θ.
 *
 * Records lie two by two with their numbers interleaved, as kernels that solve two at a time need them: the record of contact k begins at
 * (k & EVEN) · stride + (k & 1), and its numbers are two apart.
 *
 * Two points lie on a line along t, or nearly so, and friction does the same at either. So there is one friction for both, at a point
 * between them, with the load of both.
 */
/** A mask: of two neighbours the even one. */
export const EVEN = -2;
export const NX = 0;
export const NY = 2;
/** Share of the overlap that a position iteration removes; negative where PRESSED_PUSH is no bound. */
export const SHARE = 4;
/** Surface velocity along t and along n. */
export const SURFACE_T = 6;
export const SURFACE_N = 8;
export const RT_A = 10;
export const RT_B = 12;
/** Effective mass along the tangent, coefficient of friction. */
export const TANGENT_MASS = 14;
export const FRICTION = 16;
/** Impulse of this sub-step, and of the whole step without this sub-step's: of each impulse the sum is SUM on. */
export const TANGENT = 18;
export const SUM = 2;
export const TANGENT_SUM = TANGENT + SUM;

/** Of each point, from here to START1 and SEPARATION1: the arms … */
export const RN_A1 = 22;
export const RN_B1 = 24;
/** … the impulse of this sub-step, and of the whole step without this sub-step's … */
export const NORMAL1 = 26;
export const NORMAL_SUM1 = NORMAL1 + SUM;
/** … the normal velocity that it is driven to, with the sign changed … */
export const BIAS1 = 30;
/** … and the separation at the start of the step, and at the start of the sub-step. */
export const START1 = 32;
export const SEPARATION1 = 34;
/** From the numbers of the first point to those of the second. */
export const SECOND = 16;

/** One-point records only: effective mass along the normal. */
export const NORMAL_MASS = 36;
/** One-point records only: rolling. Its impulse lies where records of two points have the second normal one, see `IMPULSES`. */
export const ROLL_MASS = 38;
export const ROLL_FRICTION = 40;
export const ROLL = NORMAL1 + SECOND;
export const ROLL_SUM = ROLL + SUM;
/**
 * One-point records only: as RT, for the part of the arm that turns with the body. Of a circle that is the arm of its centre, as its
 * surface stays where it is when it turns.
 */
export const PIVOT_A = 46;
export const PIVOT_B = 48;
/**
 * One-point records only: by how much a unit of friction and of rolling lessens the normal impulse that is found after them, and one of
 * friction the rolling.
 */
export const NORMAL_OF_TANGENT = 50;
export const NORMAL_OF_ROLL = 52;
export const ROLL_OF_TANGENT = 54;
/** How many numbers a record has. */
export const ONE_STRIDE = 28;
/** A bit of `ContactBatch.point`. */
export const ONE_OF_TWO = 2;

/** Two-point records only: the numbers of the second point, and K of both. */
export const RN_A2 = RN_A1 + SECOND;
export const RN_B2 = RN_B1 + SECOND;
export const NORMAL2 = NORMAL1 + SECOND;
export const NORMAL_SUM2 = NORMAL_SUM1 + SECOND;
export const BIAS2 = BIAS1 + SECOND;
export const START2 = START1 + SECOND;
export const SEPARATION2 = SEPARATION1 + SECOND;
export const K11 = 36;
export const K22 = K11 + SECOND;
export const K12 = 54;
/** K⁻¹. */
export const I11 = 56;
export const I12 = 58;
export const I22 = 60;
/** Where friction acts between the points: 0 at the second, 1 at the first. That share of it the first point keeps for the next step. */
export const PART = 62;
export const TWO_STRIDE = 32;

/**
 * Offsets pass through this mask in the hot loops. It changes none, as no array is that long, but it tells the compiler that they are
 * small, so that adding a field to one needs no check for overflow: a twentieth of a step.
 */
export const OFFSET = 0xfffffff;
/** A bit of the first offset of the second contact of two: it shares a body that can move with the first, and waits for it. */
export const WAITS = 0x20000000;
/** The same bit of rigid point joints. No two of them that lie side by side share a body; here it says that there is no second. */
export const MISSING = 0x20000000;
/** Bits of `SolverData.deepCircles` and of what kernels return: deep are circles that do not press on each other; some that do. */
export const CROWDED = 2;
export const PRESSED = 4;

/** Contacts are solved in the order of their shapes, except that each window of so many is split into four runs, which take turns. */
export const WINDOW = 128;
export const RUN = 32;

/** Parts of the contacts that are hard to solve, in `SolverData.hard`: from which to which contact of two points, and of one. */
export const FROM_TWO = 0;
export const TO_TWO = 1;
export const FROM_ONE = 2;
export const TO_ONE = 3;
export const HARD_STRIDE = 4;

/**
 * What is kept of a contact that turns with its bodies, in `TurningList`: its normal, the separations of both points, the surface
 * velocities …
 */
export const TURNING_NX = 0;
export const TURNING_NY = 1;
export const TURNING_START1 = 2;
export const TURNING_START2 = 3;
export const TURNING_SURFACE_N = 4;
export const TURNING_SURFACE_T = 5;
/** … how far the centres of its bodies are apart along the normal as the step begins, and its points from the pivots of circles, m. */
export const TURNING_BEGAN = 6;
export const TURNING_PIVOTS = 7;
export const TURNING_STRIDE = 8;

/** What is kept of the contact of a point that may bounce, in `BounceList.arms`. */
export const BOUNCE_NX = 0;
export const BOUNCE_NY = 1;
export const BOUNCE_RN_A = 2;
export const BOUNCE_RN_B = 3;
export const BOUNCE_STRIDE = 4;

/** kg⁻¹. Stands for an infinite inverse mass, but may be multiplied by zero. */
export const IMMOVABLE = 1e30;
/** m. A separation that no motion of a step can close: switches a point off. */
export const OUT_OF_REACH = 1e9;
/** m/s. A bias that no normal impulse can reach by pushing: keeps a point out of a sub-step. */
export const OFF = 1e9;
/** rad. Up to this turn a short series for sine and cosine is exact to the last digit that matters. */
export const SMALL_TURN = 0.2;
