import { Sweep, timeOfImpact } from '../geometry/sweep.js';
import type { NumberSink, Ray, Vec2Like } from '../math/vectors.js';
import { bodyOf, presently } from '../shape/presently.js';
import type { Shape } from '../shape/shape.js';
import { boolean, checkedRay, positive, sink, vector } from '../validate.js';
import { containsPoint } from './contains.js';
import { gapBetween } from './gap.js';
import { RayTest, rayShape } from './rays.js';

const sweep = /* @__PURE__ */ new Sweep();
const test = /* @__PURE__ */ new RayTest();

/**
 * Geometry of shapes where their bodies are now, in a world or not. Every shape must have a body. Sensors, groups and masks play no part,
 * and nothing is changed.
 */
export class CollisionUtils {
  /** Of the class, as in Turbulenz. */
  static get version(): number {
    return 1;
  }

  /** Whether a shape contains a world point; the boundary counts. */
  containsPoint(shape: Shape, point: Vec2Like): boolean {
    const where = 'CollisionUtils.containsPoint';
    const { x, y } = bodyOf(where, 'shape', shape);
    vector(where, 'point', point, 2);
    return presently(shape, () => containsPoint(shape, point[0]! - x, point[1]! - y));
  }

  /**
   * The signed distance of two shapes, m: if they overlap, minus the shortest translation that separates them. Writes the two witness
   * points, which the distance lies between, in world coordinates, and the unit axis from A to B: `witnessB = witnessA + axis · distance`.
   */
  signedDistance(shapeA: Shape, shapeB: Shape, witnessA: NumberSink, witnessB: NumberSink, axis: NumberSink): number {
    const where = 'CollisionUtils.signedDistance';
    const { x, y } = bodyOf(where, 'shapeA', shapeA);
    bodyOf(where, 'shapeB', shapeB);
    sink(where, 'witnessA', witnessA, 2);
    sink(where, 'witnessB', witnessB, 2);
    sink(where, 'axis', axis, 2);
    const distance = gapBetween(shapeA, shapeB);
    witnessA[0] = x + distance.ax;
    witnessA[1] = y + distance.ay;
    witnessB[0] = x + distance.bx;
    witnessB[1] = y + distance.by;
    axis[0] = distance.axisX + 0;
    axis[1] = distance.axisY + 0;
    return distance.value;
  }

  /** Whether two shapes intersect; touching counts. */
  intersects(shapeA: Shape, shapeB: Shape): boolean {
    const where = 'CollisionUtils.intersects';
    bodyOf(where, 'shapeA', shapeA);
    bodyOf(where, 'shapeB', shapeB);
    return gapBetween(shapeA, shapeB).value <= 0;
  }

  /**
   * The factor at which a ray hits a shape, as in `World.rayCast`; writes the unit normal there to `normal`. `undefined`, and nothing is
   * written, if it does not.
   */
  rayTest(shape: Shape, ray: Ray, normal: NumberSink, ignoreInnerSurfaces: boolean = false): number | undefined {
    const where = 'CollisionUtils.rayTest';
    const { x, y } = bodyOf(where, 'shape', shape);
    checkedRay(where, ray);
    sink(where, 'normal', normal, 2);
    boolean(where, 'ignoreInnerSurfaces', ignoreInnerSurfaces);
    test.aim(ray, ignoreInnerSurfaces);
    test.ox = ray.origin[0]! - x;
    test.oy = ray.origin[1]! - y;
    if (!presently(shape, () => rayShape(shape, test))) {
      return undefined;
    }
    normal[0] = test.nx + 0;
    normal[1] = test.ny + 0;
    return test.share;
  }

  /**
   * The time at which two shapes first touch if they move with the velocities of their bodies, s: 0 if they touch now, `undefined` if they
   * do not within `deltaTime` seconds (> 0). Writes the unit normal from A to B, and the point half-way between the surfaces at that time.
   * A shape that turns more than some three hundred times within reach of the other is given up.
   */
  sweepTest(
    shapeA: Shape,
    shapeB: Shape,
    deltaTime: number,
    point: NumberSink,
    normal: NumberSink,
  ): number | undefined {
    const where = 'CollisionUtils.sweepTest';
    const a = bodyOf(where, 'shapeA', shapeA);
    const b = bodyOf(where, 'shapeB', shapeB);
    positive(where, 'deltaTime', deltaTime);
    sink(where, 'point', point, 2);
    sink(where, 'normal', normal, 2);
    sweep.a.start(shapeA, a, a);
    sweep.b.start(shapeB, b, a);
    const time = timeOfImpact(sweep, deltaTime);
    const found = sweep.distance;
    sweep.release();
    if (time < 0) {
      return undefined;
    }
    point[0] = a.x + 0.5 * (found.ax + found.bx);
    point[1] = a.y + 0.5 * (found.ay + found.by);
    normal[0] = found.axisX + 0;
    normal[1] = found.axisY + 0;
    return time;
  }
}
