// What all peers have in common: the few functions of a phys2d device that scenes use, over plain data. An engine's own file
// makes its bodies and worlds of that data.
import * as phys2d from '../dist/phys2d.js';

const BODY = {
  type: 'dynamic',
  position: [0, 0],
  rotation: 0,
  velocity: [0, 0],
  angularVelocity: 0,
  linearDrag: 0.05,
  angularDrag: 0.05,
  bullet: false,
  sleeping: false,
  shapes: [],
};
const MATERIAL = { elasticity: 0, staticFriction: 2, dynamicFriction: 1, rollingFriction: 0.005, density: 1 };
const SHAPE = { material: MATERIAL, group: 1, mask: 0xffff, origin: [0, 0] };

/** What a cast that hits nothing returns instead of the factor of its hit. */
export const MISS = -1;

/** A body: parameters until it is added, then also the engine's own `body`. Each engine adds how it is read, moved and woken. */
export class PeerBody {
  constructor(params) {
    this.params = { ...BODY, ...params };
    this.body = null;
    /** Point joints of which it is the second body. */
    this.joints = [];
  }

  isStatic() {
    return this.params.type === 'static';
  }

  transformLocalPointToWorld([x, y]) {
    const [px, py] = this.getPosition();
    const angle = this.getRotation();
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    return [px + c * x - s * y, py + s * x + c * y];
  }
}

class PeerPointConstraint {
  constructor({ bodyA, bodyB, anchorA = [0, 0], anchorB = [0, 0], ignoreInteractions = false }) {
    this.bodyA = bodyA;
    this.bodyB = bodyB;
    this.anchorA = [...anchorA];
    this.anchorB = [...anchorB];
    this.ignoreInteractions = ignoreInteractions;
    /** The engine's own, once it is added. */
    this.joint = null;
  }

  getAnchorA() {
    return this.anchorA;
  }

  getAnchorB() {
    return this.anchorB;
  }

  addTo(world) {
    this.joint = world.join(this);
    this.bodyB.joints.push(this);
  }
}

/** What turns about a point joint: engines have that as a property of the joint, so it is added after it. */
class PeerTurn {
  constructor({ bodyA, bodyB }, apply) {
    this.bodyA = bodyA;
    this.bodyB = bodyB;
    this.apply = apply;
  }

  addTo(world) {
    const found = this.bodyB.joints.find(({ bodyA }) => bodyA === this.bodyA);
    if (found === undefined) {
      throw new Error('bench: an angle or motor constraint needs a point constraint of the same bodies');
    }
    this.apply(world, found.joint);
  }
}

/** A world that keeps its bodies. */
export class PeerWorld {
  constructor() {
    this.bodies = new Set();
  }

  get rigidBodies() {
    return [...this.bodies];
  }

  addRigidBody(added) {
    this.create(added, added.params);
    this.bodies.add(added);
    return true;
  }

  removeRigidBody(removed) {
    this.destroy(removed.body);
    this.bodies.delete(removed);
    return true;
  }

  addConstraint(added) {
    added.addTo(this);
    return true;
  }

  /** Keeps the angle of a joint in a range. An engine without limits leaves it free. */
  limit() {}

  /** Brakes the turning of a joint with a torque. An engine without that does not. */
  brake() {}
}

/** Half the sides and the middle of a polygon that is a box along the axes, `null` for others: engines have shapes of their own for boxes. */
function boxOf(vertices) {
  const [xs, ys] = [0, 1].map((axis) => vertices.map((vertex) => vertex[axis]));
  const [left, right, top, bottom] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const isCorner = ([x, y]) => (x === left || x === right) && (y === top || y === bottom);
  return vertices.length === 4 && vertices.every(isCorner)
    ? {
        halfWidth: (right - left) / 2,
        halfHeight: (bottom - top) / 2,
        middle: [(left + right) / 2, (top + bottom) / 2],
      }
    : null;
}

/** The centroid and the area of a polygon. */
export function centroidOf(vertices) {
  const [ox, oy] = vertices[0];
  let [sum, x, y] = [0, 0, 0];
  for (const [i, [ax, ay]] of vertices.entries()) {
    const [bx, by] = vertices[(i + 1) % vertices.length];
    const cross = (ax - ox) * (by - oy) - (ay - oy) * (bx - ox);
    sum += cross;
    x += cross * (ax + bx - 2 * ox);
    y += cross * (ay + by - 2 * oy);
  }
  return { area: Math.abs(sum) / 2, centroid: [ox + x / (3 * sum), oy + y / (3 * sum)] };
}

/** What adapters make polygons of: reckoned when the shape is described, so that adding a body costs what it costs the engine. */
function outlineOf(vertices) {
  return { vertices, box: boxOf(vertices) };
}

/** A device of the worlds and bodies of one engine. */
export function createDevice(createWorld, Body) {
  return {
    isPeer: true,
    createWorld: ({ gravity = [0, 10], allowSleeping = true, ...more } = {}) =>
      createWorld({ gravity, allowSleeping, ...more }),
    createRigidBody: (params) => new Body(params),
    createPointConstraint: (params) => new PeerPointConstraint(params),
    createAngleConstraint: ({ lowerBound, upperBound, ...bodies }) =>
      new PeerTurn(bodies, (world, joint) => world.limit(joint, lowerBound, upperBound)),
    createMotorConstraint: ({ maxForce, ...bodies }) =>
      new PeerTurn(bodies, (world, joint) => world.brake(joint, maxForce)),
    createMaterial: (params) => ({ ...MATERIAL, ...params }),
    createBoxVertices: phys2d.createBoxVertices,
    createRectangleVertices: phys2d.createRectangleVertices,
    createRegularPolygonVertices: phys2d.createRegularPolygonVertices,
    createCircleShape: (params) => ({ ...SHAPE, ...params }),
    createPolygonShape: ({ vertices, ...params }) => ({
      ...SHAPE,
      ...params,
      ...outlineOf([...vertices].map(([x, y]) => [x, y])),
    }),
  };
}
