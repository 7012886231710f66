import { IMPACT_DEPTH, IMPACT_SHARE } from '../config.js';
import { halfWidthOf, type Shape } from '../shape/shape.js';

/** The result of `findImpactDepth`, m; an array, so that it is not boxed. */
export const impactDepth = /* @__PURE__ */ new Float64Array(1);

/**
 * Writes to `impactDepth` how deep two shapes may overlap before it counts as an impact: `IMPACT_DEPTH`, or less if they are thin, so that
 * they cannot pass through each other.
 */
export function findImpactDepth(a: Shape, b: Shape): void {
  impactDepth[0] = Math.min(IMPACT_DEPTH, IMPACT_SHARE * (halfWidthOf(a) + halfWidthOf(b)));
}
