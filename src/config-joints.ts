/** Every tolerance of joints, as `config.ts` has those of all else. */

/**
 * m, rad. In a sub-step joints that hang together are swept over once, and once more for each such part of their worst error, but only where
 * errors are above it and near there: what is overloaded gets more work. This is for nets of hundreds, where less would cost half as much again.
 */
export const JOINT_SWEEP_ERROR = 0.002;

/** The same for few joints, as in a ragdoll or a chain; at 0.004 a chain under a 100-fold ball gapes 27 mm. */
export const JOINT_SWEEP_ERROR_OF_FEW = 0.0005;

/** m, rad. Only what exceeds this asks for sweeps. Joints that lie still have errors below it; if these asked, some would never come to rest, nor would a bridge if the number of sweeps jumped here. */
export const JOINT_REST_ERROR = 0.002;

/**
 * Springs that hang together are swept over once, and once more for each such part of a turn by which the hardest of them swings in a sub-step beyond SPRING_TURN: swept over once, two welds of 20 Hz at steps of 1/60 s in one
 * part, or a bough of three of 60 Hz at 1/30 s in four, whirl by themselves.
 */
export const SPRING_SWEEPS = 16;

/** Parts of a turn. Below it, as up to 24 Hz at 1/60 s and four sub-steps, one sweep is enough. */
export const SPRING_TURN = 0.1;

/** A spring may give back so many times what it holds at most, as that is not known to the last digit. */
export const SPRING_GAIN = 1.02;

/** So many times what a spring holds it may owe. With 1 springs of 5 Hz that are hardly damped still draw energy from how bodies turn, in 2 of 360 arms; more than 4 does not help. */
export const SPRING_DEBT = 4;

/** rad/s. For each such part by which a motor misses its rate all that hangs together is swept over once more: in one sweep light wheels hand heavy ones so little that both swing for ever. */
export const MOTOR_LAG = 0.02;

/** Of so many joints that hang together, or fewer, the error counts for which few are swept over once more; of more it is larger in proportion, up to that of nets. */
export const FEW_JOINTS = 64;

/**
 * So many joints that hang together are solved to their end where they leave little to move: FIRM_ROWS rows or more for each body with its three, as in scissors and trains of gears, where the errors of all joints add up at
 * the end. FIRM_FEW joints and fewer are while they touch nothing. It takes up to ten times as long as sweeps do.
 */
export const FIRM_JOINTS = 32;

/** So few joints that touch nothing are solved to their end whatever they leave to move. */
export const FIRM_FEW = 4;

/** m. Of two rigid points between the same bodies one keeps their angle only, if they lie so far apart, and on one as far as on the other but for so much: what is less cannot be seen. */
export const PINS_APART = 1e-3;
export const PINS_UNLIKE = 1e-4;

/** Rows for each body, of three that would hold it: what has so many leaves little to move. */
export const FIRM_ROWS = 2.5;

/** So many bodies of a mechanism may touch something, at most two are counted: more do in heaps, where welded frames would take ten times as long, and come to rest later. */
export const FIRM_FEET = 2;

/** What is solved to its end is swept over so often at most. */
export const FIRM_SWEEPS = 32;

/** Share of the energy. It is solved when a sweep changes less: below it rounding decides. */
export const JOINT_STILL = 1e-12;

/** A direction that has so little of the energy of the change it was made of has lost it to rounding. */
export const GRADIENT_LOST = 1e-10;

/** Nor is one followed along which rows work against each other, so that less than this share is left of what they would change one by one: where there are a few more joints than are needed, such a direction has no end. */
export const GRADIENT_SHARE = 3e-5;

/** m, rad. Only while errors are smaller: linear solutions of larger ones, solved to their end, make energy of large turns. */
export const FIRM_ERROR = 0.01;

/** Steps without a contact before it, of the few: a bridge that is firm while a crate is in the air, and not when it lands, would fling it up for ever. */
export const FIRM_STEPS = 60;

/** The most sweeps in a sub-step that errors ask for. What is new, or solved to its end, has NEW_JOINT_SWEEPS or FIRM_SWEEPS. */
export const MAX_JOINT_SWEEPS = 16;

/** The fewest where what hangs together touches something. With one, or two, a hinged bridge flings boxes that lie on it up for ever. */
export const TOUCHED_SWEEPS = 4;

/**
 * There the part of the worst error that asks for a sweep more is so many times as large: much of the error is what contacts ask for, and comes again. With 1 ragdolls
 * in a heap are swept over 12 times instead of 7, and gape no less.
 */
export const TOUCHED_PATIENCE = 2;

/** Steps. There sweeps become one less only so often: one less in each sub-step gives what falls on a tight bridge half as much of its energy back again. */
export const EASE_STEPS = 16;

/** Joints that hang together start with so many, and one less in each sub-step, if most of them carried nothing yet: a net of 40 × 40 gapes 7 mm instead of 13. */
export const NEW_JOINT_SWEEPS = 32;

/**
 * Joints are swept over to and fro where one body does more of what all its joints ask for, in some direction, than so many bodies would do all of one each. Equal discs of a net do 2; where
 * it is 2.7, be it of three spokes or of twelve, a wheel at rest gets turning by itself.
 */
export const HUB_SHARE = 2.5;

/** Steps. So often it is looked at which groups have something heavy, are mechanisms, and may make energy, and which large nets have hubs. */
export const WEIGH_STEPS = 8;

/** Cosine of the angle by which a row may turn in a sub-step for its corrections to make momentum as if it had not. */
export const ROW_TURN = 0.9;

/** Of more sweeps than one, so many of positions for each of velocities. With 3, errors outside of the part that is swept over may grow for ever. */
export const JOINT_PUSHES = 2;

/** On either side of the joints with errors above the part that asks for a sweep this many times their range takes part. With 0 the error stays there; with 2 it may be pushed to and fro over the border. */
export const JOINT_SWEEP_MARGIN = 5;

/** m. If a position sweep found a larger error than this, the sweeps after it take exact errors and arms of what turned since: a whirling chain would tear, as what is linear in the turn then is not enough. */
export const JOINT_FAR = 0.016;

/** rad. What turned by more. With 0.005 a chain that whirls at 300 m/s gains energy; with 0 a net of 100 × 100 takes a fifth longer. */
export const JOINT_FAR_TURN = 0.001;

/**
 * Share of a joint's position correction that becomes momentum. 0 makes pendulums lose half their height in a minute, 1 is
 * neutral; a little less than that never gains. Where what hangs together touches something it is 0, or less, see TOUCHED_MOMENTUM.
 */
export const JOINT_MOMENTUM = 0.999;

/**
 * Share of JOINT_MOMENTUM that welds and angles of one value make where what hangs together touches something, and what bears much, see STRAIN_SPEED, and ropes. With 0 beams that lie on two piers gain energy
 * until they hop, as corrections lift for nothing what the velocities let sag, and heavy balls sink through the planks of a hinged bridge, which are lifted through
 * them; with 0.6 long beams tremble; with 1 more of them never fall asleep, and what is hit breaks as a whole.
 */
export const TOUCHED_MOMENTUM = 0.8;

/**
 * So many joints that hang together and bear something heavy are a rope, whose joints make that share, too, unless they lie on what is as light: sweeps do not hand a load on from end to end of it, and what a rope over an edge
 * or a peg lets sag would be lost without momentum, until it tears, from some 200 times the mass of its links on. With fewer joints heaps of hammers would tremble, and heaps of flails if they were ropes among each other.
 */
export const ROPE_JOINTS = 5;

/**
 * m, rad. Few joints that hold an angle and stand on something are solved with their contacts to their end, and make no momentum of corrections, as long as one is open by more. Else what the load lets sag in the velocities corrections lift
 * with momentum, for ever: the legs of a table under ten times its weight are told to move at 1 m/s, which friction takes for true. With 2e-4 they never sleep.
 */
export const FRAME_BENT = 1e-5;

/** So many joints at most: half of SHOCK_CONTACTS, as there have to be as few contacts. */
export const FRAME_JOINTS = 16;

/**
 * m. If no error of what hangs together and touches something is larger, joints with a body that touches nothing make all of their momentum: a pendulum on a tower that stands on the ground then keeps its height, and most hinged bridges with crates come to rest in 30 to 90 s
 * instead of 130 s or never. With 3e-4 a tight one does as well, but of twelve heaps of chains three never sleep instead of two.
 */
export const TOUCHED_QUIET = 2e-4;

/** m. The same of what touches nothing but itself and does not overlap, all of it: with a larger error it is contacts that hold it open, or it was joined while it was apart. */
export const ALONE_ERROR = 0.005;

/**
 * Share of the kinetic energy of what hangs together that joints may make; what is more is taken back. Chains that crack make and lose a hundredth by turns. Without it tight bridges, and planks lighter to turn than they look, whirl for ever.
 */
export const EXCESS_SHARE = 0.1;

/** The same of joints that may break, which are swept over less: what is more than that is taken from heavy bodies, too, as they were flung. */
export const EXCESS_WILD = 0.25;

/** The same as the first in one step, of what touches something together with all that lies on it, and without regard to what was lost before: loads on hinged bridges, and who sits on a swing, bounce for ever without it. */
export const TOUCHED_EXCESS = 0.03;

/** By how much more a joint turns a body than it moves it, as energies, where joints are looked at for that: 3 at the end of a rod or the corner of a box whose inertia is that of its mass. */
export const EASY_TURN = 4;

/** So much of the kinetic energy is taken back in one step at most, and what was made in that step: all at once would halt things in the air. */
export const EXCESS_REMOVED = 0.1;

/** What joints lose is kept in mind by so much from step to step, over several swings: under a heavy load they take energy up and give it back with each. With 0.95 a ball on a chain was stopped within 9 s. */
export const EXCESS_FADES = 0.998;

/**
 * s⁻¹. Times the length of the sub-step, the share of the momentum of corrections that is not made where joints are swept over once: 3 % at steps of 1/60 s. With all of it pendulums of four to six rods without
 * drag gain a quarter of their energy in a minute, with 1 % less some still do; with 10 % less they lose half of it.
 */
export const SWEPT_ONCE = 7;

/** A body of so many times the mass of another is heavy for it. Parts of ragdolls, up to 7 apart, are not for each other: their heaps would tremble. */
export const HEAVY = 16;

/** m/s, rad/s. Errors that would be gone in a sub-step at such a speed are too small to matter when the next step is shorter than the last. */
export const JOINT_CALM = 0.01;

/** steps. A joint that bears more than its breaking force with all its momentum for this long breaks. Fewer break chains as they are built. */
export const BREAK_STEPS = 10;

/** The same of at most FIRM_FEW that hang together, of one that at the end bears about as much as in the step before, such as what swings. Longer chains stretch for so long as they are built. */
export const BREAK_STEPS_STEADY = 3;

/** Share by which that may differ. With 0.1 four welds that hold a beam at one end break as they are built at a tenth more than it weighs. */
export const STEADY_CHANGE = 0.05;

/** m, rad. If no joint's error was larger, the sub-step needs no further position iteration. */
export const JOINT_TOLERANCE = 1e-4;

/**
 * m, rad. After a change of a constraint, or a teleport, a larger error is corrected by moving the bodies without turning them. In later steps
 * it is not: of joints that pull against each other either all make momentum of their corrections, which cancel, or none.
 */
export const JOINT_SNAP = 0.05;

/**
 * Steps for which joints that hang together make no momentum of their corrections after one of them was changed, while an error is larger than
 * JOINT_SNAP: a chain that is built at twice its length would be flung about for ever. Not longer, as what cannot be met has to move on.
 */
export const SETTLE_STEPS = 60;

/** m, rad. What errors have to be below for that to be over: of what is left of them momentum is made again, in one sub-step. */
export const JOINT_SETTLED = 1e-3;

/** Of these so many, the first ones, move the bodies without turning them. */
export const SNAP_STEPS = 4;

/**
 * m, rad. Joints that contacts hold open by more are corrected once more, after the contacts: else one in a hundred in a heap of ragdolls would stay torn by
 * up to 0.3 m. With 0.005 that is done where contacts and joints only disagree for a moment.
 */
export const JOINT_OPEN = 0.01;

/** Sweeps over these, as what closes one may open another. */
export const CLOSING_ROUNDS = 4;

/** The cosine of an angle. What is closed into a wall less steeply goes along it, see `goesIntoWalls`. */
export const INTO_WALL = 0.5;

/**
 * m, rad. Of joints that hang together and touch something, or hold it between things that do not move, one with a larger error cannot be met, and what they give would grow without end. With 0.01 some in
 * heaps of ragdolls are taken for such. It is also how much of such an error is corrected in a sub-step: contacts take three quarters of that back, so that a third of it is how deep it gets.
 */
export const JOINT_TORN = 0.05;

/** What these keep of their impulses in a sub-step. With 1 a chain that slips off a wall is flung away at 150 m/s. */
export const TORN_KEEP = 0.9;

/** m, rad. So far within a bound what pressed against it is held, not let go up to it: else it would pass it to and fro for ever, and so would heaps of ragdolls. */
export const BOUND_SLOP = 3e-4;

/** Joints: a matrix whose determinant is below this share of the product of its diagonal has rank 1. */
export const SINGULAR = 1e-12;

/**
 * rad⁻¹. How much of what joints that pull against each other give fades as they turn, 1 at most. With 0 nets and wheels that turn fast lose a tenth more of their energy in half a minute; where all welds fade, beams on piers and welded houses come to rest later, or not at all.
 */
export const STRESS_FADES = 0.5;

/** rad. What turns by less in a sub-step takes what they give as it is. */
export const STRESS_STILL = 1e-4;

/** rad/s. So does what turns slower than this among more than FEW_JOINTS, as nets that hang: they would take a third longer. Nets that turn at 1 rad/s lose nothing by it, at 3 rad/s half of their energy in 10 s. */
export const STRESS_SLOW = 1;

/**
 * What turns faster than this share of the rate at which a soft joint swings makes it give more as it did with arms to its own anchors. Without it a wheel on a soft weld in the middle of a rotor is
 * metres away within 15 s, once that turns faster than the joint swings; from 1 on a ball on a soft joint there is.
 */
export const WHIRL = 0.7;

/** Steps on end in which joints, which hold what hangs on them to what does not move at two places or more, are open by STUCK_ERROR: then they cannot all be met. Ropes between two posts are for a while, too. */
export const STUCK_STEPS = 16;

/** m, rad. Joints that are open by more count towards STUCK_STEPS. */
export const STUCK_ERROR = 3e-4;

/** The share of its kinetic energy by which what cannot be met moves otherwise than it is told to, from which on it is told how it moves: 0.15 slows ropes between two posts that swing. */
export const STUCK_APART = 0.25;

/**
 * If what touches something moved for so many steps on end with less than UNTRUE_SHARE of the energy of its velocities, they are replaced by what it moved by. A tank that was parked had 1.3 m/s for ever, and never slept; a belt that stood
 * had 6 m/s.
 */
export const UNTRUE_STEPS = 16;

/** Of that tank and that belt it was 0.0003. */
export const UNTRUE_SHARE = 0.01;

/** m, rad. Only where joints are open by more than this: what bounces to and fro in a slot within a step moves as little, and is as fast as it is told. */
export const UNTRUE_ERROR = 1e-4;

/** The share of that energy that the motion may have where something is touched: with 1 beams that a ball strikes gain 0.36 times what it brings, not 0.21. */
export const STUCK_STANDS = 0.25;

/** Share of the way from hinge to origin by which a hinge may gape: on its way through a step a body goes straight on. */
export const HINGE_GAPE = 0.1;

/** Bodies. Where more are together it is not looked at what joints make of energy: in a heap it would be the whole heap, for each of those in it. */
export const MOST_GUESTS = 100;
