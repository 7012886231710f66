import type { RigidBody } from '../body.js';
import { DYNAMIC, KINEMATIC, STATIC } from '../body-kind.js';
import * as g from '../collide/layout.js';
import { CONTACT_SLOP, IMPACT_DEPTH, PUSH_SHARE_STATIC } from '../config.js';
import type { Arbiter } from '../contact/arbiter.js';
import { cos, sin } from '../math/trig.js';
import type { Shape } from '../shape/shape.js';
import type { World } from '../world.js';
import { beginSensing, strike } from './impact.js';
import { comesBefore, findMeetings, isSensed, type Meeting, meetingTime } from './meetings.js';
import type { Mover } from './movers.js';

/**
 * What moved so far in this step that it may have passed something is swept from where the step began to where it ended, against everything that
 * was not in contact with it and so not known to the solver: dynamic bodies against static and kinematic ones, bullets against all. The first
 * impact stops a dynamic body there for the rest of the step, with its impulse; a kinematic partner that goes on carries it along.
 */
export function continuous(world: World, dt: number): void {
  const { movers } = world;
  if (movers.count === 0) {
    return;
  }
  const meetings = findMeetings(world, IMPACT_DEPTH);
  settle(
    world,
    dt,
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
function settle(world: World, dt: number, meetings: Meeting[]): void {
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
    const pair = strike(world, a, b, time);
    if (pair !== null) {
      const stopped = bodies.filter(({ kind }) => kind === DYNAMIC);
      for (const body of stopped) {
        const partner = movers.of(body === a.owner ? b.owner! : a.owner!);
        halt(movers.of(body), partner, time);
        if (pair.metAgain() && partner.body.kind !== DYNAMIC) {
          slide(movers.of(body), partner, pair, dt);
        }
      }
      coming = lookAgain(world, coming, stopped, time);
    }
  }
  for (const body of met) {
    movers.of(body).finish();
  }
}

/** A dynamic body stays where an impact came, for the rest of the step; if the partner is kinematic and goes on, that carries it along. */
function halt(mover: Mover, partner: Mover, time: number): void {
  mover.stop(time);
  if (partner.body.kind === KINEMATIC) {
    mover.ride(partner);
  }
}

/**
 * What touched before, and only got too deep as it turned, goes on along the surface and out of it, without turning: else it would never get away.
 * The surface itself may turn until the end of the step.
 */
function slide(mover: Mover, under: Mover, { manifold: m, bodyA }: Arbiter, dt: number): void {
  const { body } = mover;
  const { body: base } = under;
  const n = m.numbers;
  const rest = 1 - mover.from;
  const sign = body === bodyA ? -1 : 1;
  const nx = sign * n[g.NX]!;
  const ny = sign * n[g.NY]!;
  const vx = body.vx - (base.vx - base.w * (body.y - base.y));
  const vy = body.vy - (base.vy + base.w * (body.x - base.x));
  const way = (nx * vy - ny * vx) * rest * dt;
  const depth = -(m.count === 2 ? Math.min(n[g.S0]!, n[g.S1]!) : n[g.S0]!);
  const out = PUSH_SHARE_STATIC * Math.max(depth - CONTACT_SLOP, 0);
  const x = out * nx - way * ny;
  const y = out * ny + way * nx;
  const turn = under.turn * rest;
  mover.dx += cos(turn) * x - sin(turn) * y;
  mover.dy += sin(turn) * x + cos(turn) * y;
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
