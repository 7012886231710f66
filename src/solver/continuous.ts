import type { RigidBody } from '../body.js';
import { DYNAMIC, KINEMATIC, STATIC } from '../body-kind.js';
import type { BroadphaseHandle } from '../broadphase/broadphase.js';
import { IMPACT_DEPTH, IMPACT_SHARE, SWEEP_TOLERANCE, TOUCH_DEPTH } from '../config.js';
import { Sweep, timeOfImpact } from '../geometry/sweep.js';
import type { Shape } from '../shape/shape.js';
import type { World } from '../world.js';
import { mayInteract } from './find-pairs.js';
import { beginSensing, halt, strike } from './impact.js';
import type { Mover } from './movers.js';

/** Two shapes that meet on their ways, and when: 0 where the step began, 1 where it ended. */
interface Meeting {
  readonly a: Shape;
  readonly b: Shape;
  readonly time: number;
}

const sweep = new Sweep();
const bounds = new Float64Array(4);

/**
 * What moved so far in this step that it may have passed something is swept from where the step began to where it ended, against everything that
 * was not in contact with it and so not known to the solver: dynamic bodies against static and kinematic ones, bullets against all. The first
 * impact stops a dynamic body there for the rest of the step, with its impulse; a kinematic partner that goes on carries it along.
 */
export function continuous(world: World): void {
  const { movers } = world;
  if (movers.count === 0) {
    return;
  }
  const meetings = findMeetings(world);
  settle(
    world,
    meetings.filter(({ a, b }) => !isSensed(a, b)),
  );
  for (const { a, b, time } of meetings) {
    if (isSensed(a, b) && comesTo(world, a, time) && comesTo(world, b, time)) {
      beginSensing(world, a, b);
    }
  }
  movers.clear();
}

function isSensed(a: Shape, b: Shape): boolean {
  return a.sensor || b.sensor;
}

/** No impact has stopped the shape before that time. */
function comesTo(world: World, shape: Shape, time: number): boolean {
  const mover = world.movers.of(shape.owner!);
  return !mover.stopped || time <= mover.from;
}

/** Everything that meets if nothing else does. */
function findMeetings(world: World): Meeting[] {
  const { movers, broadphase } = world;
  const found: Meeting[] = [];
  const count = movers.count;
  for (let i = 0; i < count; i += 1) {
    setBounds(movers.all[i]!);
  }
  for (let i = 0; i < count; i += 1) {
    const mover = movers.all[i]!;
    for (const shape of mover.body.shapes) {
      const nearby: Shape[] = [];
      setShapeBounds(mover, shape);
      broadphase.sample(bounds, (handle: BroadphaseHandle) => nearby.push(handle.data as Shape));
      for (const other of nearby) {
        if (!movers.sweeps(other.owner!)) {
          note(world, shape, other, found);
        }
      }
    }
    for (let j = i + 1; j < count; j += 1) {
      const other = movers.all[j]!;
      if (isSwept(mover, other) && overlap(mover.bounds, other.bounds)) {
        pairUp(world, mover, other, found);
      }
    }
  }
  return found;
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

/** Of two dynamic bodies one has to be a bullet that is fast itself. */
function isSwept(one: Mover, two: Mover): boolean {
  const bullet = (one.body.bullet && one.sweeps) || (two.body.bullet && two.sweeps);
  return bullet || one.body.kind !== DYNAMIC || two.body.kind !== DYNAMIC;
}

function pairUp(world: World, one: Mover, two: Mover, found: Meeting[]): void {
  for (const a of one.body.shapes) {
    for (const b of two.body.shapes) {
      note(world, a, b, found);
    }
  }
}

/** Notes two shapes that may interact, do not yet in this step, and meet. */
function note(world: World, one: Shape, two: Shape, found: Meeting[]): void {
  const a = one.id < two.id ? one : two;
  const b = one.id < two.id ? two : one;
  const { movers, pairs } = world;
  if (!mayInteract(a, b) || !isSwept(movers.of(a.owner!), movers.of(b.owner!))) {
    return;
  }
  const pair = pairs.find(a, b);
  if ((pair !== null && (pair.active || pair.near)) || !(isSensed(a, b) || canPush(a.owner!) || canPush(b.owner!))) {
    return;
  }
  const time = meetingTime(world, a, b, 0);
  if (time >= 0) {
    found.push({ a, b, time });
  }
}

/** An impulse has an effect on the body. */
function canPush(body: RigidBody): boolean {
  return body.inverseMass() > 0 || body.inverseInertia() > 0;
}

/**
 * When two shapes first touch, not before `from`; −1 if they do not, or will not get deeper than contacts leave: what slides over the joint of
 * two tiles meets the second one, but no deeper than it lies on the first.
 */
function meetingTime(world: World, a: Shape, b: Shape, from: number): number {
  const one = world.movers.of(a.owner!);
  const two = world.movers.of(b.owner!);
  const { x, y } = one;
  one.follow(sweep.a, a, x, y);
  two.follow(sweep.b, b, x, y);
  if (isSensed(a, b)) {
    return timeOfImpact(sweep, 0, SWEEP_TOLERANCE, from, 1);
  }
  const depth = Math.min(IMPACT_DEPTH, IMPACT_SHARE * (a.thickness() + b.thickness()));
  const time = timeOfImpact(sweep, -Math.min(TOUCH_DEPTH, depth / 2), SWEEP_TOLERANCE, from, 1);
  return time >= 0 && timeOfImpact(sweep, -depth, SWEEP_TOLERANCE, time, 1) >= 0 ? time : -1;
}

/** Lets the impacts happen in the order in which they come; each changes what comes after it. */
function settle(world: World, meetings: Meeting[]): void {
  const { movers } = world;
  const met = new Set<RigidBody>();
  for (let coming = meetings; coming.length > 0; ) {
    const next = coming.reduce((first, other) => (comesBefore(other, first) ? other : first));
    const { a, b, time } = next;
    const bodies = [a.owner!, b.owner!].filter(({ kind }) => kind !== STATIC);
    for (const body of bodies) {
      movers.of(body).putAt(time);
      met.add(body);
    }
    coming = coming.filter((meeting) => meeting !== next);
    if (strike(world, a, b, time)) {
      const one = movers.of(a.owner!);
      const two = movers.of(b.owner!);
      const stopped = bodies.filter(({ kind }) => kind === DYNAMIC);
      for (const body of stopped) {
        halt(movers.of(body), body === one.body ? two : one, time);
      }
      coming = lookAgain(world, coming, stopped, time);
    }
  }
  for (const body of met) {
    movers.of(body).finish();
  }
}

/** In time; of equal ones those with kinematic bodies first, then by the ids of the shapes. */
function comesBefore(one: Meeting, two: Meeting): boolean {
  const [k, l] = [isKinematic(one), isKinematic(two)];
  if (one.time !== two.time || k !== l) {
    return one.time !== two.time ? one.time < two.time : k;
  }
  return one.a.id !== two.a.id ? one.a.id < two.a.id : one.b.id < two.b.id;
}

function isKinematic({ a, b }: Meeting): boolean {
  return a.owner!.kind === KINEMATIC || b.owner!.kind === KINEMATIC;
}

/** The meetings that are left now that some bodies have stopped. */
function lookAgain(world: World, meetings: Meeting[], stopped: RigidBody[], from: number): Meeting[] {
  return meetings.flatMap((meeting) => {
    const { a, b } = meeting;
    if (!stopped.includes(a.owner!) && !stopped.includes(b.owner!)) {
      return [meeting];
    }
    const time = meetingTime(world, a, b, from);
    return time >= 0 ? [{ a, b, time }] : [];
  });
}
