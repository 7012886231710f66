// planck behind the few functions of a phys2d device that scenes use, so that both engines are given the very same scene.
import { Box, Circle, Polygon, RevoluteJoint, Vec2, World } from 'planck';
import { boxOf, createDevice, PeerBody, PeerWorld } from './peer.mjs';

/** planck's own defaults, and Box2D's. */
const VELOCITY_ITERATIONS = 8;
const POSITION_ITERATIONS = 3;

const vec = ([x, y]) => new Vec2(x, y);

class PlanckBody extends PeerBody {
  getPosition() {
    const { x, y } = this.body.getPosition();
    return [x, y];
  }

  getRotation() {
    return this.body.getAngle();
  }

  getVelocity() {
    const { x, y } = this.body.getLinearVelocity();
    return [x, y];
  }

  getAngularVelocity() {
    return this.body.getAngularVelocity();
  }

  getMass() {
    return this.body.getMass();
  }

  getInertia() {
    return this.body.getInertia();
  }

  get sleeping() {
    return !this.body.isAwake();
  }
}

/** Boxes as `Box`: `Polygon` takes corners that are less than 2.5 mm apart for one. */
function shapeOf({ radius, origin, vertices }) {
  if (radius !== undefined) {
    return new Circle(vec(origin), radius);
  }
  const box = boxOf(vertices);
  return box === null ? new Polygon(vertices.map(vec)) : new Box(box.halfWidth, box.halfHeight, vec(box.middle), 0);
}

class PlanckWorld extends PeerWorld {
  constructor({ gravity, allowSleeping, velocityIterations = VELOCITY_ITERATIONS }, continuousPhysics) {
    super();
    this.world = new World({ gravity: vec(gravity), allowSleep: allowSleeping, continuousPhysics });
    this.velocityIterations = velocityIterations;
  }

  create(added, { type, position, rotation, velocity, angularVelocity, linearDrag, angularDrag, shapes }) {
    added.body = this.world.createBody({
      type,
      position: vec(position),
      angle: rotation,
      linearVelocity: vec(velocity),
      angularVelocity,
      linearDamping: linearDrag,
      angularDamping: angularDrag,
    });
    for (const shape of shapes) {
      const { density, dynamicFriction, elasticity } = shape.material;
      const filter = { filterCategoryBits: shape.group, filterMaskBits: shape.mask };
      const surface = { density, friction: dynamicFriction, restitution: elasticity };
      added.body.createFixture({ shape: shapeOf(shape), ...surface, ...filter });
    }
  }

  destroy(body) {
    this.world.destroyBody(body);
  }

  join({ bodyA, bodyB, anchorA, anchorB }) {
    const anchors = { localAnchorA: vec(anchorA), localAnchorB: vec(anchorB) };
    this.world.createJoint(new RevoluteJoint({ ...anchors, bodyA: bodyA.body, bodyB: bodyB.body }));
  }

  step(deltaTime) {
    this.world.step(deltaTime, this.velocityIterations, POSITION_ITERATIONS);
  }
}

/** planck as it comes. */
export const planck = createDevice((params) => new PlanckWorld(params, true), PlanckBody);

/** planck without continuous collision. */
export const planckDiscrete = createDevice((params) => new PlanckWorld(params, false), PlanckBody);
