// phaser-box2d, Box2D v3 in JavaScript, behind the few functions of a phys2d device that scenes use, so that both engines are given
// the very same scene.
import {
  b2Body_EnableSleep,
  b2Body_GetAngularVelocity,
  b2Body_GetInertiaTensor,
  b2Body_GetLinearVelocity,
  b2Body_GetMass,
  b2Body_GetPosition,
  b2Body_GetRotation,
  b2Body_IsAwake,
  b2Body_SetLinearVelocity,
  b2BodyType,
  b2Circle,
  b2ComputeHull,
  b2CreateBody,
  b2CreateCircleShape,
  b2CreatePolygonShape,
  b2CreateRevoluteJoint,
  b2CreateWorld,
  b2CreateWorldArray,
  b2DefaultBodyDef,
  b2DefaultRevoluteJointDef,
  b2DefaultShapeDef,
  b2DefaultWorldDef,
  b2DestroyBody,
  b2MakeOffsetBox,
  b2MakePolygon,
  b2RevoluteJoint_EnableLimit,
  b2RevoluteJoint_EnableMotor,
  b2RevoluteJoint_SetLimits,
  b2RevoluteJoint_SetMaxMotorTorque,
  b2Rot,
  b2Vec2,
  b2World_Step,
} from 'phaser-box2d/dist/PhaserBox2D.js';
import { createDevice, PeerBody, PeerWorld } from './peer.mjs';

/** What the author of Box2D recommends, in b2World_Step. */
const SUBSTEPS = 4;

const TYPES = {
  dynamic: b2BodyType.b2_dynamicBody,
  kinematic: b2BodyType.b2_kinematicBody,
  static: b2BodyType.b2_staticBody,
};

const vec = ([x, y]) => new b2Vec2(x, y);

class PhaserBody extends PeerBody {
  getPosition() {
    const { x, y } = b2Body_GetPosition(this.body);
    return [x, y];
  }

  getRotation() {
    const { c, s } = b2Body_GetRotation(this.body);
    return Math.atan2(s, c);
  }

  getVelocity() {
    const { x, y } = b2Body_GetLinearVelocity(this.body);
    return [x, y];
  }

  getAngularVelocity() {
    return b2Body_GetAngularVelocity(this.body);
  }

  getMass() {
    return b2Body_GetMass(this.body);
  }

  getInertia() {
    return b2Body_GetInertiaTensor(this.body);
  }

  get sleeping() {
    return !b2Body_IsAwake(this.body);
  }

  setVelocity(velocity) {
    b2Body_SetLinearVelocity(this.body, vec(velocity));
  }

  /** For good: waking does not set its clock back, as it does in other engines, so that it would fall asleep now and then. */
  wake() {
    b2Body_EnableSleep(this.body, false);
  }
}

/** Boxes by b2MakeOffsetBox, as for Box2D itself. */
function polygonOf({ vertices, box }) {
  return box === null
    ? b2MakePolygon(b2ComputeHull(vertices.map(vec), vertices.length), 0)
    : b2MakeOffsetBox(box.halfWidth, box.halfHeight, vec(box.middle), 0);
}

function createShape(body, { group, mask, material, ...shape }) {
  const def = b2DefaultShapeDef();
  def.density = material.density;
  def.friction = material.dynamicFriction;
  def.restitution = material.elasticity;
  def.filter.categoryBits = group;
  def.filter.maskBits = mask;
  if (shape.radius !== undefined) {
    const circle = new b2Circle();
    circle.center = vec(shape.origin);
    circle.radius = shape.radius;
    b2CreateCircleShape(body, def, circle);
  } else {
    b2CreatePolygonShape(body, def, polygonOf(shape));
  }
}

class PhaserWorld extends PeerWorld {
  constructor({ gravity, allowSleeping }) {
    super();
    b2CreateWorldArray();
    const def = b2DefaultWorldDef();
    def.gravity = vec(gravity);
    def.enableSleep = allowSleeping;
    // As in Box2D; its own default of 10 m/s leaves nothing that bounces in most games.
    def.restitutionThreshold = 1;
    this.world = b2CreateWorld(def);
  }

  create(added, params) {
    const def = b2DefaultBodyDef();
    def.type = TYPES[params.type];
    def.position = vec(params.position);
    def.rotation = new b2Rot(Math.cos(params.rotation), Math.sin(params.rotation));
    def.linearVelocity = vec(params.velocity);
    def.angularVelocity = params.angularVelocity;
    def.linearDamping = params.linearDrag;
    def.angularDamping = params.angularDrag;
    def.isBullet = params.bullet;
    def.isAwake = !params.sleeping;
    added.body = b2CreateBody(this.world, def);
    for (const shape of params.shapes) {
      createShape(added.body, shape);
    }
  }

  destroy(body) {
    b2DestroyBody(body);
  }

  join({ bodyA, bodyB, anchorA, anchorB, ignoreInteractions }) {
    const def = b2DefaultRevoluteJointDef();
    def.bodyIdA = bodyA.body;
    def.bodyIdB = bodyB.body;
    def.localAnchorA = vec(anchorA);
    def.localAnchorB = vec(anchorB);
    def.collideConnected = !ignoreInteractions;
    return b2CreateRevoluteJoint(this.world, def);
  }

  limit(joint, lower, upper) {
    b2RevoluteJoint_SetLimits(joint, lower, upper);
    b2RevoluteJoint_EnableLimit(joint, true);
  }

  brake(joint, torque) {
    b2RevoluteJoint_SetMaxMotorTorque(joint, torque);
    b2RevoluteJoint_EnableMotor(joint, true);
  }

  step(deltaTime) {
    b2World_Step(this.world, deltaTime, SUBSTEPS);
  }
}

/** phaser-box2d as it comes, in metres, but for the speed from which things bounce. */
export const phaser = createDevice((params) => new PhaserWorld(params), PhaserBody);
