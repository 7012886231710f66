import type { RigidBody } from '../body.js';
import { DYNAMIC, KINEMATIC } from '../body-kind.js';
import { visibleTurn } from '../collide/along.js';
import { impactDepth } from '../collide/gap.js';
import { CLEARANCE, DEEPER_SHARE, JOINT_PATIENCE, SWEEP_TOLERANCE, TOUCH_DEPTH } from '../config.js';
import type { Arbiter } from '../contact/arbiter.js';
import { Sweep, timeOfImpact } from '../geometry/sweep.js';
import type { Shape } from '../shape/shape.js';
import type { World } from '../world.js';
import { mayInteract } from './find-pairs.js';
import type { Meeting } from './meeting-queue.js';
import type { Mover, Movers } from './movers.js';
import { shapesWithin } from './nearby.js';

const sweep = new Sweep();
sweep.patience = 1000;
sweep.cautious = true;
const bounds = new Float64Array(4);
const around = new Float64Array(4);

export function isSensed(a: Shape, b: Shape): boolean {
  return a.sensor || b.sensor;
}

/** Everything that meets if nothing else does, and would get as deep into each other as `depth`, or less if it is thin. */
export function findMeetings(world: World, depth: number): void {
  const { movers } = world;
  movers.meetings.clear();
  const sweeping = movers.count;
  for (const body of world.liveKinematics) {
    movers.of(body);
  }
  const count = movers.count;
  let alone = count === sweeping;
  for (let i = 0; i < sweeping; i += 1) {
    alone &&= !meetsMovers(movers.all[i]!);
  }
  for (let i = 0; i < sweeping; i += 1) {
    const mover = movers.all[i]!;
    if (alone && movers.ahead > 0 && isClear(world, mover)) {
      continue;
    }
    for (const shape of mover.body.shapes) {
      setShapeBounds(mover, shape);
      for (const other of shapesWithin(world, bounds, meetsMovers(mover) || shape.sensor)) {
        if (other.owner!.mover < 0 || other.owner!.mover >= count) {
          note(world, shape, other, depth);
        }
      }
    }
  }
  pairMovers(world, sweeping, count, depth);
}

/**
 * Nothing that a body might be swept against is near it, wherever it goes in this step with little more than the speed foreseen: then it need not be
 * looked at, now or at the end of the step.
 */
function isClear(world: World, { body, dx, dy, spin }: Mover): boolean {
  const reach = Math.abs(dx) + Math.abs(dy) + spin * body.radius + CLEARANCE;
  for (const shape of body.shapes) {
    const { bounds: start } = shape;
    bounds[0] = start[0]! - reach;
    bounds[1] = start[1]! - reach;
    bounds[2] = start[2]! + reach;
    bounds[3] = start[3]! + reach;
    if (shape.sensor || shapesWithin(world, bounds, false).length > 0) {
      return false;
    }
  }
  body.clearance = reach;
  return true;
}

/** Kinematic bodies and fast bullets with everything that sweeps, and what sweeps with every kinematic body. */
function pairMovers(world: World, sweeping: number, count: number, depth: number): void {
  const { movers } = world;
  let bounded = false;
  for (let i = 0; i < count; i += 1) {
    const mover = movers.all[i]!;
    if (!meetsMovers(mover)) {
      continue;
    }
    for (let j = 0; j < count && !bounded; j += 1) {
      setBounds(movers.all[j]!);
    }
    bounded = true;
    for (let j = 0; j < count; j += 1) {
      const other = movers.all[j]!;
      const once = j > i || !meetsMovers(other);
      if (once && j !== i && (i < sweeping || j < sweeping) && overlap(mover.bounds, other.bounds)) {
        pairUp(world, mover, other, depth);
      }
    }
  }
}

/** Bounds of all places that a shape can have on the way of its body. */
function setShapeBounds({ body, dx, dy, turn }: Mover, { bounds: start }: Shape): void {
  const swing = Math.abs(turn) * body.radius;
  bounds[0] = start[0]! + Math.min(dx, 0) - swing;
  bounds[1] = start[1]! + Math.min(dy, 0) - swing;
  bounds[2] = start[2]! + Math.max(dx, 0) + swing;
  bounds[3] = start[3]! + Math.max(dy, 0) + swing;
}

function setBounds(mover: Mover): void {
  const all = mover.bounds;
  all.set([Infinity, Infinity, -Infinity, -Infinity]);
  for (const shape of mover.body.shapes) {
    setShapeBounds(mover, shape);
    all[0] = Math.min(all[0]!, bounds[0]!);
    all[1] = Math.min(all[1]!, bounds[1]!);
    all[2] = Math.max(all[2]!, bounds[2]!);
    all[3] = Math.max(all[3]!, bounds[3]!);
  }
}

function overlap(a: Float64Array, b: Float64Array): boolean {
  return a[0]! <= b[2]! && a[2]! >= b[0]! && a[1]! <= b[3]! && a[3]! >= b[1]!;
}

/** Is swept against dynamic bodies: a bullet that is fast, or kinematic. */
function meetsMovers({ body, sweeps }: Mover): boolean {
  return (body.bullet && sweeps) || body.kind !== DYNAMIC;
}

function isSwept(one: Mover, two: Mover): boolean {
  return meetsMovers(one) || meetsMovers(two);
}

function pairUp(world: World, one: Mover, two: Mover, depth: number): void {
  for (const a of one.body.shapes) {
    setShapeBounds(one, a);
    if (overlap(bounds, two.bounds)) {
      around.set(bounds);
      for (const b of two.body.shapes) {
        setShapeBounds(two, b);
        if (overlap(around, bounds)) {
          note(world, a, b, depth);
        }
      }
    }
  }
}

/** Notes two shapes that may interact, do not yet in this step, and meet. */
function note(world: World, one: Shape, two: Shape, depth: number): void {
  const a = one.id < two.id ? one : two;
  const b = one.id < two.id ? two : one;
  const { movers, pairs } = world;
  if (!mayInteract(a, b) || !isSwept(movers.of(a.owner!), movers.of(b.owner!))) {
    return;
  }
  const pair = pairs.find(a, b);
  if (isKnown(pair, movers, depth) || !(isSensed(a, b) || canPush(a.owner!) || canPush(b.owner!))) {
    return;
  }
  const meeting = movers.meetings.draft(a, b);
  if (pair?.foreseen) {
    recheck(world, meeting, depth);
  } else if (meets(world, meeting, depth, 0)) {
    add(world, meeting);
  }
}

function add({ movers }: World, meeting: Meeting): void {
  const { a, b } = meeting;
  movers.meetings.add(meeting, movers.of(a.owner!), movers.of(b.owner!), !isSensed(a, b));
}

/**
 * A contact that was foreseen and solved may not have held, as where a sliver is hit at its tip and whirls round. The true way had a bend where
 * they met, from where on they turned otherwise: so the straight one is looked at as if what was added to the turn had been there from the start.
 */
function recheck(world: World, meeting: Meeting, depth: number): void {
  const one = world.movers.of(meeting.a.owner!);
  const two = world.movers.of(meeting.b.owner!);
  one.unbend();
  two.unbend();
  if (meets(world, meeting, depth, 0)) {
    add(world, meeting);
  } else {
    one.bend();
    two.bend();
  }
}

/**
 * The solver has seen to the pair, or need not. A contact keeps its normal for the whole step: where bodies turn meanwhile, surfaces get as deep
 * as they go sideways, times the turn.
 */
function isKnown(pair: Arbiter | null, movers: Movers, depth: number): boolean {
  if (pair === null || !(pair.active || pair.near)) {
    return false;
  }
  if (pair.sensor || !pair.accepted || movers.ahead > 0) {
    return true;
  }
  const a = movers.of(pair.bodyA);
  const b = movers.of(pair.bodyB);
  const way = Math.abs(b.dx - a.dx) + Math.abs(b.dy - a.dy) + Math.min(a.body.radius, b.body.radius);
  const spin = visibleTurn(pair.shapeA, a.spin, pair.shapeB, b.spin);
  return !pair.foreseen && spin * way < leastDepth(pair.shapeA, pair.shapeB, depth);
}

function isJointed(a: Shape, b: Shape): boolean {
  return a.owner!.constraints.length + b.owner!.constraints.length > 0;
}

/** How deep two shapes have to get for an impact: jointed bodies more, as stopping one of them alone opens its joints. */
function leastDepth(a: Shape, b: Shape, depth: number): number {
  return (isJointed(a, b) ? JOINT_PATIENCE : 1) * impactDepth(a, b, depth);
}

/** An impulse has an effect on the body. */
function canPush(body: RigidBody): boolean {
  return body.inverseMass() > 0 || body.inverseInertia() > 0;
}

/**
 * Finds when two shapes first touch, not before `from`, if they do, and will get deeper than contacts leave: what slides over the joint of
 * two tiles meets the second one, but no deeper than it lies on the first. If they touch already, or have joints, which would open by as much as they
 * are put back: when they are that deep.
 */
export function meets(world: World, meeting: Meeting, depth: number, from: number): boolean {
  const { a, b } = meeting;
  const one = world.movers.of(a.owner!);
  const two = world.movers.of(b.owner!);
  const { x, y } = one;
  one.follow(sweep.a, a, x, y);
  two.follow(sweep.b, b, x, y);
  if (isSensed(a, b)) {
    meeting.time = timeOfImpact(sweep, 0, SWEEP_TOLERANCE, from, 1);
    return meeting.time >= 0;
  }
  const least = leastDepth(a, b, depth);
  const time = timeOfImpact(sweep, -Math.min(TOUCH_DEPTH, least / 2), SWEEP_TOLERANCE, from, 1);
  if (time < 0) {
    return false;
  }
  const isCarried = one.body.kind === KINEMATIC || two.body.kind === KINEMATIC;
  const deeper = sweep.distance.value - (isCarried ? 0 : DEEPER_SHARE * least);
  const deep = timeOfImpact(sweep, Math.min(-least, deeper), SWEEP_TOLERANCE, time, 1);
  meeting.time = deep >= 0 && time > from && !isJointed(a, b) ? time : deep;
  return deep >= 0;
}
