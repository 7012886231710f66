import type { RigidBody } from '../body.js';
import { DYNAMIC, STATIC } from '../body-kind.js';
import { IMPACT_DEPTH } from '../config.js';
import type { Shape } from '../shape/shape.js';
import type { World } from '../world.js';
import { beginSensing, halt, strike } from './impact.js';
import { comesBefore, findMeetings, isSensed, type Meeting, meetingTime } from './meetings.js';

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
  const meetings = findMeetings(world, IMPACT_DEPTH);
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

/** No impact has stopped the shape before that time. */
function comesTo(world: World, shape: Shape, time: number): boolean {
  const mover = world.movers.of(shape.owner!);
  return !mover.stopped || time <= mover.from;
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

/** The meetings that are left now that some bodies have stopped. */
function lookAgain(world: World, meetings: Meeting[], stopped: RigidBody[], from: number): Meeting[] {
  return meetings.flatMap((meeting) => {
    const { a, b } = meeting;
    if (!stopped.includes(a.owner!) && !stopped.includes(b.owner!)) {
      return [meeting];
    }
    const time = meetingTime(world, a, b, IMPACT_DEPTH, from);
    return time >= 0 ? [{ a, b, time }] : [];
  });
}
