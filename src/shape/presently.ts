import type { RigidBody } from '../body.js';
import { CIRCLE_NUMBERS, EDGE_STRIDE, EDGES } from '../geometry/layout.js';
import { instance, typeError } from '../validate.js';
import { Shape } from './shape.js';
import { POLYGON } from './shape-kind.js';

/** The body of a shape. Throws if the argument is not a shape or has no body. */
export function bodyOf(where: string, name: string, shape: Shape): RigidBody {
  const body = instance(where, name, shape, Shape, 'a Shape').owner;
  if (body === null) {
    throw typeError(where, name, 'a shape of a body', shape);
  }
  return body;
}

/**
 * Calls `ask` with a shape placed where its body is now. Within a step the shape is put back afterwards: the solver needs it where the step
 * began, or where something hit it, and a query must not change what follows.
 */
export function presently<T>(shape: Shape, ask: () => T): T {
  const body = shape.owner!;
  if (!body.owner?.stepping) {
    if (body.owner === null) {
      body.place();
    } else if (body.placeStale) {
      // Only this one: all of them stay stale until the next step or query.
      shape.place(body);
    }
    return ask();
  }
  const { numbers, at } = shape;
  const count = shape.kind === POLYGON ? EDGES + EDGE_STRIDE * shape.offsets.length : CIRCLE_NUMBERS;
  const before = numbers.slice(at, at + count);
  shape.place(body);
  const answer = ask();
  numbers.set(before, at);
  return answer;
}

/** The bounds [minX, minY, maxX, maxY] of a shape where its body is now. */
export function presentBounds(shape: Shape): Float64Array {
  const { numbers, at } = shape;
  return presently(shape, () => numbers.slice(at, at + 4));
}
