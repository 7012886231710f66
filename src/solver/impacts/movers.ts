import type { RigidBody } from '../../body.js';
import { DYNAMIC, STATIC } from '../../body-kind.js';
import { BOUNCE_LEFT, BOUNCE_SUDDEN, FAR, SAME_TIME, SPECULATIVE_MARGIN } from '../../config.js';
import type { Arbiter } from '../../contact/arbiter.js';
import * as c from '../../contact/layout.js';
import type { Travel } from '../../geometry/sweep.js';
import { grown, widened } from '../../math/doubles.js';
import { List, release } from '../../math/list.js';
import type { Shape } from '../../shape/shape.js';
import type { World } from '../../world.js';
import * as d from '../layout.js';
import { Nearby } from '../nearby.js';
import { isInTrain, isTied } from '../ties.js';
import { ClearSpace } from './clear-space.js';
import { type Meeting, MeetingQueue } from './meeting-queue.js';
import { Ways } from './ways.js';

const TURN = 2 * Math.PI;

/**
 * A body on its way through a step, from time 0 to 1: a way that is foreseen, or one that was just solved, seen from its end. Its numbers
 * are fractions before they are set: if the first fraction came late, everything that was compiled for integers would be thrown away.
 */
export class Mover {
  body!: RigidBody;
  /** Whether it looks for what it may meet; others are only met. */
  looks = false;
  /** Whether it moves so far that it may pass something. */
  sweeps = false;
  /** Whether something met it on its way. */
  met = false;
  /** Whether an impact ended its way. */
  stopped = false;
  /** Velocities at the start of the step. */
  vx = 0.5;
  vy = 0.5;
  w = 0.5;
  /** The time in the step to which the body was moved last. */
  at = 0.5;
  /** Where the body was at time `from`, and by how much it moves from there until time 1. */
  from = 0.5;
  x = 0.5;
  y = 0.5;
  angle = 0.5;
  dx = 0.5;
  dy = 0.5;
  turn = 0.5;
  /** How far it turns in the step, with whole turns, rad. */
  spin = 0.5;
  /** Where it was at time 0, and where it is at the end of the step if nothing meets it; after an impact, where it has its velocity. */
  startX = 0.5;
  startY = 0.5;
  startAngle = 0.5;
  endX = 0.5;
  endY = 0.5;
  endAngle = 0.5;
  /** The last meeting that was found of it, if it is dynamic: with `nextOf` a list of all. */
  newestMeeting: Meeting | null = null;
  /** When it first met something, as far as was asked. */
  firstTime = Infinity;
  /** When it stops for the rest of the step at the latest, at something static that it meets; 1 if that is not known. */
  until = 0.5;
  /** What has carried it along since it was stopped. */
  carrier: Mover | null = null;

  /** Sets the way of the step that is over, to where the body is now. */
  retrace(): void {
    const { body } = this;
    this.sweeps = this.looks;
    this.dx = body.lastDx;
    this.dy = body.lastDy;
    this.turn = body.lastTurn;
    this.x = body.x - this.dx;
    this.y = body.y - this.dy;
    this.angle = body.angle - this.turn;
    this.begin();
  }

  /** Sets the way that the body would go from here with its velocities. */
  aim(movers: Movers): void {
    const { body } = this;
    this.dx = body.vx;
    this.dy = body.vy;
    this.turn = body.w;
    this.foresee(movers);
  }

  /** The same with the average velocities in `dx`, `dy` and `turn`. */
  foresee({ ahead }: Movers): void {
    const { body } = this;
    // As `scale`, for which the number would be boxed.
    this.dx *= ahead;
    this.dy *= ahead;
    this.turn *= ahead;
    if (!(Math.abs(this.dx) + Math.abs(this.dy) + Math.abs(this.turn) <= FAR)) {
      // The step will freeze it.
      this.dx = 0;
      this.dy = 0;
      this.turn = 0;
    }
    this.x = body.x;
    this.y = body.y;
    this.angle = body.angle;
    this.begin();
    // As `goesFar`, which would have to box its numbers if it were called from here.
    const way = Math.abs(this.dx) + Math.abs(this.dy) + this.spin * body.radius;
    this.sweeps = body.liveIndex >= 0 && way > SPECULATIVE_MARGIN / 2;
  }

  /** Begins the way that was set. Without arguments: numbers with a fraction are boxed for each call that is not inlined. */
  private begin(): void {
    const { body } = this;
    this.met = false;
    this.stopped = false;
    this.newestMeeting = null;
    this.firstTime = Infinity;
    this.until = 1;
    this.carrier = null;
    this.vx = body.vx;
    this.vy = body.vy;
    this.w = body.w;
    this.from = 0;
    this.startX = this.x;
    this.startY = this.y;
    this.startAngle = this.angle;
    this.endX = body.x;
    this.endY = body.y;
    this.endAngle = body.angle;
    // Of whole turns only the first one counts, in which the body passes everything around it.
    this.spin = Math.abs(this.turn);
    if (this.spin >= TURN) {
      this.turn = (this.turn % TURN) + Math.sign(this.turn) * TURN;
    }
  }

  /** Sets a travel to the way from `from` on, relative to where another mover is then. */
  follow(travel: Travel, shape: Shape, origin: Mover): void {
    const rest = 1 - this.from;
    const rate = rest > 0 ? 1 / rest : 0;
    travel.shape = shape;
    travel.vx = this.dx * rate;
    travel.vy = this.dy * rate;
    travel.w = this.turn * rate;
    travel.x = this.x - travel.vx * this.from - origin.x;
    travel.y = this.y - travel.vy * this.from - origin.y;
    travel.angle = this.angle - travel.w * this.from;
  }

  /**
   * Gives the body the velocity that it had at the time to which it was moved, before the first stop. What forces added in the step came
   * evenly, and so did what contacts added, unless it turned the body back: then it bounced before. What it got from another dynamic body
   * it keeps, as the other one keeps the opposite. When joints to static bodies added what they added is told by the way: a motor may do it
   * all at once.
   */
  rewindVelocity({ solver, movers, jointSolver }: World): void {
    if (this.stopped) {
      return;
    }
    const { body } = this;
    const { drive, substeps } = solver;
    const slot = body.slot * d.BODY_STRIDE;
    // What forces added in the step, and all of the change.
    const gainX = substeps * drive[slot + d.GAIN_X]!;
    const gainY = substeps * drive[slot + d.GAIN_Y]!;
    const dx = body.vx - this.vx;
    const dy = body.vy - this.vy;
    const square = dx * dx + dy * dy;
    const gain = gainX * gainX + gainY * gainY;
    const isSudden = square > BOUNCE_SUDDEN * BOUNCE_SUDDEN * gain;
    const wasGiven = isSudden && wasPushed(body);
    const isHeld = jointSolver !== null && isTied(body);
    if (isHeld && (wasGiven || isInTrain(body))) {
      // At most as much of what forces added as there is: what hangs at rest got it back from its joints.
      const share = gain > 0 ? Math.min(Math.max((dx * gainX + dy * gainY) / gain, 0), 1) : 0;
      body.vx += (this.at - 1) * share * gainX;
      body.vy += (this.at - 1) * share * gainY;
    } else {
      const left = (isHeld ? jointSolver.shareOfChange(this, movers, substeps) : this.at) - 1;
      const turnedBack = isSudden && body.vx * dx + body.vy * dy > BOUNCE_LEFT * square;
      const keeps = !isHeld && (turnedBack || wasGiven);
      body.vx += left * (keeps ? gainX : dx);
      body.vy += left * (keeps ? gainY : dy);
      body.w += left * (keeps ? substeps * drive[slot + d.GAIN_W]! : body.w - this.w);
    }
    // Another impact at the same time finds this done.
    this.stopped = true;
    this.endX = body.x;
    this.endY = body.y;
  }

  /**
   * After a body that touched before was put back, and pushed out of what it got too deep into: as forces did not move it to where it is
   * now, their work on the difference is taken from its motion along them, and from its turning. Else a box of elasticity 1 got some
   * millimetres of height each time it turned onto its next corner within a step.
   */
  settle({ solver, movers }: World): void {
    const { body } = this;
    const slot = body.slot * d.BODY_STRIDE;
    const gainX = solver.substeps * solver.drive[slot + d.GAIN_X]!;
    const gainY = solver.substeps * solver.drive[slot + d.GAIN_Y]!;
    const endX = this.x + this.dx;
    const endY = this.y + this.dy;
    const gain = gainX * gainX + gainY * gainY;
    const along = (body.vx * gainX + body.vy * gainY) / gain;
    // Nothing changes if the inertia is infinite, and it turns all the same.
    const turning = body.w === 0 ? 0 : (body.w * body.w * body.inertia) / body.mass;
    const square = along * along * gain + turning;
    // Not without forces, where it is not a number.
    if (square > 0) {
      const work = (gainX * (endX - this.endX) + gainY * (endY - this.endY)) / movers.duration;
      const change = Math.sqrt(Math.max(0, 1 + (2 * work) / square)) - 1;
      body.vx += change * along * gainX;
      body.vy += change * along * gainY;
      body.w += change * body.w;
    }
    this.endX = endX;
    this.endY = endY;
  }

  /** Whether nothing met the body before that time, as far as was asked; true for static and kinematic bodies. */
  comesFirst(time: number): boolean {
    this.firstTime = Math.min(this.firstTime, time);
    return this.body.kind !== DYNAMIC || time <= this.firstTime + SAME_TIME;
  }

  /** The earliest of its meetings in the heap. */
  earliestMeeting(): Meeting | null {
    let first: Meeting | null = null;
    for (let next = this.newestMeeting; next !== null; next = next.nextOf(this)) {
      if (next.slot >= 0 && (first === null || next.time < first.time)) first = next;
    }
    return first;
  }

  /**
   * Moves the body, unless it is static, to where it is at a time, not before `from`. No longer than what is always inlined, as `begin` is
   * without arguments.
   */
  moveBodyTo(time: number): void {
    this.at = time;
    this.moveBody();
  }

  private moveBody(): void {
    const { body } = this;
    if (body.kind === STATIC) {
      return;
    }
    const rest = 1 - this.from;
    const share = rest > 0 ? (this.at - this.from) / rest : 0;
    body.x = this.x + share * this.dx;
    body.y = this.y + share * this.dy;
    body.angle = this.angle + share * this.turn;
    body.refreshTurn();
  }

  /** Scales the rest of the way. */
  scale(share: number): void {
    this.dx *= share;
    this.dy *= share;
    this.turn *= share;
  }

  /** Stops the body where it was moved to; from there on it stays. */
  stop(): void {
    this.scale(0);
    this.restart();
  }

  /** Lets the body go the rest of its way from where it was moved to. */
  resume(): void {
    const rest = 1 - this.from;
    this.scale(rest > 0 ? (1 - this.at) / rest : 0);
    this.restart();
  }

  /** Lets the rest of the way begin where the body was moved to. */
  private restart(): void {
    const { body } = this;
    this.stopped = true;
    this.from = this.at;
    this.x = body.x;
    this.y = body.y;
    this.angle = body.angle;
  }

  /** From its stop on, moves the body along with another one, as if it were part of that. */
  ride(carrier: Mover): void {
    const { body } = this;
    const { body: under } = carrier;
    this.carrier = carrier;
    carrier.moveBodyTo(this.from);
    const x = under.cos * (body.x - under.x) + under.sin * (body.y - under.y);
    const y = under.cos * (body.y - under.y) - under.sin * (body.x - under.x);
    const { angle } = under;
    carrier.moveBodyTo(1);
    this.dx = under.x + under.cos * x - under.sin * y - this.x;
    this.dy = under.y + under.sin * x + under.cos * y - this.y;
    this.turn = under.angle - angle;
  }

  /** Leaves the body where it is at the end of the step. */
  finish(): void {
    const { body } = this;
    this.moveBodyTo(1);
    if (!this.stopped) {
      body.x = this.endX;
      body.y = this.endY;
      body.angle = this.endAngle;
      body.refreshTurn();
    }
    body.lastDx = body.x - this.startX;
    body.lastDy = body.y - this.startY;
    body.lastTurn = body.angle - this.startAngle;
    body.moved();
  }
}

/** Whether another dynamic body gave this one an impulse in this step. */
function wasPushed({ shapes }: RigidBody): boolean {
  return shapes.some(isPushed);
}

function isPushed({ arbiters }: Shape): boolean {
  return arbiters.some(pushes);
}

function pushes(pair: Arbiter): boolean {
  const { bodyA, bodyB, numbers: n, at: o } = pair;
  const hasPushed = n[o + c.STEP_NORMAL]! + n[o + c.STEP_NORMAL + c.IMPULSES]! > 0;
  return hasPushed && pair.isSolved() && bodyA.kind === DYNAMIC && bodyB.kind === DYNAMIC;
}

/**
 * Whether a body, with its velocities, moves by more than half the speculative margin in a step: then it may meet something that is not
 * solved.
 */
export function goesFar({ vx, vy, w, radius }: RigidBody, dt: number): boolean {
  return Math.abs(vx * dt) + Math.abs(vy * dt) + Math.abs(w * dt) * radius > SPECULATIVE_MARGIN / 2;
}

/** The movers of a step: those that look, and others that were met. Used again and again. */
export class Movers {
  /** What lies beyond the count is used again. */
  readonly all: Mover[] = [];
  count = 0;
  /** How many of them look for what they may meet. */
  looking = 0;
  readonly meetings = new MeetingQueue();
  readonly ways = new Ways();
  readonly nearby = new Nearby();
  readonly space = new ClearSpace();
  /**
   * The meetings that come at once, and those of their pairs that are not refused. Each world has its own: handlers are called in between,
   * and may step another world.
   */
  readonly together = new List<Meeting>();
  readonly struck = new List<Arbiter>();
  /** Length of the step while it is foreseen, else 0, s. */
  ahead = 0;
  /**
   * Length of the step that is over, at its end, s. A field, as it would be boxed for each impact if it were passed from function to
   * function.
   */
  duration = 0.5;
  /**
   * While a step is foreseen: whether everything that moves far bounces off everything else that does, so that their meetings need not be
   * foreseen.
   */
  bouncy = false;
  /** While a step is foreseen: whether there is no kinematic body and no bullet, so that bodies only meet what stands still. */
  alone = false;
  /** For how long forces have acted on a body, on the average of the step, s. */
  forceTime = 0;
  /** By how much gravity may change a velocity in that time, m/s. */
  gravityGain = 0;

  /**
   * Two numbers for each foreseen contact: by how much the separations of its points are less than those at the time when the shapes meet,
   * m. The first two are not used.
   */
  foresight = new Float64Array(64);
  /** How many contacts were foreseen in this step, or tried. */
  foreseenCount = 0;

  /** A place in `foresight` for a contact. */
  foreseeContact(): number {
    this.foreseenCount += 1;
    if (2 * this.foreseenCount + 1 >= this.foresight.length) {
      this.foresight = widened(this.foresight, new Float64Array(grown(this.foresight.length)));
    }
    return this.foreseenCount;
  }

  /** Adds a mover for a body, whose way is still to be set. */
  add(body: RigidBody, looks: boolean): Mover {
    if (this.count === this.all.length) {
      this.all.push(new Mover());
    }
    const mover = this.all[this.count]!;
    body.mover = this.count;
    mover.body = body;
    mover.looks = looks;
    this.count += 1;
    this.looking += looks ? 1 : 0;
    return mover;
  }

  /** The mover of a body; if it has none, it gets one that does not look. */
  of(body: RigidBody): Mover {
    if (body.mover >= 0) {
      return this.all[body.mover]!;
    }
    const mover = this.add(body, false);
    if (this.ahead > 0) {
      mover.aim(this);
    } else {
      mover.retrace();
    }
    return mover;
  }

  clear(): void {
    for (let i = 0; i < this.count; i += 1) {
      this.all[i]!.body.mover = -1;
    }
    this.count = 0;
    this.looking = 0;
    this.ahead = 0;
    this.bouncy = false;
  }

  /** Releases bodies and shapes of earlier steps. To be called between steps. */
  release(): void {
    for (const mover of this.all) {
      mover.body = null!;
    }
    this.meetings.release();
    release(this.ways.shapes, 0);
    release(this.nearby.shapes, 0);
  }
}
