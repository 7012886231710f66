// planck behind the few functions of a phys2d device that scenes use, so that both engines are given the very same scene.
import { Circle, Polygon, RevoluteJoint, Vec2, World } from 'planck';
import * as phys2d from '../dist/phys2d.js';

/** planck's own default, and Box2D's. */
const POSITION_ITERATIONS = 3;

const vec = ([x, y]) => new Vec2(x, y);

class PlanckBody {
  constructor(params) {
    this.params = params;
    this.body = null;
  }

  getPosition() {
    const { x, y } = this.body === null ? vec(this.params.position) : this.body.getPosition();
    return [x, y];
  }

  transformLocalPointToWorld(point) {
    const { x, y } = this.body.getWorldPoint(vec(point));
    return [x, y];
  }
}

class PlanckPointConstraint {
  constructor(params) {
    this.params = params;
    this.bodyA = params.bodyA;
    this.bodyB = params.bodyB;
  }

  getAnchorA() {
    return this.params.anchorA;
  }

  getAnchorB() {
    return this.params.anchorB;
  }
}

class PlanckWorld {
  constructor({ gravity = [0, 10], allowSleeping = true, velocityIterations = 8 } = {}, continuousPhysics = true) {
    this.world = new World({ gravity: vec(gravity), allowSleep: allowSleeping, continuousPhysics });
    this.velocityIterations = velocityIterations;
    this.rigidBodies = [];
  }

  addRigidBody(added) {
    const { type = 'dynamic', position = [0, 0], rotation = 0, velocity = [0, 0], angularVelocity = 0 } = added.params;
    const { linearDrag = 0.05, angularDrag = 0.05, shapes = [] } = added.params;
    added.body = this.world.createBody({
      type,
      position: vec(position),
      angle: rotation,
      linearVelocity: vec(velocity),
      angularVelocity,
      linearDamping: linearDrag,
      angularDamping: angularDrag,
    });
    for (const { shape, material = {}, group = 1, mask = 0xffff } of shapes) {
      const { density = 1, dynamicFriction = 1, elasticity = 0 } = material;
      const filter = { filterCategoryBits: group, filterMaskBits: mask };
      added.body.createFixture({ shape, density, friction: dynamicFriction, restitution: elasticity, ...filter });
    }
    this.rigidBodies.push(added);
    return true;
  }

  addConstraint({ params: { bodyA, bodyB, anchorA, anchorB } }) {
    const anchors = { localAnchorA: vec(anchorA), localAnchorB: vec(anchorB) };
    this.world.createJoint(new RevoluteJoint({ ...anchors, bodyA: bodyA.body, bodyB: bodyB.body }));
    return true;
  }

  step(deltaTime) {
    this.world.step(deltaTime, this.velocityIterations, POSITION_ITERATIONS);
  }
}

/** planck as it comes. */
export const planck = {
  createWorld: (params) => new PlanckWorld(params),
  createRigidBody: (params) => new PlanckBody(params),
  createPointConstraint: (params) => new PlanckPointConstraint(params),
  createMaterial: (params) => params,
  createBoxVertices: phys2d.createBoxVertices,
  createRectangleVertices: phys2d.createRectangleVertices,
  createRegularPolygonVertices: phys2d.createRegularPolygonVertices,
  createCircleShape: ({ radius, origin = [0, 0], ...rest }) => ({ shape: new Circle(vec(origin), radius), ...rest }),
  createPolygonShape: ({ vertices, ...rest }) => ({ shape: new Polygon(vertices.map(vec)), ...rest }),
};

/** planck without continuous collision. */
export const planckDiscrete = { ...planck, createWorld: (params) => new PlanckWorld(params, false) };
