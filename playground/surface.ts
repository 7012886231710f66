import type { DebugGraphicsDevice } from '../src/debug/index.js';
import type { RigidBody, Vec2, World } from '../src/index.js';
import type { FixedStepRunner } from '../src/runner.js';
import { INK, type Rgb } from './theme.js';

/** What bodies are drawn of, and how. */
export interface Frame {
  readonly world: World;
  readonly runner: FixedStepRunner;
  /** As of `DebugLines`. */
  readonly mapping: readonly [number, number, number, number];
  /** px per m, and px of the rims. */
  readonly scale: number;
  readonly rim: number;
  /** Four bytes for each of `INK`. */
  readonly inks: Uint8Array;
  /** Between the last two steps. */
  readonly smooth: boolean;
}

/** What the picture is drawn on. */
export interface Surface {
  /** For the debug drawing. */
  readonly device: DebugGraphicsDevice;
  isLost(): boolean;
  clear(paper: Rgb): void;
  /** Draws the shapes of all bodies, filled, with a rim. */
  drawBodies(frame: Frame): void;
}

/** Whether a body is asleep, static, … decides on its ink. */
export function inkOf(body: RigidBody): number {
  if (body.isStatic()) {
    return INK.fixed;
  }
  if (body.isKinematic()) {
    return INK.driven;
  }
  return body.sleeping ? INK.asleep : body.bullet ? INK.bullet : INK.awake;
}

/** How much of its fill a body gets: more, the denser it is, and a little of difference between neighbours. */
export function strengthOf(body: RigidBody, index: number): number {
  const density = body.shapes[0]?.getMaterial().getDensity() ?? 1;
  const dice = (Math.imul(index + 1, 0x9e3779b1) >>> 24) / 255 - 0.5;
  return Math.min(3, Math.max(0.3, Math.sqrt(density))) * (1 + 0.36 * dice);
}

/** Writes where a body is to be drawn. @returns its angle. */
export function poseOf(body: RigidBody, { runner, smooth }: Frame, position: Vec2): number {
  if (smooth && !body.isStatic()) {
    runner.getPosition(body, position);
    return runner.getRotation(body);
  }
  body.getPosition(position);
  return body.getRotation();
}
