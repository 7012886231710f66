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
  shapes: [],
};
const MATERIAL = { elasticity: 0, staticFriction: 2, dynamicFriction: 1, rollingFriction: 0.005, density: 1 };
const SHAPE = { material: MATERIAL, group: 1, mask: 0xffff, origin: [0, 0] };

/** A body: parameters until it is added, then also the engine's own `body`. Each engine adds how it is read. */
export class PeerBody {
  constructor(params) {
    this.params = { ...BODY, ...params };
    this.body = null;
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
  constructor({ bodyA, bodyB, anchorA = [0, 0], anchorB = [0, 0] }) {
    this.bodyA = bodyA;
    this.bodyB = bodyB;
    this.anchorA = [...anchorA];
    this.anchorB = [...anchorB];
  }

  getAnchorA() {
    return this.anchorA;
  }

  getAnchorB() {
    return this.anchorB;
  }
}

/** A world that keeps a list of its bodies. */
export class PeerWorld {
  constructor() {
    this.rigidBodies = [];
  }

  addRigidBody(added) {
    this.create(added, added.params);
    this.rigidBodies.push(added);
    return true;
  }

  removeRigidBody(removed) {
    this.destroy(removed.body);
    this.rigidBodies = this.rigidBodies.filter((body) => body !== removed);
    return true;
  }

  addConstraint(joint) {
    this.join(joint);
    return true;
  }
}

/** Half the sides and the middle of a polygon that is a box along the axes, `null` for others: engines have shapes of their own for boxes. */
export function boxOf(vertices) {
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

/** A device of the worlds and bodies of one engine. */
export function createDevice(createWorld, Body) {
  return {
    createWorld: ({ gravity = [0, 10], allowSleeping = true, ...more } = {}) =>
      createWorld({ gravity, allowSleeping, ...more }),
    createRigidBody: (params) => new Body(params),
    createPointConstraint: (params) => new PeerPointConstraint(params),
    createMaterial: (params) => ({ ...MATERIAL, ...params }),
    createBoxVertices: phys2d.createBoxVertices,
    createRectangleVertices: phys2d.createRectangleVertices,
    createRegularPolygonVertices: phys2d.createRegularPolygonVertices,
    createCircleShape: (params) => ({ ...SHAPE, ...params }),
    createPolygonShape: ({ vertices, ...params }) => ({
      ...SHAPE,
      ...params,
      vertices: [...vertices].map(([x, y]) => [x, y]),
    }),
  };
}
