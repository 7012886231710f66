import type { RigidBody } from '../../body.js';
import { CLEAR_STEPS } from '../../config.js';
import { grown, widened } from '../../math/doubles.js';
import type { World } from '../../world.js';
import { squareAround } from '../bounds.js';
import { findNearby } from '../nearby.js';

const bounds = /* @__PURE__ */ new Float64Array(4);

/** Centre and half the side of a square. */
const STRIDE = 3;

/**
 * Squares in which nothing stands still, as long as nothing comes to stand anywhere: a body need not be looked ahead for while it goes about in one, which is as if nothing had been found.
 * One is looked for around each dynamic body that is awake, by its place among those; but what is known of it is of the world, not of the body.
 */
export class ClearSpace {
  /** A negative half is minus the step in which to look again, as something was found. */
  private squares: Float64Array = new Float64Array(0);
  /** Something came to stand somewhere since the last step, … */
  private isStale = true;
  /** … or before that, since the one before. */
  private wasStale = true;
  /** m. How far the body goes in a step that is asked about. Here, as an argument it would be boxed. */
  reach = 0.5;

  /** Something that stands still, or sleeps, comes to be somewhere. */
  forget(): void {
    this.isStale = true;
  }

  /** Begins a step. Where something comes to stand in each, a wide look would be for nothing. */
  begin(): void {
    this.wasStale = this.isStale;
    this.isStale = false;
    if (this.wasStale) {
      this.squares.fill(0);
    }
  }

  /** Whether a body that goes no farther than `reach` stays within its square. */
  holds({ liveIndex, x, y, radius }: RigidBody): boolean {
    const { squares, reach } = this;
    const at = STRIDE * liveIndex;
    return (
      at < squares.length &&
      Math.max(Math.abs(x - squares[at]!), Math.abs(y - squares[at + 1]!)) + radius + reach < squares[at + 2]!
    );
  }

  /** Looks for a square around a body in which it can go about for some steps. */
  search(world: World, { liveIndex, x, y, radius }: RigidBody): void {
    const at = STRIDE * liveIndex;
    if (at >= this.squares.length) {
      this.squares = widened(this.squares, new Float64Array(STRIDE * grown(world.liveDynamics.length)));
    }
    const { squares } = this;
    if (this.wasStale || world.timeStamp < -squares[at + 2]!) {
      return;
    }
    const half = radius + CLEAR_STEPS * this.reach;
    squareAround(x, y, half, bounds);
    squares[at] = x;
    squares[at + 1] = y;
    squares[at + 2] = findNearby(world, bounds, false) === 0 ? half : -(world.timeStamp + CLEAR_STEPS);
  }
}
