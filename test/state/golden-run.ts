import { phys2D, simdKernels } from '../../src/index.js';
import { GAMES } from '../scenes/states.js';

/** Steps of a run, and how many lie between two hashes. */
const STEPS = 600;
const EVERY = 10;

/** The hashes of a scene on its way, `steps` long: what has to be the same in every engine. */
export function run(name: string, steps: number = STEPS): string[] {
  const game = GAMES[name]!(phys2D);
  const hashes: string[] = [];
  for (let i = 1; i <= steps; i += 1) {
    game.step();
    if (i % EVERY === 0) {
      hashes.push(game.world.hash());
    }
  }
  return hashes;
}

/** Of all scenes. */
export function runAll(): Record<string, string[]> {
  return Object.fromEntries(Object.keys(GAMES).map((name) => [name, run(name)]));
}

/** What solves the contacts of these scenes. */
export function kernels(): string {
  return simdKernels.isSupported() ? 'WebAssembly' : 'TypeScript';
}
