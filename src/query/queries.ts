import type { RigidBody } from '../body.js';
import type { BroadphaseHandle } from '../broadphase/broadphase.js';
import { containsPoint } from '../collide/contains.js';
import { Distance, measureDistance } from '../geometry/distance.js';
import { Outline } from '../geometry/outline.js';
import { sortFirst } from '../math/sort.js';
import type { RectLike, Vec2Like } from '../math/vectors.js';
import { presentBounds, presently } from '../shape/presently.js';
import { isOlder, type Shape } from '../shape/shape.js';
import { broadphaseBounds, isUnderWay, refreshPlaces } from '../solver/refresh.js';
import type { World } from '../world.js';

/** Scratch of `meets`: the outline that is asked about, and that of a shape. No user code runs in between. */
const own = /* @__PURE__ */ new Outline();
const other = /* @__PURE__ */ new Outline();
const distance = /* @__PURE__ */ new Distance();

/**
 * All shapes whose bounds may meet `bounds` at their present placement, sorted by id, as broadphases and copies of a world find them in
 * different orders.
 */
export function shapesNear(world: World, bounds: RectLike): Shape[] {
  refreshPlaces(world);
  if (isUnderWay(world)) {
    return shapesNearNow(world, bounds);
  }
  const found: Shape[] = [];
  world.broadphase.sample(bounds, (handle: BroadphaseHandle) => found.push(handle.data as Shape));
  sortFirst(found, found.length, isOlder);
  return found;
}

/** The same within a step: the broadphase still has all shapes where the step began. */
function shapesNearNow({ rigidBodies }: World, bounds: RectLike): Shape[] {
  const isNear = (shape: Shape): boolean => {
    const n = presently(shape, () => broadphaseBounds(shape));
    return n[0]! <= bounds[2]! && n[1]! <= bounds[3]! && n[2]! >= bounds[0]! && n[3]! >= bounds[1]!;
  };
  return rigidBodies.flatMap(({ shapes }) => shapes.filter(isNear)).sort((a, b) => a.id - b.id);
}

/** Writes results to the start of `store`. @returns how many. */
export function writeResults<T>(found: readonly T[], store: T[]): number {
  found.forEach((item, i) => {
    store[i] = item;
  });
  return found.length;
}

/** The bodies of shapes, each once, in the order of their first shapes. */
export function bodiesOf(shapes: readonly Shape[]): RigidBody[] {
  return [...new Set(shapes.map(({ owner }) => owner!))];
}

/** The shapes that contain a point, sorted by id; the boundary counts. */
export function shapesAtPoint(world: World, point: Vec2Like): Shape[] {
  const x = point[0]!;
  const y = point[1]!;
  return shapesNear(world, [x, y, x, y]).filter((shape) =>
    presently(shape, () => containsPoint(shape, x - shape.owner!.x, y - shape.owner!.y)),
  );
}

/** The shapes that intersect a disc, sorted by id; touching counts. The radius may be `Infinity`. */
export function shapesInCircle(world: World, center: Vec2Like, radius: number): Shape[] {
  const x = center[0]!;
  const y = center[1]!;
  const found = shapesNear(world, [x - radius, y - radius, x + radius, y + radius]);
  if (radius === Infinity) {
    return found;
  }
  own.setCircle(radius);
  own.corners.fill(0, 0, 2);
  return found.filter((shape) => meets(shape, x, y));
}

/** The shapes that intersect a rectangle, given by any two opposite corners, sorted by id; touching counts. */
export function shapesInRectangle(world: World, rectangle: RectLike): Shape[] {
  const bounds = [
    Math.min(rectangle[0]!, rectangle[2]!),
    Math.min(rectangle[1]!, rectangle[3]!),
    Math.max(rectangle[0]!, rectangle[2]!),
    Math.max(rectangle[1]!, rectangle[3]!),
  ];
  const isIn = (shape: Shape): boolean => {
    const { owner, numbers: n, at } = shape;
    const { x, y } = owner!;
    // The rectangle may be infinite: only the part near the shape counts.
    const minX = Math.max(bounds[0]!, n[at]! - 1);
    const minY = Math.max(bounds[1]!, n[at + 1]! - 1);
    const maxX = Math.min(bounds[2]!, n[at + 2]! + 1);
    const maxY = Math.min(bounds[3]!, n[at + 3]! + 1);
    if (minX > maxX || minY > maxY) {
      return false;
    }
    own.setRectangle(minX - x, minY - y, maxX - x, maxY - y);
    return meets(shape, x, y);
  };
  return shapesNear(world, bounds).filter((shape) => presently(shape, () => isIn(shape)));
}

/** The shapes of other bodies that intersect a shape where its body is now. */
export function shapesMeeting(world: World, shape: Shape): Shape[] {
  const body = shape.owner!;
  shape.outline(own.put(0, 0, body.cos, body.sin));
  return shapesNear(world, presentBounds(shape)).filter(
    (found) => found.owner !== body && meets(found, body.x, body.y),
  );
}

/** Whether a shape intersects the outline in `own`, which is relative to `(x, y)`; touching counts. */
function meets(shape: Shape, x: number, y: number): boolean {
  const body = shape.owner!;
  shape.outline(other.put(body.x - x, body.y - y, body.cos, body.sin));
  measureDistance(own, other, distance);
  return distance.value <= 0;
}
