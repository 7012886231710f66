import type { RigidBody } from '../body.js';
import { DYNAMIC } from '../body-kind.js';
import { MAX_GROWTH, MOST_SPANS, REST_SPIN_WEIGHT, STEADY_ACCELERATION_SQUARED } from '../config.js';
import { ELASTICITY, NORMAL } from '../contact/layout.js';
import { pow } from '../math/trig.js';
import type { World } from '../world.js';
import { packContacts } from './contacts/pack-contacts.js';
import { packUndriven, type SolverData } from './data.js';
import { findForces, forces } from './forces.js';
import { freezeIfWild } from './freeze.js';
import * as d from './layout.js';
import { findSqueezes } from './squeezes.js';

/** The share of a velocity that drag leaves after h seconds, (1 − drag)^h. Kept, as most bodies have the same drag in all steps. */
class Keep {
  drag = -1.5;
  h = 0.5;
  keep = 0.5;

  find(drag: number, h: number): void {
    if (drag !== this.drag || h !== this.h) {
      this.drag = drag;
      this.h = h;
      this.keep = drag >= 1 ? 0 : pow(1 - drag, h);
    }
  }
}

// The last results, for any world: they change no result.
const linear = /* @__PURE__ */ new Keep();
const angular = /* @__PURE__ */ new Keep();

/** Packs awake bodies, live constraints and accepted contacts for sub-steps of length h. */
export function prepare(world: World, h: number): void {
  const data = world.solver;
  if (world.liveDynamics.length + world.liveKinematics.length + world.liveConstraints.length > 0) {
    packBodies(world);
    packDrives(world, h);
    // If no two shapes are near each other, nobody needs them.
    if (world.pairs.sorted.count > 0) packTraits(world);
    scaleImpulses(world, h);
  } else {
    // Where nothing is awake nothing is packed: what sleeps is to start from the step in which it fell asleep.
    data.bodyCount = 1;
  }
  packContacts(world);
  if (data.squeezes.contacts.count > 0) findSqueezes(world, h);
  if (world.jointSolver === null) {
    world.jointsStale = false;
    world.jointsTouched = false;
  } else {
    world.jointSolver.pack(world, h);
  }
}

/**
 * Finds how impulses are scaled for the warm start. What is random in the impulses of short sub-steps does not get smaller with the load.
 * So in short sub-steps the impulses with which contacts and joints start the next step change only as much as in a part, of that length,
 * of one of the longer sub-steps before: then nothing notices that some steps are short, as in slow motion, or where a game steps by what
 * is left of a frame. Without it a pyramid crept by 0.1 m in half a minute, and heaps were thrown up by each step that was more than four
 * times as long as the one before.
 */
function scaleImpulses(world: World, h: number): void {
  const data = world.solver;
  const growth = h / (data.previousH || h);
  const isLong = h > MAX_GROWTH * (data.span || h);
  data.contactScale = growth;
  data.impulseScale = isLong ? 0 : growth;
  if (isLong) dropUnsteady(world, data.previousH * data.substeps);
  if (h >= data.span) {
    data.spans = h > 2 * data.span ? 0 : Math.min(MOST_SPANS, data.spans + 1);
    data.span = h;
  } else {
    data.spans -= h / data.span;
    if (data.spans <= 0) {
      data.spans = 0;
      data.span = Math.max(h, data.span - h);
    }
  }
  data.remembered = 1 - h / data.span;
  data.previousH = h;
}

/**
 * Drops the kept impulses of contacts, except between bodies without joints that nothing has accelerated in the last step, of dt, or woken
 * since, as a change of gravity does: those of towers and houses of cards. What is left of a blow would throw up what was struck, and what is
 * random in joints their bodies. Where a body was taken away all are dropped: they may have carried it.
 */
function dropUnsteady(world: World, dt: number): void {
  const { sorted } = world.pairs;
  for (let i = 0; i < sorted.count; i += 1) {
    const { bodyA, bodyB, numbers, at } = sorted.items[i]!;
    if (world.solver.unloads || !isSteady(world, bodyA, dt) || !isSteady(world, bodyB, dt)) {
      numbers.fill(0, at + NORMAL, at + ELASTICITY);
    }
  }
}

/** Whether the velocity of a body is about that of its motion in the last step, of dt. */
function isSteady({ solver, timeStamp }: World, body: RigidBody, dt: number): boolean {
  const { slot, vx, vy, lastDx, lastDy, wakeTime } = body;
  const x = vx - lastDx / dt;
  const y = vy - lastDy / dt;
  const isFree = (solver.traits[slot]! & d.LINKED) === 0 && wakeTime < timeStamp;
  return isFree && x * x + y * y <= STEADY_ACCELERATION_SQUARED * dt * dt;
}

function packBodies(world: World): void {
  const data = world.solver;
  const dynamics = world.liveDynamics;
  const kinematics = world.liveKinematics;
  data.resetBodies(1 + dynamics.length + kinematics.length);
  let slot = 1;
  for (let i = 0; i < dynamics.length; i += 1) {
    packBody(data, dynamics[i]!, slot);
    slot += 1;
  }
  for (let i = 0; i < kinematics.length; i += 1) {
    packBody(data, kinematics[i]!, slot);
    packUndriven(data, slot);
    freezeIfWild(world, kinematics[i]!);
    slot += 1;
  }
}

function packBody(data: SolverData, body: RigidBody, slot: number): void {
  const at = slot * d.BODY_STRIDE;
  body.refreshMass();
  const { kind, mass, inertia } = body;
  // As `inverseMass` and `inverseInertia`, which would have to box what they return if they were called from here.
  const invMass = kind === DYNAMIC && mass > 0 ? 1 / mass : 0;
  const invInertia = kind === DYNAMIC && inertia > 0 ? 1 / inertia : 0;
  body.slot = slot;
  const { velocity, motion } = data;
  velocity[at + d.VX] = body.vx;
  velocity[at + d.VY] = body.vy;
  velocity[at + d.W] = body.w;
  velocity[at + d.INV_MASS] = invMass;
  velocity[at + d.INV_INERTIA] = invInertia;
  velocity[at + d.COS_LESS_ONE] = 0;
  velocity[at + d.SIN] = 0;
  velocity[at + d.MARK] = 0;
  motion[at + d.INV_MASS] = invMass;
  motion[at + d.INV_INERTIA] = invInertia;
  data.drive[at + d.TOUCHED] = 0;
  data.drive[at + d.LOAD] = 0;
}

/**
 * Packs what drives dynamic bodies in sub-steps of length h. Like `packTraits` a pass of its own: a function too long to be compiled as a
 * whole boxes numbers.
 */
function packDrives(world: World, h: number): void {
  const { velocity, drive } = world.solver;
  const dynamics = world.liveDynamics;
  for (let i = 0; i < dynamics.length; i += 1) {
    const body = dynamics[i]!;
    linear.find(body.linearDrag, h);
    angular.find(body.angularDrag, h);
    findForces(body);
    body.applied?.pass();
    const at = body.slot * d.BODY_STRIDE;
    const { gravityScale } = body;
    const invMass = velocity[at + d.INV_MASS]!;
    const invInertia = velocity[at + d.INV_INERTIA]!;
    drive[at + d.GAIN_X] = invMass === 0 ? 0 : (forces[0]! * invMass + world.gravityX * gravityScale) * h;
    drive[at + d.GAIN_Y] = invMass === 0 ? 0 : (forces[1]! * invMass + world.gravityY * gravityScale) * h;
    drive[at + d.GAIN_W] = forces[2]! * invInertia * h;
    drive[at + d.REST_RADIUS] = invInertia === 0 ? 0 : (REST_SPIN_WEIGHT * invMass) / invInertia;
    drive[at + d.KEEP_LINEAR] = invMass === 0 ? 1 : linear.keep;
    drive[at + d.KEEP_ANGULAR] = invInertia === 0 ? 1 : angular.keep;
    freezeIfWild(world, body);
  }
}

/** Packs what contacts have to know of dynamic bodies; kinematic ones have none of it. */
function packTraits({ solver, liveDynamics, timeStamp }: World): void {
  solver.unloads = false;
  solver.traits.fill(0, 1 + liveDynamics.length, solver.bodyCount);
  for (let i = 0; i < liveDynamics.length; i += 1) {
    const body = liveDynamics[i]!;
    solver.unloads ||= body.unloaded === timeStamp;
    solver.traits[body.slot] =
      (body.constraints.length > 0 && isLinked(body) ? d.LINKED : 0) |
      (body.shapes.length > 1 ? d.COMPOUND : 0) |
      (body.surfaceX !== 0 || body.surfaceY !== 0 ? d.RUBS : 0);
  }
}

/** Whether an enabled joint of its world holds the body. Custom constraints hold whatever they like: they do not count. */
function isLinked({ constraints, owner }: RigidBody): boolean {
  for (let i = 0; i < constraints.length; i += 1) {
    const constraint = constraints[i]!;
    if (constraint.enabled && constraint.owner === owner && constraint.type !== 'CUSTOM') {
      return true;
    }
  }
  return false;
}
