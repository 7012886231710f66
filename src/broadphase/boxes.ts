import { BOX } from './layout.js';

// Boxes side by side in an array, each [minX, minY, maxX, maxY], by their numbers.

/**
 * 1 if a box does not overlap the box `asked`, else 0: a number, as the answers are combined without branches, see `PackedTree.cast`.
 * `asked` is an array, as numbers would be boxed in each call that is not inlined.
 */
export function misses(boxes: Float64Array, node: number, asked: Float64Array): number {
  const at = BOX * node;
  return (
    +(boxes[at]! > asked[2]!) |
    +(boxes[at + 1]! > asked[3]!) |
    +(boxes[at + 2]! < asked[0]!) |
    +(boxes[at + 3]! < asked[1]!)
  );
}

/** Half the perimeter of a box. */
export function perimeterOf(boxes: Float64Array, node: number): number {
  const at = BOX * node;
  return boxes[at + 2]! - boxes[at]! + (boxes[at + 3]! - boxes[at + 1]!);
}

/** Whether the box around two boxes has no larger perimeter than both together. Without calls, which would box their results. */
export function areBeside(boxes: Float64Array, a: number, b: number): boolean {
  const i = BOX * a;
  const j = BOX * b;
  const x = Math.max(boxes[i + 2]!, boxes[j + 2]!) - Math.min(boxes[i]!, boxes[j]!);
  const y = Math.max(boxes[i + 3]!, boxes[j + 3]!) - Math.min(boxes[i + 1]!, boxes[j + 1]!);
  const width = boxes[i + 2]! - boxes[i]! + boxes[j + 2]! - boxes[j]!;
  const height = boxes[i + 3]! - boxes[i + 1]! + boxes[j + 3]! - boxes[j + 1]!;
  return x + y <= width + height;
}
