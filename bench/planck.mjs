// planck behind the few functions of a phys2d device that scenes use, so that both engines are given the very same scene.
import {
  AABB,
  Box,
  Circle,
  Polygon,
  RevoluteJoint,
  ShapeCast,
  ShapeCastInput,
  ShapeCastOutput,
  Transform,
  Vec2,
  World,
} from 'planck';
import { createDevice, MISS, PeerBody, PeerWorld } from './peer.mjs';

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

  setVelocity(velocity) {
    this.body.setLinearVelocity(vec(velocity));
  }

  wake() {
    this.body.setAwake(true);
  }
}

/** Boxes as `Box`: `Polygon` takes corners that are less than 2.5 mm apart for one. */
function shapeOf({ radius, origin, vertices, box }) {
  if (radius !== undefined) {
    return new Circle(vec(origin), radius);
  }
  return box === null ? new Polygon(vertices.map(vec)) : new Box(box.halfWidth, box.halfHeight, vec(box.middle), 0);
}

class PlanckWorld extends PeerWorld {
  constructor({ gravity, allowSleeping, velocityIterations = VELOCITY_ITERATIONS }, continuousPhysics) {
    super();
    this.world = new World({ gravity: vec(gravity), allowSleep: allowSleeping, continuousPhysics });
    this.velocityIterations = velocityIterations;
  }

  create(added, params) {
    const { type, position, rotation, velocity, angularVelocity, linearDrag, angularDrag, shapes } = params;
    added.body = this.world.createBody({
      type,
      position: vec(position),
      angle: rotation,
      linearVelocity: vec(velocity),
      angularVelocity,
      linearDamping: linearDrag,
      angularDamping: angularDrag,
      bullet: params.bullet,
      awake: !params.sleeping,
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

  join({ bodyA, bodyB, anchorA, anchorB, ignoreInteractions }) {
    const anchors = { localAnchorA: vec(anchorA), localAnchorB: vec(anchorB) };
    const bodies = { bodyA: bodyA.body, bodyB: bodyB.body, collideConnected: !ignoreInteractions };
    return this.world.createJoint(new RevoluteJoint({ ...anchors, ...bodies }));
  }

  limit(joint, lower, upper) {
    joint.setLimits(lower, upper);
    joint.enableLimit(true);
  }

  brake(joint, torque) {
    joint.setMaxMotorTorque(torque);
    joint.enableMotor(true);
  }

  step(deltaTime) {
    this.world.step(deltaTime, this.velocityIterations, POSITION_ITERATIONS);
  }

  /** Its world casts no shapes: a box is cast at each fixture within the bounds of its way. */
  caster() {
    return { ray: raysIn(this.world), box: (size) => boxesIn(this.world, new Box(size / 2, size / 2)) };
  }
}

function raysIn(world) {
  const hit = { fixture: null, point: null, normal: null, fraction: MISS };
  const note = (fixture, point, normal, fraction) => {
    hit.fixture = fixture;
    hit.point = point;
    hit.normal = normal;
    hit.fraction = fraction;
    return fraction;
  };
  return ({ x, y, dx, dy }) => {
    const from = new Vec2(x, y);
    const to = new Vec2(x + dx, y + dy);
    return () => {
      hit.fraction = MISS;
      world.rayCast(from, to, note);
      return hit.fraction;
    };
  };
}

function boxesIn(world, box) {
  const input = new ShapeCastInput();
  const output = new ShapeCastOutput();
  const [atStart, atEnd, around] = [new AABB(), new AABB(), new AABB()];
  let nearest = MISS;
  const meet = (fixture) => {
    input.proxyA.set(fixture.getShape(), 0);
    input.transformA.set(fixture.getBody().getTransform());
    if (ShapeCast(output, input) && (nearest === MISS || output.lambda < nearest)) {
      nearest = output.lambda;
    }
    return true;
  };
  input.proxyB.set(box, 0);
  return ({ x, y, angle, dx, dy }) => {
    const start = new Transform(new Vec2(x, y), angle);
    const end = new Transform(new Vec2(x + dx, y + dy), angle);
    const way = new Vec2(dx, dy);
    return () => {
      box.computeAABB(atStart, start, 0);
      box.computeAABB(atEnd, end, 0);
      around.combine(atStart, atEnd);
      input.transformB.set(start);
      input.translationB.set(way);
      nearest = MISS;
      world.queryAABB(around, meet);
      return nearest;
    };
  };
}

/** planck as it comes. */
export const planck = createDevice((params) => new PlanckWorld(params, true), PlanckBody);

/** planck without continuous collision. */
export const planckDiscrete = createDevice((params) => new PlanckWorld(params, false), PlanckBody);
