import { generator } from '../scenes/mixed.js';

/** Random numbers for scene number `seed`. */
export function dice(seed: number) {
  const random = generator(seed);
  const within = (from: number, to: number): number => from + (to - from) * random();
  /** The same share of numbers in every decade. */
  const scaled = (from: number, to: number): number => from * (to / from) ** random();
  return { within, scaled, pick: <T>(list: readonly T[]): T => list[Math.floor(random() * list.length)]! };
}

export type Dice = ReturnType<typeof dice>;
