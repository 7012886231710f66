import { PRESSED_PUSH, PRESSED_SHARE } from '../../config.js';

/**
 * Bounds by how much a position iteration pushes a point of bodies that move and press on each other, see PRESSED_PUSH: from `e`, negative,
 * as is the overlap of the point now, `c`, and as it began the sub-step, all beyond the slop.
 */
export function boundPush(e: number, c: number, began: number): number {
  const share = PRESSED_SHARE * began;
  const left = c - began + (share < -PRESSED_PUSH ? share : -PRESSED_PUSH);
  const most = left < 0 ? left : 0;
  return e < most ? most : e;
}
