import { CONTACT_SWEEPS } from '../config.js';
import type { World } from '../world.js';
import { applyBounces, planBounces, spareBounces } from './contacts/bounce.js';
import { partCrowds, solvePositionContacts, solveVelocityContacts, warmStartContacts } from './contacts/contacts.js';
import { solveShocks } from './contacts/shocks.js';
import { turnContacts } from './contacts/turning.js';
import { findPairs } from './find-pairs.js';
import { passPushed } from './forces.js';
import { continuous } from './impacts/continuous.js';
import { foresee } from './impacts/foresee.js';
import { advance, integratePositions, integrateVelocities } from './integrate.js';
import { sleepIslands } from './islands.js';
import { letGo } from './let-go.js';
import { prepare } from './prepare.js';
import { refreshMoved } from './refresh.js';
import { sleepKinematics } from './sleep.js';
import { easeSqueezes } from './squeezes.js';
import { store } from './store.js';

/**
 * One step: the table of contents of the engine. Collision is found once; then the step is integrated in `substeps` equal
 * parts, over which the iterations are spread (Macklin et al., "Small Steps in Physics Simulation", 2019).
 */
export function step(world: World, dt: number): void {
  const { solver, substeps, profile } = world;
  const h = dt / substeps;
  solver.substeps = substeps;
  profile?.begin();
  if (world.someLeft) letGo(world);

  // What collides, now and in the course of the step; what sleeps.
  refreshMoved(world);
  findPairs(world, dt);
  profile?.lap('pairs');
  foresee(world, dt);
  profile?.lap('foresight');
  sleepIslands(world, dt);
  profile?.lap('islands');

  // What is awake is packed into arrays, solved there, and written back.
  prepare(world, h);
  if (world.pushed.size > 0) passPushed(world);
  profile?.lap('prepare');
  profile?.count(world);
  if (solver.isIdle) {
    // Nothing is awake: nothing moves, and no arrays were lent.
    return;
  }
  integrate(world, h);
  world.jointSolver?.store(world);
  store(world);
  profile?.lap('store');

  // What went so far that it may have passed something is stopped there.
  continuous(world, dt);
  // Not earlier: impacts still ask what forces add, and their handlers may step another world.
  solver.returnArrays();
  world.events.noteWoken(world);
  sleepKinematics(world);
  profile?.lap('continuous');
}

/** The sub-steps, of length h. */
function integrate(world: World, h: number): void {
  const { solver, profile, jointSolver } = world;
  const { substeps } = solver;
  for (let substep = 0; substep < substeps; substep += 1) {
    turnContacts(solver, h);
    // Restitution is planned by the velocities before gravity, and asked for once the warm start has set the contacts up.
    planBounces(solver, h);
    integrateVelocities(solver);
    jointSolver?.warmStart(solver, substep === 0);
    // What is crushed starts with less than it had.
    easeSqueezes(solver);
    warmStartContacts(solver, h);
    applyBounces(solver);

    const iterations = share(world.velocityIterations, substep, substeps);
    // Joints are swept over in each iteration. Contacts are swept over half as often again, but not any longer once nothing changes.
    let changed = true;
    for (let i = 0; i < CONTACT_SWEEPS * iterations; i += 1) {
      const isOfJoints = i < iterations;
      if (!changed && !(isOfJoints && solver.joints.runs.length > 0)) break;
      if (isOfJoints) jointSolver?.solveVelocities(solver, i, iterations);
      changed = solveVelocityContacts(solver, h);
    }
    // What was struck in this sub-step is solved to its end.
    solveShocks(solver, jointSolver);
    profile?.lap('velocities');

    integratePositions(solver, h);
    // What bounces off gains no height by being pushed out.
    spareBounces(solver);
    const pushes = share(world.positionIterations, substep, substeps);
    let pushed = true;
    for (let i = 0; i < pushes && pushed; i += 1) {
      const pushedJoints = jointSolver?.solvePositions(solver, i, pushes) ?? false;
      pushed = solvePositionContacts(solver) || pushedJoints;
    }
    // A crowd of circles gets some iterations more.
    partCrowds(solver);
    jointSolver?.finish(solver);
    advance(solver);
    profile?.lap('positions');
  }
}

/** How many of the iterations of a step a sub-step has; at least one. */
function share(total: number, substep: number, substeps: number): number {
  return Math.max(1, Math.floor(((substep + 1) * total) / substeps) - Math.floor((substep * total) / substeps));
}
