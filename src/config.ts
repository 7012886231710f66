/**
 * Every tolerance of the engine: its unit, the reason for its value, and what breaks if it moves. Lengths are meant for things between a
 * centimetre and tens of metres.
 */

/** m. Overlap that a contact leaves alone. Below 1.5 mm towers start to sway, fed by position corrections that never stop. */
export const CONTACT_SLOP = 0.002;

/**
 * m. Largest gap at which surfaces are already given to the solver, as speculative contacts: it stops them where they meet, so that what
 * closes within the step is not found one step too late. Larger costs work, smaller lets falling stacks run into each other.
 */
export const SPECULATIVE_MARGIN = 0.02;

/** m. The depth at which surfaces are stopped: more than rounding, so that what rests on something is found touching it. */
export const TOUCH_DEPTH = 1e-4;

/** m. Two reference faces whose depths differ by less count as equally deep: that of shape A is taken, so that noise does not flip it. */
export const FACE_TIE = 1e-6;

/**
 * m. Two polygons keep their reference face while they have moved less than this relative to each other, and turned so little that no
 * corner moved by more. For turns, a body that reaches less than 1 m counts as reaching 1 m: it may turn by as many radians.
 */
export const FACE_KEPT_MOTION = 0.002;

/**
 * Share of the overlap beyond the slop that a position iteration removes, between two dynamic bodies. With 0.8 of all overlap, deep or not,
 * triangles that are wedged in a heap stay 15 cm deep, as their contacts undo each other; with 0.4 some heaps of rods do not come to rest.
 */
export const PUSH_SHARE_DYNAMIC = 0.15;

/**
 * PUSH_SHARE_DYNAMIC where one body has more than UNEVEN times the mass of the other. A light body between heavy ones is pushed to and fro,
 * and these part only by its share of their masses. Without it one pile of mixed shapes in six overlaps by 4 mm somewhere after 20 s; with
 * it one in twelve, with 0.5 one in eight.
 */
export const PUSH_SHARE_UNEVEN = 0.3;

/** A ratio of two masses: PUSH_SHARE_UNEVEN applies above it. */
export const UNEVEN = 8;

/** PUSH_SHARE_DYNAMIC where one body cannot move. Less lets a heavy box sink into the ground between light ones. */
export const PUSH_SHARE_STATIC = 0.75;

/**
 * PUSH_SHARE_DYNAMIC between two circles that move: they do not sway. With 0.98 some heaps would not come to rest. It has to differ from
 * all other shares: the kernels tell by it that a contact is between circles, see DEEP_OVERLAP_CIRCLES.
 */
export const PUSH_SHARE_CIRCLES = 0.5;

/**
 * PUSH_SHARE_DYNAMIC between two moving bodies that may be hooked into each other. That is so if neither is HEAVY for the other, if either
 * has several shapes or both have constraints, and if no joints hold either of them to what does not move at two places or more, see
 * `held-contacts.ts`. It has to differ from all other shares: by this share in its record a contact gets MAX_PUSH_HOOKED.
 */
export const PUSH_SHARE_HOOKED = 0.2;

/** m. Of the overlap beyond this and the slop a larger share is removed, PUSH_SHARE_DEEP. Stacks never overlap as deep. */
export const DEEP_OVERLAP = 0.005;

/** Share of the overlap beyond DEEP_OVERLAP that a position iteration removes. */
export const PUSH_SHARE_DEEP = 0.6;

/**
 * m. Where two bodies of a heap press on each other, a sub-step pushes a point by at most this or by PRESSED_SHARE of its overlap, however many
 * iterations it has. What is pushed apart lifts all that lies on it. If that is as much as it falls back, the contacts change too fast for the
 * impulses that would carry it to build up: 4,000 circles were 0.3 m deep in each other with 40 position iterations, now 3 mm, 3,000 mixed
 * shapes without friction 80 mm with the default, now 30, and 4,000 circles of densities from 1 to 100 37 mm, now 9, and 15 without the share.
 */
export const PRESSED_PUSH = 0.02;
export const PRESSED_SHARE = 0.25;

/** m. DEEP_OVERLAP of two circles that move. */
export const DEEP_OVERLAP_CIRCLES = 0.001;

/** PUSH_SHARE_DEEP of two circles that move. With 0.6 some heaps take 15 s to come to rest, with 0.98 those of unlike masses are deeper. */
export const PUSH_SHARE_DEEP_CIRCLES = 0.75;

/** The same if they do not press on each other: those of a crowd, created overlapping. With more, two that are alone would part. */
export const PUSH_SHARE_CROWD = 0.98;

/**
 * At most so many position iterations are added to a sub-step while circles of a crowd overlap by more than DEEP_OVERLAP, counted beyond the
 * slop: 625 of them come apart within 2 s. Not while circles that do press on each other overlap as deep: a heap of 4,000 would
 * seethe for ever. Nor for polygons: where some are wedged, a heap would not come to rest.
 */
export const CROWD_SWEEPS = 4;

/**
 * m. How deep bodies that are squeezed, as in a press, may overlap before their contacts start a sub-step with less than their normal
 * impulse of the last one: with the share (this / overlap)² of it. See `squeezes.ts`.
 */
export const SQUEEZE_DEPTH = 0.01;

/**
 * m/s². Times the effective mass of a contact and the sub-step, the normal impulse with which it may start in any case. A claw that is 5 cm
 * too narrow for what it grips holds it by that.
 */
export const SQUEEZE_ACCELERATION = 240;

/**
 * m/s². It may also start with the weight of all that hangs together with it, at this gravity or more. Without that, a pusher in a world
 * without gravity went through light boxes in front of a heavy one. With 20, presses there throw their crates out at 2 m/s.
 */
export const SQUEEZE_GRAVITY = 10;

/** Factor on that weight where there are joints in it, which may be levers. */
export const SQUEEZE_LEVERAGE = 20;

/** m. Longest correction of one position iteration. It keeps what overlaps deeply from being thrown apart. */
export const MAX_PUSH = 0.2;

/** m. Bodies of several shapes that overlap by more may be held in each other by their own contacts, see `wedged.ts`. */
export const WEDGED_DEPTH = 0.02;

/**
 * m. MAX_PUSH between bodies that may be hooked into each other, see PUSH_SHARE_HOOKED. There one shape or link is pushed to and another
 * fro, and the heap around them would shake for ever: with 5 mm one heap of dumbbells in twenty does, with 1 mm heaps of chains do. It
 * still allows 1.4 m/s, but heavy balls of several shapes would fall through a hinged bridge.
 */
export const MAX_PUSH_HOOKED = 0.003;

/**
 * m/s², rad/s². If in one sweep no contact changed a velocity by more than this times the sub-step, the further sweeps are left out. A
 * tower that sways changes velocities by little in each sweep: with 5e-3 one of 25 boxes sways at 4 mm/s.
 */
export const CALM_ACCELERATION = 1e-5;

/**
 * m. A contact whose position error is smaller is not corrected, and if all are, the position iterations of the sub-step end. It is far
 * below what the next sub-step adds.
 */
export const PUSH_TOLERANCE = 1e-7;

/** m/s. An impact whose rebound would be slower does not bounce; else a resting body would hum by its own restitution. */
export const BOUNCE_THRESHOLD = 0.25;

/** At most so many times in a sub-step a blow is passed on from body to body. */
export const BOUNCE_ROUNDS = 16;

/**
 * A blow is passed on by a contact only if it is more than this times the impulse that the contact bears anyway in a sub-step. If it always
 * were, high heaps would take three times as long to come to rest.
 */
export const BOUNCE_LOAD = 2;

/** In one round, the contacts that bounce are swept over at most so many times with friction … */
export const BOUNCE_RUBS = 4;

/** … and after that at most so many times without further friction, until nothing changes. */
export const BOUNCE_SWEEPS = 16;

/** (m/s)². Sliding faster than 0.01 m/s has the dynamic coefficient of friction, slower the static one. */
export const STATIC_FRICTION_SPEED_SQUARED = 1e-4;

/** kg⁻¹. A smaller inverse effective mass counts as immovable. */
export const MIN_INVERSE_MASS = 1e-10;

/** A contact of two points whose matrix K has K11² above this times its determinant is nearly singular: only its deeper point is solved. */
export const MAX_CONDITION = 1e5;

/** m. A shorter length has no direction; a distance or pulley constraint then keeps its last one. */
export const MIN_LENGTH = 1e-6;

/** m. Circle centres closer than this have no direction between them; `(1, 0)` is taken. */
export const COINCIDENT = 1e-6;

/** m/s. Bodies in contact that are slower are damped a little. It removes the sway that a landing leaves in a tall stack. */
export const REST_SPEED = 0.01;

/** 1/s. Rate of that damping. A body in contact driven by less than about 0.002 m/s² stays below REST_SPEED. */
export const REST_DAMPING = 0.5;

/** Weight of the angular velocity, taken as a speed at the radius of gyration, in the speed that REST_SPEED limits. */
export const REST_SPIN_WEIGHT = 0.3;

/** Steps. How long an arbiter outlives its interaction, so that its impulses and settings are there when the interaction comes back. */
export const ARBITER_CACHE = 30;

/** Steps. ARBITER_CACHE of a sensor, which has nothing to keep: just long enough to tell a pause from the end of the interaction. */
export const SENSOR_CACHE = 1;

/** Steps. A body falls asleep when it, and its island, have been at rest for longer than this … */
export const SLEEP_DELAY = 60;

/** Hz. … where of shorter steps only as many count as there would be at this rate. */
export const REST_RATE = 60;

/** m/s. Forces set for one step wake a body at rest if their change since the step before adds more to its velocity in a step. */
export const FORCE_CHANGE = 0.0024;

/** (m/s)². A body is at rest if its squared speed is no larger, and the square of its motion in the last step divided by dt², … */
export const SLEEP_SPEED_SQUARED = 0.0006;

/**
 * (m/s)². … and if the squared speed of its rim, (ω·R)², is no larger than this, and the square of its last turn times R divided by dt².
 */
export const SLEEP_RIM_SPEED_SQUARED = 0.001;

/**
 * With at least so many pairs, whose records come to 160 kB, the records are worth being arranged in memory in the order of the step: those
 * of fewer stay in caches near the processor wherever they lie.
 */
export const ARRANGE_FROM = 512;

/** Steps. Records are arranged at most once in so many. */
export const ARRANGE_STEPS = 32;

/** m. Points at most this far beyond an edge of a polygon count as inside. */
export const POLYGON_POINT_TOLERANCE = 1e-6;

/** m². A point counts as inside a circle if its squared distance exceeds the squared radius by no more than this. */
export const CIRCLE_POINT_TOLERANCE = 1e-12;

/**
 * m. A shape cast has hit something when the gap is no larger. This is near rounding, as each iteration towards the hit gains many digits.
 */
export const CAST_TOLERANCE = 1e-9;

/**
 * Iterations of a sweep (a cast or time of impact) after which the axis along which two shapes are separate turns with one or the other of
 * them by turns: else what rides on a bar of 20 km that turns takes thousands. Most sweeps end long before. With 16 the mean is 24
 * iterations instead of 22.
 */
export const STILL_LOOKS = 256;

/** m. Swept shapes have met when their distance is within this of the depth that is looked for. */
export const SWEEP_TOLERANCE = 1e-6;

/**
 * Iterations. For so many, a sweep follows two bodies to find whether they meet in a step; if that is not clear by then, they meet where
 * they are. The same for those that would bounce, to find whether they pass each other.
 */
export const MEET_PATIENCE = 1000;

/** What would bounce is followed, to see if it passes, if in a step it slides by more than this share of the thinner one's half-width. */
export const PASS_SHARE = 0.1;

/**
 * m. Only where bodies would overlap as deep is there an impact: that is more than they do where they slide or rest on something, so that
 * the seams of a tiled floor stop nothing. Larger lets fast bodies get deeper into surfaces.
 */
export const IMPACT_DEPTH = 0.05;

/** IMPACT_DEPTH is at most this share of the sum of the half-widths of both shapes, so that thin ones cannot pass through each other. */
export const IMPACT_SHARE = 0.25;

/**
 * IMPACT_DEPTH is at most this share of the half-width of the thinner shape, if the solver does not see the pair, or it is never foreseen.
 * Deeper, that shape would slip into the foot of a thick wall, or into the seam of two tiles, where neither of the two holds it. With 1.5,
 * rods that fly lengthwise at a seam get in. With neither value is anything stopped that skims over tiles.
 */
export const IMPACT_SHARE_THIN = 0.95;

/**
 * Where shapes land on each other, IMPACT_DEPTH is at most this share of the half-width of the thinner one, but no less than IMPACT_LEAST:
 * boxes of 0.1 m that landed on a corner, and turned onto another, were half in the floor at the end of a step.
 */
export const IMPACT_SHARE_SMALL = 0.2;

/** m. What rests or slides on something overlaps by less. */
export const IMPACT_LEAST = 0.01;

/**
 * rad. IMPACT_SHARE_THIN does not apply to shapes that turn relative to each other by so much in the step: they would be stopped in it
 * again and again, and stay in the air.
 */
export const IMPACT_TURN = 0.3;

/** m. IMPACT_DEPTH for contacts that are foreseen. These stop nothing, so it only has to be more than sliding bodies overlap. */
export const FORESIGHT_DEPTH = 0.005;

/** rad. If two bodies together turn by more in a step, their contact does not hold for all of it: it is not foreseen, but swept. */
export const SOLVED_TURN = 0.2;

/** A share of the step: impacts of a body so soon after the first are solved at once with it, as where a box falls flat on tiles. */
export const SAME_TIME = 2e-3;

/** m. How much farther than foreseen a body may go in a step before what is near it is searched again. More: more have something near. */
export const CLEARANCE = 0.1;

/**
 * Steps. So far ahead, at the speed it has, the space around a body is searched at once. With more, the search is wider, finds something
 * more often, and then was for nothing.
 */
export const CLEAR_STEPS = 8;

/**
 * Factor on the depth at which bodies with joints are stopped. With IMPACT_SHARE it makes one half at most: what is deeper in a wall leaves
 * it on the other side. With 3, balls on joints did.
 */
export const JOINT_PATIENCE = 2;

/** What is already deeper than that is stopped only when it gets deeper by this share of it: else it could never move out again. */
export const DEEPER_SHARE = 0.1;

/**
 * m. The same where one of the two is kinematic and goes on: getting so much deeper is enough. It is more than rounding, as what lies deep
 * in two bodies that move alike is to be carried along by them, not stopped by the one on the way that the other gives it.
 */
export const DEEPER_CARRIED = 1e-5;

/** m. Static shapes whose faces differ by no more are one surface for what slides over them. With less, real tiles catch things. */
export const FLUSH_TOLERANCE = 5e-4;

/** At most so many times friction and normal impulses of an impact are solved, by turns. */
export const IMPACT_ITERATIONS = 10;

/** m/s. An impact is solved once another iteration changes no velocity by more. */
export const IMPACT_TOLERANCE = 1e-9;

/** m. Vertices closer than this are one point. */
export const VERTEX_TOLERANCE = 1e-9;

/** Relative. A vertex lies on the line of its neighbours if its distance from that line is below this times the distance between them. */
export const COLLINEAR_TOLERANCE = 1e-9;

/**
 * m, rad, and either per second. A body is frozen if its position, its velocity, or what it gains in a sub-step is larger, or not a number:
 * beyond this, squares are infinite.
 */
export const FAR = 1e150;

/**
 * m. No shape is larger, or farther from the origin of its body: its moment of inertia grows with the fourth power, and would be infinite.
 */
export const MAX_SIZE = 1e75;

/**
 * How many interactions a shape has before further shapes whose centres it covers, and which cover its own, have to wait, if they have as
 * many. Four thousand boxes at one point are then a quarter of a million pairs instead of eight million, which do not fit into memory.
 */
export const CROWD = 64;

/** Default of `World.velocityIterations` and `World.positionIterations`: totals per step, spread over the sub-steps. */
export const DEFAULT_ITERATIONS = 8;

/**
 * Sweeps over contacts for each velocity iteration. With 1 a tower of 25 sways for ever, a pyramid of base 20 settles by 14 mm instead of
 * 9, and what carries 100 times its weight buckles. If contacts of one point are left out of the further sweeps, a pile of mixed shapes
 * trembles at 0.1 m/s.
 */
export const CONTACT_SWEEPS = 1.5;

/**
 * Share of the change of a normal impulse within a step that the warm start of the next one takes over. All of it is control by integration
 * alone, without damping: a pyramid of base 100 then heaves by up to 8 mm a contact for ever, and never sleeps. With 0.95 it still does,
 * with 0.9 it rests after 15 s; with 0.8 a tower of 15 slides by 4 cm.
 */
export const IMPULSE_MEMORY = 0.9;

/** m/s. What comes faster strikes, and is stopped for good, see `shocks.ts`. */
export const SHOCK_SPEED = 0.3;

/** At most so many contacts and joints are solved together for a shock. More are a heap, where what presses is not over within a step. */
export const SHOCK_CONTACTS = 32;

/**
 * At most so many single contacts and joints are solved for a shock, counted over all sweeps; that takes about 0.05 ms. So the fewer there
 * are, the more sweeps they may have. With 120 for two, a body that falls on a fiftieth of its mass comes up again by a sixth.
 */
export const SHOCK_WORK = 2000;

/**
 * Factor on the number of sweeps over those parts of the list of contacts that are hard to solve. With 1 a house of cards slips apart as it
 * is put into the world, and a tower of ten buckles under 100 times its weight; with 3 some such towers still do.
 */
export const HARD_SWEEPS = 4;

/** A part is hard as a whole if more than this share of its contacts is new and slow: it was just put there, and is no falling heap. */
export const NEW_SHARE = 0.5;

/** Steps for which a contact is new: at first its impulses are far off. */
export const NEW_STEPS = 8;

/** m/s. A contact is slow if both its bodies are slower than this. */
export const NEW_SPEED = 1;

/**
 * rad/s. Edges in contact rock if they turn relative to each other faster than this and slower than TUMBLE_SPIN, in a column. A tower that
 * was pushed sways: if few sweeps pass its load from side to side too late, that feeds the sway, and it swings for ever. With 1e-4 some
 * tremble at 0.4 mm/s for ever, with 1e-3 they sway by 1 cm.
 */
export const ROCK_SPIN = 1e-5;

/** rad/s. What turns as fast tumbles: most contacts in a drum do. */
export const TUMBLE_SPIN = 0.1;

/**
 * A share. A contact is in a column if it bears more than this, and less than 1 minus this, of all that the contacts of a body bear. That
 * is a half in the middle of a column, but a quarter in a pyramid.
 */
export const COLUMN_PART = 0.42;

/**
 * A part is hard as a whole if more than this share of its contacts that turn rocks. With 0.2 a large pyramid that heaves takes a tenth
 * longer, and a sway dies no sooner.
 */
export const ROCK_SHARE = 0.5;

/**
 * A part is hard by ROCK_SHARE only if more than this share of all its contacts rocks. Where a few contacts of a pyramid made it hard,
 * sweeps that came and went made that tremble at 0.2 mm/s.
 */
export const ROCK_LEAST = 0.04;

/**
 * If more than this share of the contacts of a part is strained, these are hard, and those next to them. With 0.08 a heavy top that stands
 * among 100 other boxes falls; with 0.06 twice as much of a drum of 1,000 boxes is hard. Refused: the whole part, which is most of a heap
 * of ragdolls, and lets that top fall, too; only bodies with two strained contacts: a pyramid of base 100 overlaps by 4.7 mm.
 */
export const STRAIN_SHARE = 0.075;

/**
 * m/s. A contact is strained if its impulse would give its bodies as much in a sub-step, that is if it carries about a hundred times their
 * weight. With 20, towers of 12 under heavy tops buckle.
 */
export const STRAIN_SPEED = 8;

/**
 * A share. Between bodies of like mass, a strained contact must also carry more than this of what all contacts of one of them carry. That
 * is a half in a column, which buckles, but a quarter in a wide heap, where a load is only the number of rows. With 0.25 half of a pyramid
 * of base 160 is strained, with 0.33 a column under a row of 50 boxes buckles.
 */
export const STRAIN_PART = 0.28;

/**
 * Bodies are of like mass if their inverse masses differ by at most this share of the sum of these. With 0.2 mixed piles overlap deeper:
 * 5.6 mm instead of 5.0 in the mean of 24.
 */
export const STRAIN_UNLIKE = 0.05;

/**
 * STRAIN_UNLIKE for contacts of one point, of which only those between unlike bodies are strained: one has to be three times as heavy. That
 * is for a light wedge between heavy discs, which else swings for ever. With 0.05 barrels of mixed shapes take an eighth longer.
 */
export const STRAIN_UNLIKE_ONE = 0.5;

/** Steps on end for which a contact has to bear so much before it is strained: an impact is over sooner. With 20, towers buckle. */
export const STRAIN_DELAY = 8;

/** Steps for which it then counts as strained; if its bodies are alike, no more than it was. Sweeps that come and go shake heaps. */
export const STRAIN_STEPS = 60;

/**
 * A ratio of two sub-steps. If a sub-step is more than so many times as long as those that the impulses were remembered from, see
 * `scaleImpulses` in `prepare.ts`, there is no warm start, except for contacts of what is in balance, see `dropUnsteady` there: what is
 * random in the impulses of short sub-steps does not get smaller with the load, and would be multiplied.
 */
export const MAX_GROWTH = 4;

/** m²/s⁴. What has accelerated by more in a step is not in balance: see `dropUnsteady` in `prepare.ts`. */
export const STEADY_ACCELERATION_SQUARED = 1;

/**
 * Steps. Where steps become shorter, the impulses count as those of the longer ones before for as much time as these took in all, but of at
 * most so many. After that it is slow motion.
 */
export const MOST_SPANS = 120;

/** Default of `World.substeps`: the fewest with which tall towers, heavy tops and ramps are all right. */
export const DEFAULT_SUBSTEPS = 4;

/**
 * m/s, rad/s. In a world with constraints faster motion is cut to this in each sub-step, so that what cannot be solved, such as a stiff
 * spring stretched by miles, stays finite.
 */
export const MAX_SPEED = 1e6;

/**
 * rad²/s². A product of the angular velocities of two bodies. Above it, their contact turns with them, if they have joints or several
 * shapes, or if something that nothing moves carries the other. Below it a box on a platform creeps by 25 µm in a second at most; at 0.5
 * rad/s it would by 2 mm.
 */
export const TURNS_TOGETHER = 1e-3;

/**
 * rad. What turns farther in a step does not follow its arc; where both bodies have joints, what turns farther in a sub-step. An arc takes
 * ω²·h/2 for each metre, which is more than what moves has once a sub-step is longer than 2/ω. Without a limit what lay in a drum at 10⁵
 * rad/s left with 100 times its speed.
 */
export const MOST_BEND = 0.5;

/** A cosine. The normal of a face of a floor may differ by at most that angle, 102°, from the contact that the face is to replace. */
export const FACE_LOOKS = -0.2;

/** rad. A face of a floor is not open if the gap in front of it, seen from its nearer end, is narrower than this. */
export const FACE_GAP = 0.2;

/** In right angles. If the wedges of a floor leave less between them, that is no opening. */
export const FACE_SLIT = 0.3;

/** A velocity that changed by more than this times what forces add in a step bounced, … */
export const BOUNCE_SUDDEN = 2;

/** … if the body then moves along that change with more than this share of it. */
export const BOUNCE_LEFT = 0.01;
