import type { Constraint } from '../constraint/constraint.js';
import type { Audit } from './audit.js';

/** Checks constraints: lists, sleeping, interactions that they switch off, numbers. */
export function auditConstraints(audit: Audit): void {
  const { world } = audit;
  const { constraints, liveConstraints } = world;
  audit.distinct(constraints, world, 'constraints');
  constraints.forEach((constraint, i) => {
    audit.demand(constraint.owner === world, constraint, 'must know its world');
    audit.demand(constraint.index === i, constraint, `index must be ${i}, got ${constraint.index}`);
    for (const body of constraint.members) {
      audit.demand(body.constraints.includes(constraint), constraint, 'must be listed by its bodies');
    }
    auditSleeping(audit, constraint);
    auditNumbers(audit, constraint);
  });
  liveConstraints.forEach((constraint, i) => {
    audit.demand(constraint.owner === world, constraint, 'is live, but not in the world');
    audit.demand(constraint.liveIndex === i, constraint, `liveIndex must be ${i}, got ${constraint.liveIndex}`);
  });
  for (const body of world.rigidBodies) {
    audit.distinct(body.constraints, body, 'constraints');
    let ignoring = 0;
    for (const constraint of body.constraints) {
      audit.demand(constraint.members.includes(body), body, 'lists a constraint that does not use it');
      audit.demand(constraint.owner !== null, body, 'lists a constraint that is in no world');
      ignoring += constraint.enabled && constraint.ignoreInteractions ? new Set(constraint.members).size : 0;
    }
    const listed = body.ignoring?.length ?? 0;
    audit.demand(listed === ignoring, body, `must list ${ignoring} that it ignores, got ${listed}`);
  }
}

function auditSleeping(audit: Audit, constraint: Constraint): void {
  const { world } = audit;
  const { enabled, asleep, liveIndex, island } = constraint;
  const isLive = world.liveConstraints[liveIndex] === constraint;
  audit.demand(isLive === (enabled && !asleep), constraint, 'must be live just while it is enabled and awake');
  audit.demand(isLive || liveIndex === -1, constraint, 'is not live, but has a place in the live list');
  audit.demand(island === null || asleep, constraint, 'is in an island, but does not sleep there');
  const isNoted = !constraint.woken || world.events.woken.has(constraint);
  audit.demand(isNoted, constraint, 'waits for a wake event that is not noted');
}

function auditNumbers(audit: Audit, constraint: Constraint): void {
  for (const part of constraint.impulse) {
    audit.finite(constraint, 'impulse', part);
  }
  for (const part of constraint.given) {
    audit.finite(constraint, 'impulse given to a body', part);
  }
  audit.demand(constraint.lower <= constraint.upper, constraint, 'lower bound must not be above the upper one');
}
