/**
 * Every tolerance of joints, as `config.ts` has those of everything else. Joints that hang together are a group; an error is how far a
 * joint is from closed.
 */

/**
 * m, rad. In a sub-step a group is swept over once, and once more for each such part of its worst error, but these further sweeps cover
 * only joints with errors above it and those near them: so what is overloaded gets more work. This value is for nets of hundreds of joints,
 * where a smaller one would cost half as much again.
 */
export const JOINT_SWEEP_ERROR = 0.002;

/**
 * m, rad. JOINT_SWEEP_ERROR for few joints, as in a ragdoll or a chain; at 0.004 a chain under a ball of 100 times its mass gapes 27 mm.
 */
export const JOINT_SWEEP_ERROR_OF_FEW = 0.0005;

/**
 * m, rad. Only the part of an error beyond this asks for sweeps. Joints that lie still have smaller errors: if these asked for sweeps, some
 * joints would never come to rest, nor would a bridge if the number of sweeps jumped here.
 */
export const JOINT_REST_ERROR = 0.002;

/**
 * Springs that hang together are swept over once, and once more for each such part of a full turn by which the hardest of them swings in a
 * sub-step beyond SPRING_TURN, so 1/16 of a turn. Swept over once, two welds of 20 Hz at steps of 1/60 s in one part, or a bough of three
 * of 60 Hz at 1/30 s in four, whirl by themselves.
 */
export const SPRING_SWEEPS = 16;

/** Full turns. If the hardest spring swings by less in a sub-step, as up to 24 Hz at 1/60 s and four sub-steps, one sweep is enough. */
export const SPRING_TURN = 0.1;

/** A spring may give back at most so many times the energy that it holds, as that is not known to the last digit. */
export const SPRING_GAIN = 1.02;

/**
 * A spring may owe at most so many times the energy that it holds. With 1, springs of 5 Hz that are hardly damped still draw energy from
 * how bodies turn, in 2 of 360 arms; more than 4 does not help.
 */
export const SPRING_DEBT = 4;

/**
 * rad/s. For each such part by which a motor misses its rate, all that hangs together is swept over once more: in one sweep light wheels
 * hand so little on to heavy ones that both swing for ever.
 */
export const MOTOR_LAG = 0.02;

/**
 * Joints. A group of so many or fewer has JOINT_SWEEP_ERROR_OF_FEW; for more joints that grows in proportion, up to JOINT_SWEEP_ERROR, that
 * of nets.
 */
export const FEW_JOINTS = 64;

/**
 * Joints. A group of so many or fewer is firm, that is solved to its end, if it leaves little to move: FIRM_ROWS rows or more for each body
 * with its three degrees of freedom, as in scissors and trains of gears, where the errors of all joints add up at the end. FIRM_FEW joints
 * and fewer are firm while they touch nothing. It takes up to ten times as long as sweeps do.
 */
export const FIRM_JOINTS = 32;

/** Joints. So few are firm while they touch nothing, whatever they leave to move. */
export const FIRM_FEW = 4;

/**
 * m. Of two rigid points between the same two bodies one keeps only their angle, if the points are at least so far apart on each body, …
 */
export const PINS_APART = 1e-3;
/** m. … and these distances differ by no more than this, which cannot be seen. */
export const PINS_UNLIKE = 1e-4;

/** Rows for each body, of the three that would hold it. A group with as many leaves little to move. */
export const FIRM_ROWS = 2.5;

/**
 * At most so many bodies of a firm mechanism may touch something. In heaps more do: there welded frames would take ten times as long, and
 * come to rest later.
 */
export const FIRM_FEET = 2;

/** At most so many sweeps of what is solved to its end. */
export const FIRM_SWEEPS = 32;

/** A share of the energy. A firm group is solved when a sweep changes less: below it rounding decides. */
export const JOINT_STILL = 1e-12;

/**
 * A direction of the conjugate gradients that has no more than this share of the energy of the change it was made from has lost the rest to
 * rounding. It is not followed.
 */
export const GRADIENT_LOST = 1e-10;

/**
 * Nor is a direction followed along which rows work against each other, so that less than this share is left of what they would change one
 * by one: where there are a few more joints than are needed, such a direction has no end.
 */
export const GRADIENT_SHARE = 3e-5;

/**
 * m, rad. A group is firm only while its errors are smaller: linear solutions of larger ones, solved to their end, make energy of large
 * turns.
 */
export const FIRM_ERROR = 0.01;

/**
 * Steps. FIRM_FEW joints must have touched nothing for so long to be firm: a bridge that is firm while a crate is in the air, and not when
 * it lands, would fling it up for ever.
 */
export const FIRM_STEPS = 60;

/** The most sweeps in a sub-step that errors ask for. What is new may have NEW_JOINT_SWEEPS, and what is firm FIRM_SWEEPS. */
export const MAX_JOINT_SWEEPS = 16;

/** The fewest sweeps where a group touches something. With one or two, a hinged bridge flings boxes that lie on it up for ever. */
export const TOUCHED_SWEEPS = 4;

/**
 * Factor on the part of the worst error that asks for one more sweep, where a group touches something: much of the error is what contacts
 * ask for, and comes again. With 1, ragdolls in a heap are swept over 12 times instead of 7, and gape no less.
 */
export const TOUCHED_PATIENCE = 2;

/**
 * Steps. Where a group touches something, sweeps become one fewer only once in so many: one fewer in each sub-step gives what falls on a
 * tight bridge half as much of its energy back again.
 */
export const EASE_STEPS = 16;

/**
 * A group starts with so many sweeps, and one fewer in each sub-step, if most of its joints carried nothing yet: a net of 40 × 40 gapes 7
 * mm instead of 13.
 */
export const NEW_JOINT_SWEEPS = 32;

/**
 * Bodies. A group is swept over to and fro if one body is a hub: if in some direction it does more of what all its joints ask for than so
 * many bodies would that do all of one joint each. Equal discs of a net do 2; where it is 2.7, be it of three spokes or of twelve, a wheel
 * at rest gets turning by itself.
 */
export const HUB_SHARE = 2.5;

/**
 * Steps. Once in so many it is found anew which groups have something heavy, are mechanisms, or may make energy, and which large nets have
 * hubs.
 */
export const WEIGH_STEPS = 8;

/** The cosine of an angle. A row may turn by so much in a sub-step for its corrections to make momentum as if it had not turned. */
export const ROW_TURN = 0.9;

/**
 * Position sweeps for each velocity sweep, where there is more than one. With 3, errors outside of the part that is swept over may grow for
 * ever.
 */
export const JOINT_PUSHES = 2;

/**
 * Further sweeps cover the range of joints with errors above the part that asks for a sweep, and on either side this many times its length.
 * With 0 the error stays there; with 2 it may be pushed to and fro over the border.
 */
export const JOINT_SWEEP_MARGIN = 5;

/**
 * m. If a position sweep found a larger error, the sweeps after it take exact errors and arms of what has turned since: a whirling chain
 * would tear, as errors linear in the turn are not enough there.
 */
export const JOINT_FAR = 0.016;

/**
 * rad. What turned by more has turned, in that sense. With 0.005 a chain that whirls at 300 m/s gains energy; with 0 a net of 100 × 100
 * takes a fifth longer.
 */
export const JOINT_FAR_TURN = 0.001;

/**
 * m, rad. Only if a joint other than points has a larger error as a position iteration starts, it is looked for what turns far, see
 * BLOCK_FAR_TURN. With 0.002 half as many more loads that gently pull light links straight make energy; with 0 hardly fewer.
 */
export const BLOCK_FAR = 0.0005;

/**
 * rad. If a body has been turned by more since the errors of its joints other than points were taken as linear in the turn, that is done
 * anew before the next sweep. Else a rope that is jerked tight by a load turns the light link that it is fixed to round and round, as one
 * that is nearly straight seems to get longer by turning on.
 */
export const BLOCK_FAR_TURN = 0.02;

/**
 * Share of a joint's position correction that becomes momentum. 0 makes pendulums lose half their height in a minute, 1 is neutral; a
 * little less never gains. Where a group touches something it is 0, or this times TOUCHED_MOMENTUM.
 */
export const JOINT_MOMENTUM = 0.999;

/**
 * Factor on JOINT_MOMENTUM where a group touches something: for welds and angles of one value, for what bears much, see STRAIN_SPEED, and
 * for ropes. With 0, beams that lie on two piers gain energy until they hop, as corrections lift for nothing what the velocities let sag,
 * and heavy balls sink through the planks of a hinged bridge, which are lifted through them; with 0.6 long beams tremble; with 1 more of
 * them never fall asleep, and what is hit breaks as a whole.
 */
export const TOUCHED_MOMENTUM = 0.8;

/**
 * Joints. A group of so many or more that bears something heavy is a rope: its joints make TOUCHED_MOMENTUM, too, unless they lie on what
 * is as light. Sweeps do not pass a load on from end to end of it. Without momentum, what a rope over an edge or a peg lets sag would be
 * lost until it tears, from some 200 times the mass of its links on. With fewer joints heaps of hammers would tremble, and heaps of flails
 * if they were ropes among each other.
 */
export const ROPE_JOINTS = 5;

/**
 * m, rad. As long as one of few joints that hold an angle, and stand on something, is open by more, all are solved with their contacts to
 * the end, and make no momentum of corrections. Else corrections lift with momentum, for ever, what the load lets sag in the velocities:
 * the legs of a table under ten times its weight are given velocities of 1 m/s, which friction takes for true. With 2e-4 they never sleep.
 */
export const FRAME_BENT = 1e-5;

/** Joints. At most so many are a frame of that kind: half of SHOCK_CONTACTS, as there have to be as few contacts. */
export const FRAME_JOINTS = 16;

/**
 * m. If no error of a group that touches something is larger, joints with a body that touches nothing make all of their momentum: a
 * pendulum on a tower that stands on the ground then keeps its height, and most hinged bridges with crates come to rest in 30 to 90 s
 * instead of 130 s or never. With 3e-4 a tight one does as well, but of twelve heaps of chains three never sleep instead of two.
 */
export const TOUCHED_QUIET = 2e-4;

/**
 * m. If a group touches nothing but itself, does not overlap, and no error is larger, all its joints make all of their momentum. With a
 * larger error it is contacts that hold it open, or it was joined while it was apart.
 */
export const ALONE_ERROR = 0.005;

/**
 * Share of the kinetic energy of a group that its joints may make; what is more is taken back. Chains that crack make and lose a hundredth
 * by turns. Without it tight bridges, and planks lighter to turn than they look, whirl for ever.
 */
export const EXCESS_SHARE = 0.1;

/**
 * EXCESS_SHARE of what is taken from heavy bodies, too, as they were flung. With 0.1 heavy balls on thin chains lose half as much again:
 * where a swing turns round there is little energy that this could be a share of.
 */
export const EXCESS_WILD = 0.25;

/**
 * EXCESS_SHARE in one step, for a group that touches something together with all that lies on it, and without regard to what was lost
 * before: loads on hinged bridges, and who sits on a swing, bounce for ever without it.
 */
export const TOUCHED_EXCESS = 0.03;

/**
 * A ratio of energies: what a joint does by turning a body, to what it does by moving it. Where it is larger, joints are checked for the
 * energy that they make. It is 3 at the end of a rod, or at the corner of a box whose inertia is that of its mass.
 */
export const EASY_TURN = 4;

/**
 * Share of the kinetic energy of the light bodies that is taken back in one step at most, besides what was made in that step: all at once
 * would halt things in the air.
 */
export const EXCESS_REMOVED = 0.1;

/**
 * Share of what the joints of a group lost that is kept in mind from step to step, over several swings: under a heavy load they take energy
 * up and give it back with each. With 0.95 a ball on a chain was stopped within 9 s.
 */
export const EXCESS_FADES = 0.998;

/**
 * s⁻¹. Times the length of the sub-step, the share of the momentum of corrections that is not made where a group is swept over once: 3 % at
 * steps of 1/60 s. With all of it, pendulums of four to six rods without drag gain a quarter of their energy in a minute, with 1 % less
 * some still do; with 10 % less they lose half of it.
 */
export const SWEPT_ONCE = 7;

/**
 * A ratio of masses. A body of at least so many times the mass of another is heavy for it. Parts of ragdolls, up to 7 apart, are not for
 * each other: their heaps would tremble.
 */
export const HEAVY = 16;

/**
 * m/s, rad/s. Errors that would be gone in a sub-step at such a speed are too small to matter when the next step is shorter than the last.
 */
export const JOINT_CALM = 0.01;

/**
 * Steps. A joint breaks when it bears more than its breaking force, with all of its momentum, for so many on end. Fewer break chains as
 * they are built.
 */
export const BREAK_STEPS = 10;

/**
 * Steps. BREAK_STEPS for a joint in a group of at most FIRM_FEW that at the end bears about as much as in the step before, such as what
 * swings. Longer chains stretch for that long as they are built.
 */
export const BREAK_STEPS_STEADY = 3;

/**
 * Share by which that may differ. With 0.1 four welds that hold a beam at one end break as they are built, at a tenth more than it weighs.
 */
export const STEADY_CHANGE = 0.05;

/** m, rad. If no joint's error was larger, the sub-step needs no further position iteration. */
export const JOINT_TOLERANCE = 1e-4;

/**
 * m, rad. After a change of a constraint, or a teleport, a larger error is corrected by moving the bodies without turning them. In later
 * steps it is not: of joints that pull against each other either all make momentum of their corrections, which cancel, or none.
 */
export const JOINT_SNAP = 0.05;

/**
 * Steps. For so long after one of its joints was changed a group makes no momentum of its corrections, while an error is larger than
 * JOINT_SNAP: a chain that is built at twice its length would be flung about for ever. Not longer, as what cannot be met has to move on.
 */
export const SETTLE_STEPS = 60;

/** m, rad. Errors have to be below this for that to be over: of what is left of them momentum is made again, in one sub-step. */
export const JOINT_SETTLED = 1e-3;

/** Steps. In the first so many of SETTLE_STEPS bodies are moved without turning them. */
export const SNAP_STEPS = 4;

/**
 * m, rad. Joints that contacts hold open by more are corrected once more, after the contacts: else one in a hundred in a heap of ragdolls
 * would stay torn by up to 0.3 m. With 0.005 that is done where contacts and joints only disagree for a moment.
 */
export const JOINT_OPEN = 0.01;

/** At most so many sweeps over these joints, as what closes one may open another. */
export const CLOSING_ROUNDS = 4;

/** The cosine of an angle. A body that closing a joint moves into a wall less steeply than this goes along it, see `goesIntoWalls`. */
export const INTO_WALL = 0.5;

/**
 * m, rad. In a group that touches something, or holds it between things that do not move, a joint with a larger error cannot be met, and
 * its impulses would grow without end. With 0.01 some in heaps of ragdolls are taken for such. It is also how much of such an error is
 * corrected in a sub-step: contacts take three quarters of that back, so that a third of it is how deep it gets.
 */
export const JOINT_TORN = 0.05;

/** Share of their impulses that such joints keep in a sub-step. With 1 a chain that slips off a wall is flung away at 150 m/s. */
export const TORN_KEEP = 0.9;

/**
 * m, rad. A joint that pressed against a bound, and is no farther within it than this, is held where it is, not let go up to the bound:
 * else two joints would pass it to and fro for ever, and so would heaps of ragdolls.
 */
export const BOUND_SLOP = 3e-4;

/** The matrix of a joint has rank 1 if its determinant is below this share of the product of its diagonal. */
export const SINGULAR = 1e-12;

/**
 * rad⁻¹. Joints that pull against each other lose this share of their impulses for each radian by which they turn, 1 rad at most. With 0
 * nets and wheels that turn fast lose a tenth more of their energy in half a minute; where all welds fade, beams on piers and welded houses
 * come to rest later, or not at all.
 */
export const STRESS_FADES = 0.5;

/** rad. If no body of a group turns by more in a sub-step, its joints take their impulses as they are. */
export const STRESS_STILL = 1e-4;

/**
 * rad/s. STRESS_STILL as a rate, for groups of more than FEW_JOINTS, such as nets that hang: they would take a third longer. Nets that turn
 * at 1 rad/s lose nothing by it, at 3 rad/s half of their energy in 10 s.
 */
export const STRESS_SLOW = 1;

/**
 * A share of the angular frequency of a soft joint. Where its bodies turn faster than that, its arms are moved by less to the one place at
 * which both bodies get its impulse, see `moveToOnePlace` in `pose.ts`. Without it a wheel on a soft weld in the middle of a rotor is
 * metres away within 15 s, once that turns faster than the joint swings; from 1 on a ball on a soft joint is.
 */
export const WHIRL = 0.7;

/**
 * Steps. If joints that hold what hangs on them to what does not move, at two places or more, are open by STUCK_ERROR for so many on end,
 * they cannot all be met. Ropes between two posts are open as far for a while, too.
 */
export const STUCK_STEPS = 16;

/** m, rad. Joints that are open by more count towards STUCK_STEPS. */
export const STUCK_ERROR = 3e-4;

/**
 * A share of kinetic energy. If what cannot be met moves otherwise than its velocities say, and the difference has more than this share of
 * their energy, its velocities are replaced by its motion. 0.15 slows ropes between two posts that swing.
 */
export const STUCK_APART = 0.25;

/**
 * Steps. If what touches something moved for so many on end with less than UNTRUE_SHARE of the energy of its velocities, these are replaced
 * by its motion. A tank that was parked had 1.3 m/s for ever, and never slept; a belt that stood had 6 m/s.
 */
export const UNTRUE_STEPS = 16;

/**
 * Steps. UNTRUE_STEPS where something that goes on draws a group into what is in its way, and motion with less than
 * STUCK_STANDS of that energy. With 1 what bounces off that would stop.
 */
export const JAMMED_STEPS = 2;

/** A share of kinetic energy, see UNTRUE_STEPS. It was 0.0003 for that tank and that belt. */
export const UNTRUE_SHARE = 0.01;

/**
 * m, rad. UNTRUE_STEPS counts only where joints are open by more: what bounces to and fro in a slot within a step moves as little, and is
 * as fast as its velocity says.
 */
export const UNTRUE_ERROR = 1e-4;

/**
 * A share of the energy of the velocities: where something is touched, STUCK_APART applies only if the motion has less. With 1 beams that a
 * ball strikes gain 0.36 times what it brings, not 0.21.
 */
export const STUCK_STANDS = 0.25;

/**
 * A share of the distance from hinge to origin. A hinge may gape by so much and still count as one: on its way through a step a body goes
 * straight on.
 */
export const HINGE_GAPE = 0.1;

/**
 * Bodies. If more are together with a group, it is not checked what its joints make of energy: in a heap that would be the whole heap, for
 * each group in it.
 */
export const MOST_GUESTS = 100;
