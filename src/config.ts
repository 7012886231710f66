/** Every tolerance of the engine: unit, reason, and what breaks if it moves. Lengths are for things between a centimetre and tens of metres. */

/** m. Overlap that is left alone at a contact. Below 1.5 mm towers start to sway (pushes that never stop feed it). */
export const CONTACT_SLOP = 0.002;

/**
 * m. Surfaces that are apart by no more than this are handed to the solver as well, which stops them when they meet; so
 * what closes within the step is not found one step too late. Larger costs work, smaller lets falling stacks run into each other.
 */
export const SPECULATIVE_MARGIN = 0.02;

/** m. The depth at which surfaces are stopped: more than rounding, so that what rests on something is found touching it. */
export const TOUCH_DEPTH = 1e-4;

/** m. Two faces whose depths differ by less count as equally deep and shape A's is taken; stops noise from flipping it. */
export const FACE_TIE = 1e-6;

/** m. While two polygons move less than this against each other, and turn so little that it moves no corner by more, the edges that face each other are not chosen anew. What reaches less than 1 m may turn by as many radians. */
export const FACE_KEPT_MOTION = 0.002;

/**
 * Share of the overlap beyond the slop removed per position iteration, between two dynamic bodies. With 0.8 for all overlap, deep or not, triangles that are
 * wedged in a heap stay 15 cm deep, as their contacts undo each other; with 0.4 some heaps of rods do not rest.
 */
export const PUSH_SHARE_DYNAMIC = 0.15;

/**
 * The same where one has more than UNEVEN times the mass of the other: a light thing between heavy ones is pushed to and fro, and these come apart only by its share
 * of their masses. Without it one pile of mixed shapes in six is 4 mm deep somewhere after 20 s, with it one in twelve, with 0.5 one in eight.
 */
export const PUSH_SHARE_UNEVEN = 0.3;

/** Times the mass of another body: so much more is uneven. */
export const UNEVEN = 8;

/** The same where one side cannot move. Less lets a heavy box sink into the ground between light ones. */
export const PUSH_SHARE_STATIC = 0.75;

/** The same between two circles that move: they do not sway. With 0.98 some heaps would not rest. It has to differ from all other shares: by it a contact is told to be of circles, see DEEP_OVERLAP_CIRCLES. */
export const PUSH_SHARE_CIRCLES = 0.5;

/**
 * The same between two bodies that move and may be hooked into each other: neither is HEAVY for the other, either has several shapes or both have constraints, and joints hold neither to
 * what does not move at two places or more, see `held-contacts.ts`. It has to differ from all other shares, as it is by this share in its record that a contact gets MAX_PUSH_HOOKED.
 */
export const PUSH_SHARE_HOOKED = 0.2;

/** m. Of overlap deeper than this a larger share is removed: stacks never have it, and what was created overlapping comes apart twice as fast. */
export const DEEP_OVERLAP = 0.005;

/** The share of overlap beyond DEEP_OVERLAP that is removed. */
export const PUSH_SHARE_DEEP = 0.6;

/** m. DEEP_OVERLAP of two circles that move. */
export const DEEP_OVERLAP_CIRCLES = 0.001;

/** PUSH_SHARE_DEEP of two circles that move. More would part two that are alone. */
export const PUSH_SHARE_DEEP_CIRCLES = 0.98;

/** Most further position iterations of a sub-step while circles are deeper than DEEP_OVERLAP: 625 of them, created overlapping, come apart within 2 s. Not for polygons: where some are wedged, a heap would not rest. */
export const CROWD_SWEEPS = 4;

/** m. What is pressed may overlap so far before its contacts start sub-steps with less than they gave, see `squeezes.ts`; that with the square of this through the overlap. */
export const SQUEEZE_DEPTH = 0.01;

/** m/s², times the mass that a contact moves: so much it may give in any case. A claw that is 5 cm too narrow for what it grips holds it by that. */
export const SQUEEZE_ACCELERATION = 240;

/** m/s². … and so much all that hangs together weighs, at least: without gravity a pusher went through light boxes before a heavy one. With 20 presses there throw their crates at 2 m/s. */
export const SQUEEZE_GRAVITY = 10;

/** … times this where joints are in it, which may be levers. */
export const SQUEEZE_LEVERAGE = 20;

/** m. Longest correction of one position iteration; keeps deep overlaps from being thrown apart. */
export const MAX_PUSH = 0.2;

/**
 * m. The same between what may be hooked into each other, one shape or link pushing to and another fro: the heap around would shake for ever. With 5 mm one heap of
 * dumbbells in twenty does, with 1 mm those of chains. Still 1.4 m/s, but heavy balls of several shapes would fall through a hinged bridge.
 */
export const MAX_PUSH_HOOKED = 0.003;

/** m/s², rad/s². If no contact changed a velocity by more than this times the sub-step in a sweep, that needs no further one. A tower that sways changes them by little in each: with 5e-3 one of 25 boxes sways at 4 mm/s. */
export const CALM_ACCELERATION = 1e-5;

/** m. A remaining error below this ends the position iterations of the sub-step: it is far below what the next one adds. */
export const PUSH_TOLERANCE = 1e-7;

/** m/s. An impact whose rebound would be slower does not bounce; else a resting body would hum on its own restitution. */
export const BOUNCE_THRESHOLD = 0.25;

/** How often a blow goes on from body to body in a sub-step at most. */
export const BOUNCE_ROUNDS = 16;

/** A blow goes on where it is more than so many times what a contact bears anyway in a sub-step. If it always did, high heaps would take three times as long to come to rest. */
export const BOUNCE_LOAD = 2;

/** What bounces in one round is swept over so often with friction. */
export const BOUNCE_RUBS = 4;

/** After that what bounces is swept over so often at most without more friction, until nothing changes. */
export const BOUNCE_SWEEPS = 16;

/** (m/s)². Sliding faster than 0.01 m/s takes the dynamic coefficient of friction, slower the static one. */
export const STATIC_FRICTION_SPEED_SQUARED = 1e-4;

/** kg⁻¹. An inverse effective mass below this counts as immovable. */
export const MIN_INVERSE_MASS = 1e-10;

/** A two-point contact whose matrix K has K11² above this times its determinant is solved as its deeper point alone. */
export const MAX_CONDITION = 1e5;

/** m. A length below this has no direction; a distance or pulley constraint keeps the last one it had. */
export const MIN_LENGTH = 1e-6;

/** m. Circle centres closer than this have no direction between them; `(1, 0)` is taken. */
export const COINCIDENT = 1e-6;

/** m/s. Bodies in contact below this speed are damped a little; removes the sway that a landing leaves in a tall stack. */
export const REST_SPEED = 0.01;

/** 1/s. Strength of that damping. A body in contact driven by less than about 0.002 m/s² stays below REST_SPEED. */
export const REST_DAMPING = 0.5;

/** Weight of the spin, taken at the radius of gyration, in the speed that REST_SPEED limits. */
export const REST_SPIN_WEIGHT = 0.3;

/** steps. How long an arbiter outlives its interaction, so that its impulses and settings are there when it comes back. */
export const ARBITER_CACHE = 30;

/** steps. The same for a sensor, which has nothing to keep; long enough to tell a pause from no interaction. */
export const SENSOR_CACHE = 1;

/** steps. A body sleeps when it, and its island, have been at rest for longer than this … */
export const SLEEP_DELAY = 60;

/** Hz. … of which shorter ones count as so many in a second. */
export const REST_RATE = 60;

/** m/s. What forces for one step may add to a velocity, more or less than those of the step before, to what is at rest. */
export const FORCE_CHANGE = 0.0024;

/** (m/s)². At rest: squared speed, and squared motion of the last step over dt². */
export const SLEEP_SPEED_SQUARED = 0.0006;

/** (m/s)². At rest: squared speed of the rim, (ω·R)², and of the last turn over dt². */
export const SLEEP_RIM_SPEED_SQUARED = 0.001;

/** So many pairs, whose records come to 160 kB, are worth being arranged in memory: those of fewer stay near the processor wherever they lie. */
export const ARRANGE_FROM = 512;

/** Steps. No more often than that. */
export const ARRANGE_STEPS = 32;

/** m. Points this far beyond an edge of a polygon count as inside. */
export const POLYGON_POINT_TOLERANCE = 1e-6;

/** m². Squared distances this much larger than the squared radius count as inside a circle. */
export const CIRCLE_POINT_TOLERANCE = 1e-12;

/** m. A swept shape has hit something when the gap is no larger; near rounding, as each step towards it gains many digits. */
export const CAST_TOLERANCE = 1e-9;

/**
 * Looks of a sweep after which the axis along which two shapes are apart turns with one or the other of them by turns: else what rides on a bar of 20 km that
 * turns takes thousands. Most sweeps end long before, and with 16 the mean of all is 24 looks instead of 22.
 */
export const STILL_LOOKS = 256;

/** m. Shapes that are swept have met when the gap to the depth wanted is no larger. */
export const SWEEP_TOLERANCE = 1e-6;

/** Looks. For so long bodies are followed to see whether they meet in a step; if that is not clear by then, they meet where they are. So are those that would bounce, to see whether they pass. */
export const MEET_PATIENCE = 1000;

/** What would bounce is followed if in a step it goes along the other by more than this share of half the width of the thinner one. */
export const PASS_SHARE = 0.1;

/** m. An impact is one only if the bodies would overlap by as much: more than they do where they slide or rest on something, so that the joints of a tiled floor stop nothing. Larger lets fast things enter surfaces farther. */
export const IMPACT_DEPTH = 0.05;

/** IMPACT_DEPTH is no more than this share of the thickness of both shapes, so that thin ones cannot pass each other. */
export const IMPACT_SHARE = 0.25;

/**
 * IMPACT_DEPTH is no more than this share of half the thickness of the thinner shape, where the solver does not see it or it is never foreseen: it would slip into the foot of a thick wall, or into the joint of two tiles, of which neither holds it then. With 1.5 rods that fly at a joint
 * lengthwise get in; what skims over tiles is stopped by none of them with either.
 */
export const IMPACT_SHARE_THIN = 0.95;

/** IMPACT_DEPTH is no more than this share of half the thickness of the thinner shape, but IMPACT_LEAST: boxes of 0.1 m that landed on a corner, and turned onto another, were half in the floor as a step ended. */
export const IMPACT_SHARE_SMALL = 0.2;

/** m. What lies on something or slides over it overlaps by less. */
export const IMPACT_LEAST = 0.01;

/** rad. IMPACT_SHARE_THIN is not asked of shapes that turn against each other by so much in the step: these would be stopped in it again and again, and stay in the air. */
export const IMPACT_TURN = 0.3;

/** m. IMPACT_DEPTH for contacts that are foreseen: they stop nothing, so it has only to be more than what sliding bodies overlap by. */
export const FORESIGHT_DEPTH = 0.005;

/** rad. Contacts of bodies that turn by more in a step, both together, do not hold for all of it: they are not foreseen, and swept all the same. */
export const SOLVED_TURN = 0.2;

/** As a share of the step: meetings of a body that come so soon after the first come at once with it, as for a box that falls flat on tiles. */
export const SAME_TIME = 2e-3;

/** m. How much farther than foreseen a body may go in a step before it is looked at again; more means that more are near something. */
export const CLEARANCE = 0.1;

/** For so many steps, at the speed it has, a body is looked around at once; more means a wider look, which finds something more often, and was for nothing then. */
export const CLEAR_STEPS = 8;

/** So many times as deep as others jointed bodies may get before they are stopped. Times IMPACT_SHARE it is a half at most: what is deeper in a wall leaves it on the other side. With 3 jointed balls did. */
export const JOINT_PATIENCE = 2;

/** What is deeper than that already is stopped only if it gets deeper by this share of it: else it would never move out again. */
export const DEEPER_SHARE = 0.1;

/** m. DEEPER_SHARE where one of both is kinematic and goes on: so much deeper is enough, more than rounding, as what lies deep on two that go alike is carried on by them, instead of being stopped by one on the way that the other gives it. */
export const DEEPER_CARRIED = 1e-5;

/** m. Static shapes whose faces differ by no more than this are one surface for what slides over them; less catches on real tiles. */
export const FLUSH_TOLERANCE = 5e-4;

/** How often friction and normals of an impact are solved at most, by turns. */
export const IMPACT_ITERATIONS = 10;

/** m/s. An impact is solved once another turn changes no velocity by more. */
export const IMPACT_TOLERANCE = 1e-9;

/** m. Vertices closer than this are one point. */
export const VERTEX_TOLERANCE = 1e-9;

/** Relative: a vertex whose distance from the line of its neighbours is below this times their distance lies on it. */
export const COLLINEAR_TOLERANCE = 1e-9;

/** m, rad, and either per second. A body whose place, motion or gain in a sub-step is more, or no number, is frozen: beyond, squares are infinite. */
export const FAR = 1e150;

/** m. No shape is larger or farther from the origin of its body: its moment of inertia grows with the fourth power, and would be infinite. */
export const MAX_SIZE = 1e75;

/**
 * How many interactions a shape has before others that it lies in the middle of have to wait, if they have as many. Four thousand boxes at one point then
 * are a quarter of a million pairs instead of eight million, which no memory has room for.
 */
export const CROWD = 64;

/** Default of `World.velocityIterations` and `World.positionIterations`: totals per step, spread over the sub-steps. */
export const DEFAULT_ITERATIONS = 8;

/**
 * How often contacts are swept over for each velocity iteration. With 1 a tower of 25 sways for ever, a pyramid of base 20 settles by 14 mm instead of
 * 9, and what carries 100 times its weight buckles. If those of one point are left out of the further sweeps a pile of mixed shapes trembles at 0.1 m/s.
 */
export const CONTACT_SWEEPS = 1.5;

/**
 * Share of what a step changed of a normal impulse that the next one starts with. All of it is control by integration alone, without damping: a pyramid of base 100
 * then heaves by up to 8 mm a contact for ever, and never sleeps. With 0.95 it still does, with 0.9 it rests after 15 s; with 0.8 a tower of 15 slides 4 cm.
 */
export const IMPULSE_MEMORY = 0.9;

/** m/s. What comes faster strikes, and is stopped for good, see `shocks.ts`. */
export const SHOCK_SPEED = 0.3;

/** Most contacts and joints that are solved together for it: more are a heap, where what presses is not over in a step. */
export const SHOCK_CONTACTS = 32;

/** Most solutions of single contacts and joints for it, about 0.05 ms: fewer may have more sweeps. With 120 for two a body that falls on a fiftieth of its mass comes up by a sixth. */
export const SHOCK_WORK = 2000;

/**
 * Parts of the list of contacts that are hard to solve are swept over this many times as often. With 1 a house of cards slips apart as it is put into
 * the world, and a tower of ten buckles under 100 times its weight; with 3 some such towers still do.
 */
export const HARD_SWEEPS = 4;

/** A part is hard as a whole if more than this share of its contacts is new and slow: what was just put there, not a heap that is falling. */
export const NEW_SHARE = 0.5;

/** Steps for which a contact is new: its impulses are far off at first. */
export const NEW_STEPS = 8;

/** m/s. Both its bodies are slower. */
export const NEW_SPEED = 1;

/**
 * rad/s. Edges that turn faster than this against each other, and slower than the next, rock if they are in a column. A tower that was pushed sways: if few sweeps follow its load from side to
 * side too late, that feeds the sway, and it swings for ever. With 1e-4 some tremble at 0.4 mm/s for ever,
 * with 1e-3 they sway by 1 cm.
 */
export const ROCK_SPIN = 1e-5;

/** rad/s. What turns as fast tumbles: most contacts of a drum do. */
export const TUMBLE_SPIN = 0.1;

/** Share. In a column a contact bears between this and the rest of all that a body's contacts do, half of it in the middle, but a quarter in a pyramid. */
export const COLUMN_PART = 0.42;

/** A part is hard as a whole if more than this share of its contacts that turn rocks. With 0.2 a large pyramid that heaves takes a tenth longer, and a sway dies no sooner. */
export const ROCK_SHARE = 0.5;

/** A part is hard by ROCK_SHARE only if more than this share of all its contacts rocks. Where a few in a pyramid made it hard, sweeps that came and went made that tremble at 0.2 mm/s. */
export const ROCK_LEAST = 0.04;

/**
 * If more than this share of its contacts is strained, these are hard, and what is next to them. With 0.08 a heavy top falls that stands among 100 other boxes;
 * with 0.06 twice as much of a drum of 1,000 boxes is hard. Refused: the whole part, which is most of a heap of ragdolls, and lets that top fall, too; and only
 * bodies with two strained contacts, with which a pyramid of base 100 overlaps by 4.7 mm.
 */
export const STRAIN_SHARE = 0.075;

/** m/s. A contact is strained if its impulse would give its bodies as much in a sub-step: if it carries about a hundred times their weight. With 20 towers of 12 under heavy tops buckle. */
export const STRAIN_SPEED = 8;

/**
 * Share. Between bodies that are alike it must also be more than this of what all contacts of one of them carry: half of it in a column, which buckles, but a quarter
 * in a wide heap, where a load is only the number of rows. With 0.25 half of a pyramid of base 160 is strained, with 0.33 a column under a row of 50 boxes buckles.
 */
export const STRAIN_PART = 0.28;

/** Share of the sum of their inverse masses by which bodies that are alike differ at most. With 0.2 mixed piles overlap deeper: 5.6 mm instead of 5.0 in the mean of 24. */
export const STRAIN_UNLIKE = 0.05;

/** The same for contacts of one point, where one body has to be three times as heavy: a light wedge between heavy discs, which else swings for ever. With 0.05 a barrel of mixed shapes takes an eighth longer for nothing. */
export const STRAIN_UNLIKE_ONE = 0.5;

/** Steps on end for which it does: an impact is over before. With 20 towers buckle. */
export const STRAIN_DELAY = 8;

/** Steps for which a contact then counts as strained; else sweeps that come and go would shake what they hold. */
export const STRAIN_STEPS = 60;

/**
 * In a step whose sub-steps are more than so many times as long as those that impulses are remembered from, see `scaleImpulses` in `prepare.ts`, nothing starts with impulses: what is random in those of short steps does not become smaller with the load, and
 * would be multiplied.
 */
export const MAX_GROWTH = 4;

/** Sub-steps that are shorter than those before are told from slow motion, which ends again, once as much time is over as so many of those before took. */
export const MOST_SPANS = 120;

/** Default of `World.substeps`: the fewest with which tall towers, heavy tops and ramps are all right. */
export const DEFAULT_SUBSTEPS = 4;

/** m/s, rad/s. In a world with constraints faster motion is cut in each sub-step, so that what cannot be solved, such as a stiff spring stretched by miles, stays finite. */
export const MAX_SPEED = 1e6;

/**
 * rad²/s². Where the product of the rates at which two bodies turn is larger, contacts of what is joined, of several shapes, or carried by something that nothing moves turn with them. Below it a box on a platform creeps by 25 µm in a second at most, at 0.5 rad/s it would by 2 mm.
 */
export const TURNS_TOGETHER = 1e-3;

/** rad. What turns farther in a step meets something else before it ends: its contacts are not told how they turn. */
export const MOST_BEND = 0.5;

/** Cosine of the angle by which a face of a floor may differ from a contact that it is to replace. */
export const FACE_LOOKS = -0.2;

/** rad. A gap that is narrower does not open the edges that it is between. */
export const FACE_GAP = 0.2;

/** Of a right angle. Wedges of a floor that leave less between them leave nothing. */
export const FACE_SLIT = 0.3;

/** Times what forces add to a velocity in a step: a bounce adds more. */
export const BOUNCE_SUDDEN = 2;

/** Share of what a bounce adds: more than this is left when it is over. */
export const BOUNCE_LEFT = 0.01;
