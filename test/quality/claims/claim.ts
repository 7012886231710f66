import type { Physics2DDevice, RigidBody, World } from '../../../src/index.js';

export const DT = 1 / 60;

/** m. Overlap that the solver leaves alone at a contact: CONTACT_SLOP. */
export const SLOP = 0.002;

/** m. What is deeper than the slop by less than a micrometre is not pushed any more. */
export const LEFT = SLOP + 1e-6;

/** One number that tells how good a solver is. */
export interface Figure {
  readonly what: string;
  readonly value: number;
  readonly unit: string;
  /** At most; without it the figure is only told. */
  readonly limit?: number;
}

/** A scene, and the figures it has with an engine. Only what all engines can be given is used, so that they can be compared. */
export interface Claim {
  readonly scene: string;
  measure(phys2D: Physics2DDevice): Figure[];
}

/** Steps for some seconds, and looks after each step. */
export function run(world: World, seconds: number, look: (step: number) => void = () => {}): void {
  const steps = Math.round(seconds / DT);
  for (let i = 1; i <= steps; i += 1) {
    world.step(DT);
    look(i);
  }
}

export function speedOf(body: RigidBody): number {
  const [vx, vy] = body.getVelocity();
  return Math.sqrt(vx * vx + vy * vy);
}

export function fastest(bodies: readonly RigidBody[]): number {
  return Math.max(...bodies.map(speedOf));
}

/** m/s. The root of the mean square of their speeds. */
export function meanSpeed(bodies: readonly RigidBody[]): number {
  return Math.sqrt(bodies.reduce((sum, body) => sum + speedOf(body) ** 2, 0) / bodies.length);
}

/** Remembers where bodies are. @returns how far the one that moved farthest has moved since. */
export function watch(bodies: readonly RigidBody[]): () => number {
  const from = bodies.map((body) => [...body.getPosition()]);
  return () =>
    Math.max(
      ...bodies.map((body, i) => {
        const [x, y] = body.getPosition();
        return Math.sqrt((x - from[i]![0]!) ** 2 + (y - from[i]![1]!) ** 2);
      }),
    );
}
