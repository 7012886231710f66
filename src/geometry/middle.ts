import { EDGE_STRIDE } from './layout.js';
import type { Outline } from './outline.js';
import type { Swept } from './sweep.js';

/** The mean of the corners of a shape, as a point that can be swept in place of the shape. */
export class Middle implements Swept {
  shape: Swept | null = null;

  outline(into: Outline): void {
    this.shape!.outline(into);
    const { corners, count } = into;
    let x = 0;
    let y = 0;
    for (let i = 0; i < count * EDGE_STRIDE; i += EDGE_STRIDE) {
      x += corners[i]!;
      y += corners[i + 1]!;
    }
    into.setCircle(0);
    corners[0] = x / count;
    corners[1] = y / count;
  }
}
