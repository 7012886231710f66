import type { ColorLike } from '../src/debug/index.js';

/** Places of the inks of bodies in a palette. */
export const INK = { fixed: 0, driven: 1, awake: 2, asleep: 3, bullet: 4 } as const;

export type Rgb = readonly [number, number, number];

/** What is drawn in which colours. The page has its own, in style.css. */
export interface Palette {
  readonly paper: Rgb;
  /** r, g, b of the rim and, as the fourth, how much of it fills a body: bytes, for each of `INK`. */
  readonly inks: Uint8Array;
  /** Constraints, how far they are off, contacts, details. */
  readonly joint: ColorLike;
  readonly other: ColorLike;
  readonly error: ColorLike;
  readonly contact: ColorLike;
  readonly detail: ColorLike;
}

function palette(paper: Rgb, inks: readonly (readonly [...Rgb, number])[], lines: readonly Rgb[]): Palette {
  const [joint, other, error, contact, detail] = lines.map(([r, g, b]): ColorLike => [r / 255, g / 255, b / 255, 0.75]);
  return {
    paper,
    inks: new Uint8Array(inks.flat()),
    joint: joint!,
    other: other!,
    error: error!,
    contact: contact!,
    detail: detail!,
  };
}

export const DARK = palette(
  [13, 16, 22],
  [
    [104, 114, 132, 46],
    [222, 226, 234, 40],
    [78, 201, 176, 62],
    [74, 116, 118, 40],
    [255, 255, 255, 120],
  ],
  [
    [226, 230, 238],
    [148, 158, 176],
    [255, 180, 84],
    [255, 180, 84],
    [120, 140, 180],
  ],
);

export const LIGHT = palette(
  [250, 250, 248],
  [
    [138, 146, 158, 60],
    [60, 66, 78, 40],
    [10, 138, 114, 58],
    [132, 170, 164, 46],
    [20, 24, 32, 130],
  ],
  [
    [40, 46, 58],
    [120, 128, 142],
    [202, 106, 0],
    [202, 106, 0],
    [96, 112, 150],
  ],
);
