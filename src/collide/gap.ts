import { Distance, measureDistance } from '../geometry/distance.js';
import { Outline } from '../geometry/outline.js';
import type { Shape } from '../shape/shape.js';

const outlineA = /* @__PURE__ */ new Outline();
const outlineB = /* @__PURE__ */ new Outline();
const distance = /* @__PURE__ */ new Distance();

/** The signed distance of two shapes where their bodies are now, relative to the origin of the first body. The object is reused by the next call. */
export function gapBetween(shapeA: Shape, shapeB: Shape): Distance {
  const a = shapeA.owner!;
  const b = shapeB.owner!;
  shapeA.outline(outlineA.put(0, 0, a.cos, a.sin));
  shapeB.outline(outlineB.put(b.x - a.x, b.y - a.y, b.cos, b.sin));
  measureDistance(outlineA, outlineB, distance);
  return distance;
}
