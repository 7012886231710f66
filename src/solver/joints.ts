import type { World } from '../world.js';
import {
  finishBlock,
  lineariseBlock,
  packBlock,
  pushBlock,
  solveVelocityBlock,
  storeBlock,
  warmStartBlock,
} from './block-joints.js';
import type { SolverData } from './data.js';
import { type Joint, type JointData, POINT, packHead, ROW } from './joint-data.js';
import { orderJoints } from './joint-order.js';
import {
  finishPoints,
  packPoint,
  pushPoints,
  solveVelocityPoints,
  storePoint,
  warmStartPoints,
} from './point-joints.js';
import { pushRows, solveVelocityRows } from './row-joints.js';

/** Packs the live constraints for sub-steps of length h. */
export function packJoints(world: World, h: number): void {
  const data = world.solver;
  const { joints } = data;
  if (world.jointsStale) {
    world.jointsStale = false;
    orderJoints(world);
  }
  joints.h = h;
  joints.parts = world.substeps;
  for (const joint of joints.joints) {
    if (joint.kernel === POINT) {
      packPoint(data, joint);
    } else {
      packHead(joints, joint);
      packBlock(data, joint);
    }
    joint.constraint.fresh = false;
  }
}

/** Starts a sub-step. */
export function warmStartJoints(data: SolverData, isFirst: boolean): void {
  const { runs, joints } = data.joints;
  data.joints.sweeps = 1;
  for (const { kernel, start, end } of runs) {
    if (kernel === POINT) {
      warmStartPoints(data, start, end);
    } else {
      for (let k = start; k < end; k += 1) {
        warmStartBlock(data, joints[k]!, isFirst);
      }
    }
  }
}

/** One velocity iteration: one or more sweeps. Callbacks are called in the first alone. */
export function solveVelocityJoints(data: SolverData): void {
  const { runs, joints, sweeps } = data.joints;
  for (let sweep = 0; sweep < sweeps; sweep += 1) {
    for (const { kernel, start, end } of runs) {
      if (kernel === POINT) {
        solveVelocityPoints(data, start, end);
      } else if (kernel === ROW) {
        solveVelocityRows(data, start, end);
      } else {
        for (let k = start; k < end; k += 1) {
          if (isDue(joints[k]!, sweep)) {
            solveVelocityBlock(data, joints[k]!);
          }
        }
      }
    }
  }
}

/** @returns whether it is worth another iteration. */
export function solvePositionJoints(data: SolverData): boolean {
  const { runs, joints, sweeps } = data.joints;
  let found = false;
  for (const { kernel, start, end } of runs) {
    for (let k = start; k < end && kernel !== POINT; k += 1) {
      found = lineariseBlock(data, joints[k]!) || found;
    }
  }
  for (let sweep = 0; sweep < sweeps; sweep += 1) {
    for (const { kernel, start, end } of runs) {
      if (kernel === POINT) {
        found = pushPoints(data, start, end) || found;
      } else if (kernel === ROW) {
        pushRows(data, start, end);
      } else {
        for (let k = start; k < end; k += 1) {
          if (isDue(joints[k]!, sweep)) {
            pushBlock(data, joints[k]!);
          }
        }
      }
    }
  }
  return found;
}

function isDue(joint: Joint, sweep: number): boolean {
  return sweep === 0 || joint.constraint.type !== 'CUSTOM';
}

/** Ends a sub-step. */
export function finishJoints(data: SolverData): void {
  const { runs, joints } = data.joints;
  for (const { kernel, start, end } of runs) {
    if (kernel === POINT) {
      finishPoints(data, start, end);
    } else {
      for (let k = start; k < end; k += 1) {
        finishBlock(data, joints[k]!);
      }
    }
  }
}

/** Writes the outcome of the step back to the constraints; those that broke leave. */
export function storeJoints(world: World): void {
  const data = world.solver;
  const { joints } = data;
  for (const joint of joints.joints) {
    if (joint.kernel === POINT) {
      storePoint(data, joint);
    } else {
      storeBlock(data, joint);
    }
  }
  breakJoints(world, joints);
}

function breakJoints(world: World, joints: JointData): void {
  for (const { constraint } of joints.broken) {
    world.breakConstraint(constraint);
  }
  joints.broken.length = 0;
}
