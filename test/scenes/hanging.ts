import type { Vec2 } from '../../src/index.js';

/** A row of links of one length that hang in an arc: where each is and how it is turned; it starts at (−span / 2, 0) and ends level with that. */
export interface Hanging {
  readonly span: number;
  readonly links: readonly { readonly position: Vec2; readonly rotation: number }[];
}

/** `count` links, the first sloping down by `slope` rad, the last up by as much. A row without slack could only hang under infinite tension. */
export function hang(count: number, length: number, slope: number): Hanging {
  const angles = Array.from({ length: count }, (_, i) => slope * (1 - (2 * (i + 0.5)) / count));
  const span = angles.reduce((sum, angle) => sum + length * Math.cos(angle), 0);
  let [x, y]: Vec2 = [-span / 2, 0];
  const links = angles.map((rotation) => {
    const dx = length * Math.cos(rotation);
    const dy = length * Math.sin(rotation);
    const position: Vec2 = [x + dx / 2, y + dy / 2];
    x += dx;
    y += dy;
    return { position, rotation };
  });
  return { span, links };
}
