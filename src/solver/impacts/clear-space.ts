import type { RigidBody } from '../../body.js';
import { CLEAR_STEPS } from '../../config.js';
import { grown, widened } from '../../math/doubles.js';
import type { World } from '../../world.js';
import { squareAround } from '../bounds.js';
import { findNearby } from '../nearby.js';

const bounds = /* @__PURE__ */ new Float64Array(4);

/** Numbers of a square: centre and half the side. */
const STRIDE = 3;

/**
 * Squares in which nothing stands still, which hold until something comes to rest anywhere. A body within its square need not be looked
 * ahead for, as if a search had found nothing. A square is searched around each awake dynamic body, and kept by the index of that body in
 * `liveDynamics`; but what is known of a square is true of the world, whichever body it was searched for.
 */
export class ClearSpace {
  /** Where something was found, half the side is minus the step in which to search again. */
  private squares: Float64Array = new Float64Array(0);
  /** Whether something came to rest somewhere since the last step, … */
  private isStale = true;
  /** … or before that, since the one before. */
  private wasStale = true;
  /** How far the body that is asked about goes in a step, m. A field, as an argument would be boxed. */
  reach = 0.5;

  /** To be called when something that stands still, or sleeps, comes to be somewhere. */
  forget(): void {
    this.isStale = true;
  }

  /** Begins a step. If something comes to rest in each, wide searches would be for nothing. */
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

  /** Searches a square around a body in which it can move for some steps. */
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
