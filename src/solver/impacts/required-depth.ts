import {
  FORESIGHT_DEPTH,
  IMPACT_DEPTH,
  IMPACT_LEAST,
  IMPACT_SHARE_SMALL,
  IMPACT_SHARE_THIN,
  IMPACT_TURN,
  JOINT_PATIENCE,
  TOUCH_DEPTH,
} from '../../config.js';
import { PRE_SOLVE } from '../../listeners.js';
import { mixElasticity } from '../../material.js';
import { halfWidthOf, type Shape } from '../../shape/shape.js';
import { CIRCLE } from '../../shape/shape-kind.js';
import { findImpactDepth, impactDepth } from '../impact-depth.js';
import { isInTrain } from '../ties.js';
import type { Mover, Movers } from './movers.js';

// How deep shapes that meet in a step have to overlap for an impact: what gets less deep is left to contacts.

/**
 * The result of `findRequiredDepth`: how far two shapes turn relative to each other in the step, rad (circles do not), how deep they have to get,
 * m, and whether they are in a train. Scratch.
 */
export const required = { turn: 0.5, depth: 0.5, isInTrain: false };

/**
 * Finds how deep two shapes have to get for an impact, to `required`.
 * - Less deep where the meeting is foreseen.
 * - No deeper than a share of the thinner one where the solver does not see the pair, or it is never foreseen: that shape would slip into
 * the end of a thick one, which would then push it along instead of out, or between two. Not if they turn fast: they would be stopped again
 * and again.
 * - Less deep for small shapes that land on each other, rather than slide over from another ground, as they would be seen to sink in.
 * - Deeper for bodies with joints, as stopping one of them alone opens its joints.
 */
export function findRequiredDepth(movers: Movers, a: Shape, b: Shape, isNew: boolean, lands: boolean): void {
  const one = movers.of(a.owner!);
  const two = movers.of(b.owner!);
  findImpactDepth(a, b);
  required.turn = (a.isRound() ? 0 : one.spin) + (b.isRound() ? 0 : two.spin);
  // Putting one back alone would open joints to bodies that may move. What only hangs on static bodies, as a flipper, stays on its way.
  required.isInTrain = isInTrain(a.owner!) || isInTrain(b.owner!);
  const thinner = Math.min(halfWidthOf(a), halfWidthOf(b));
  let depth = Math.min(movers.ahead > 0 ? FORESIGHT_DEPTH : IMPACT_DEPTH, impactDepth[0]!);
  if (required.turn < IMPACT_TURN && (isNew || !mayBeForeseen(a, b))) {
    depth = Math.min(depth, IMPACT_SHARE_THIN * thinner);
  }
  if (lands && !required.isInTrain) {
    depth = Math.min(depth, Math.max(IMPACT_LEAST, IMPACT_SHARE_SMALL * thinner));
  }
  required.depth = required.isInTrain ? JOINT_PATIENCE * depth : depth;
}

/**
 * Lessens the required depth for what comes from outside, has no joints and is never foreseen: it would graze a corner, or pass a gap that
 * is too narrow for it. But it stays at what sliding shapes get into seams of tiles, and corners as they turn. Two circles cannot slide
 * over each other without being found first.
 */
export function lessenRequiredDepth(a: Shape, b: Shape, one: Mover, two: Mover): void {
  if (!required.isInTrain && !mayBeForeseen(a, b)) {
    const graze = a.kind === CIRCLE && b.kind === CIRCLE ? TOUCH_DEPTH : FORESIGHT_DEPTH;
    required.depth = Math.min(required.depth, graze + dip(a, one) + dip(b, two));
  }
}

/** How much deeper the corners of a shape may get than its sides, as far as it turns, m. */
function dip(shape: Shape, { body, spin }: Mover): number {
  return shape.isRound() ? 0 : Math.min(spin * body.radius, body.radius - halfWidthOf(shape));
}

/** Whether a meeting of two shapes may be foreseen: not if they bounce, or handlers are asked about it. */
function mayBeForeseen(a: Shape, b: Shape): boolean {
  return !mayBeRefused(a, b) && !areElastic(a, b);
}

/** Whether handlers are asked when two shapes meet, and may refuse the contact. */
export function mayBeRefused(a: Shape, b: Shape): boolean {
  return ((a.listeners.types | b.listeners.types) & PRE_SOLVE) !== 0;
}

/** Whether two shapes that meet bounce, as their materials say. */
export function areElastic(a: Shape, b: Shape): boolean {
  return mixElasticity(a.material.elasticity, b.material.elasticity) > 0;
}
