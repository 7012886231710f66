import type { RigidBody } from '../body.js';
import { ANGLE, writePose, X, Y } from '../body-pose.js';
import { cosSin } from '../math/trig.js';
import type { Circle } from '../shape/circle.js';
import type { Polygon } from '../shape/polygon.js';
import type { Shape } from '../shape/shape.js';
import { addCircle } from './curves.js';
import type { Physics2DDebugDraw } from './draw.js';
import type { Color } from './settings.js';

/** Colours of a kind of body: collider and sensor, awake and asleep. */
interface ShapeColors {
  readonly collider: Color;
  readonly sensor: Color;
  readonly sleepingCollider: Color;
  readonly sleepingSensor: Color;
}

const STATIC: ShapeColors = {
  collider: [1, 0.5, 0.5, 1],
  sensor: [0.9, 0.7, 0.7, 0.6],
  sleepingCollider: [1, 0.5, 0.5, 1],
  sleepingSensor: [0.9, 0.7, 0.7, 0.6],
};
const KINEMATIC: ShapeColors = {
  collider: [0.8, 0.3, 0.8, 1],
  sensor: [0.8, 0.4, 0.8, 0.6],
  sleepingCollider: [0.8, 0.4, 0.8, 0.5],
  sleepingSensor: [0.8, 0.5, 0.8, 0.4],
};
const DYNAMIC: ShapeColors = {
  collider: [0.5, 1, 0.5, 1],
  sensor: [0.7, 0.9, 0.7, 0.6],
  sleepingCollider: [0.5, 1, 0.5, 0.5],
  sleepingSensor: [0.7, 0.9, 0.7, 0.4],
};
const BULLET: ShapeColors = { ...DYNAMIC, collider: [1, 1, 1, 1] };

/** Scratch: the pose of the body in the picture; its angle with cosine and sine; the origin of a circle; the box around a shape. */
const pose = /* @__PURE__ */ new Float64Array(3);
const turn = /* @__PURE__ */ new Float64Array(3);
const origin = /* @__PURE__ */ new Float64Array(2);
const box = /* @__PURE__ */ new Float64Array(4);

export function addRigidBody(debug: Physics2DDebugDraw, body: RigidBody): void {
  writePose(body, debug.interpolation, pose);
  turn[0] = pose[ANGLE]!;
  cosSin(turn);
  const colors = colorsOf(body);
  for (const shape of body.shapes) {
    if (shape.sensor ? debug.showSensorShapes : debug.showColliderShapes) {
      debug.lines.setColor(colorOf(colors, shape.sensor, body.sleeping));
      addShape(debug, shape, !body.isStatic());
    }
  }
  if (debug.showBodyDetail) {
    addBodyDetail(debug, body);
  }
}

function colorsOf(body: RigidBody): ShapeColors {
  if (body.isStatic()) {
    return STATIC;
  }
  if (body.isKinematic()) {
    return KINEMATIC;
  }
  return body.bullet && isFast(body) ? BULLET : DYNAMIC;
}

/**
 * Whether a body moved by more than half its size in its last step, or turned by more than can be neglected, so that it may have met
 * something on its way.
 */
function isFast({ lastDx, lastDy, lastTurn, radius }: RigidBody): boolean {
  return 4 * (lastDx * lastDx + lastDy * lastDy) > radius * radius || Math.abs(lastTurn) > 0.05;
}

function colorOf(colors: ShapeColors, sensor: boolean, sleeping: boolean): Color {
  if (sensor) {
    return sleeping ? colors.sleepingSensor : colors.sensor;
  }
  return sleeping ? colors.sleepingCollider : colors.collider;
}

function addShape(debug: Physics2DDebugDraw, shape: Shape, ticked: boolean): void {
  if (shape.type === 'CIRCLE') {
    addCircleShape(debug, shape, ticked);
  } else {
    addPolygonShape(debug, shape);
  }
}

/** Adds a circle, with a tick along the x-axis of the body that shows how it turns. */
function addCircleShape(debug: Physics2DDebugDraw, circle: Circle, ticked: boolean): void {
  const cos = turn[1]!;
  const sin = turn[2]!;
  const radius = circle.getRadius();
  circle.getOrigin(origin);
  const x = pose[X]! + cos * origin[0]! - sin * origin[1]!;
  const y = pose[Y]! + sin * origin[0]! + cos * origin[1]!;
  addCircle(debug, x, y, radius);
  if (ticked) {
    const third = radius / 3;
    debug.lines.add(x + third * cos, y + third * sin, x + radius * cos, y + radius * sin);
  }
  if (debug.showShapeDetail) {
    debug.lines.setColor(debug.shapeDetailColor);
    addRectangle(debug, x - radius, y - radius, x + radius, y + radius);
    addCircle(debug, x, y, debug.circleOriginRadius * debug.screenToPhysics2D);
  }
}

function addPolygonShape(debug: Physics2DDebugDraw, polygon: Polygon): void {
  const { vertices } = polygon;
  const cos = turn[1]!;
  const sin = turn[2]!;
  const { lines } = debug;
  const { next } = lines;
  box.fill(Infinity, 0, 2);
  box.fill(-Infinity, 2);
  for (let i = -2; i < vertices.length; i += 2) {
    const at = i < 0 ? vertices.length - 2 : i;
    const x = pose[X]! + cos * vertices[at]! - sin * vertices[at + 1]!;
    const y = pose[Y]! + sin * vertices[at]! + cos * vertices[at + 1]!;
    if (i < 0) {
      lines.moveTo(x, y);
    } else {
      next[0] = x;
      next[1] = y;
      lines.lineToNext();
    }
    box[0] = Math.min(box[0]!, x);
    box[1] = Math.min(box[1]!, y);
    box[2] = Math.max(box[2]!, x);
    box[3] = Math.max(box[3]!, y);
  }
  if (debug.showShapeDetail) {
    debug.lines.setColor(debug.shapeDetailColor);
    addRectangle(debug, box[0]!, box[1]!, box[2]!, box[3]!);
  }
}

export function addRectangle(debug: Physics2DDebugDraw, x1: number, y1: number, x2: number, y2: number): void {
  const { lines } = debug;
  lines.add(x1, y1, x2, y1);
  lines.add(x2, y1, x2, y2);
  lines.add(x2, y2, x1, y2);
  lines.add(x1, y2, x1, y1);
}

function addBodyDetail(debug: Physics2DDebugDraw, body: RigidBody): void {
  const x = pose[X]!;
  const y = pose[Y]!;
  debug.lines.setColor(debug.bodyDetailColor);
  addCircle(debug, x, y, debug.bodyPositionRadius * debug.screenToPhysics2D);
  writePose(body, 0, pose);
  debug.lines.add(pose[X]!, pose[Y]!, x, y);
}
