// Box2D v3 behind the few functions of a phys2d device that scenes use, so that both engines are given the very same scene.
import Box2D from 'box2d3-wasm';
import { boxOf, createDevice, PeerBody, PeerWorld } from './peer.mjs';

/** What its author recommends, in b2World_Step. */
const SUBSTEPS = 4;

const b2 = await Box2D();

/** Reads a vector of the engine, and gives its memory back. */
function take(vector) {
  const { x, y } = vector;
  vector.delete();
  return [x, y];
}

/** Does something with a new vector, and gives its memory back. */
function withVec([x, y], action) {
  const vector = new b2.b2Vec2(x, y);
  const result = action(vector);
  vector.delete();
  return result;
}

class Box2DBody extends PeerBody {
  getPosition() {
    return take(b2.b2Body_GetPosition(this.body));
  }

  getRotation() {
    const rotation = b2.b2Body_GetRotation(this.body);
    const angle = b2.b2Rot_GetAngle(rotation);
    rotation.delete();
    return angle;
  }

  getVelocity() {
    return take(b2.b2Body_GetLinearVelocity(this.body));
  }

  getAngularVelocity() {
    return b2.b2Body_GetAngularVelocity(this.body);
  }

  getMass() {
    return b2.b2Body_GetMass(this.body);
  }

  getInertia() {
    return b2.b2Body_GetRotationalInertia(this.body);
  }

  get sleeping() {
    return !b2.b2Body_IsAwake(this.body);
  }
}

/** Boxes by b2MakeOffsetBox: b2ComputeHull takes corners that are within its slop for one. No polygon has a radius. */
function polygonOf(vertices) {
  const box = boxOf(vertices);
  if (box !== null) {
    return withVec(box.middle, (middle) => b2.b2MakeOffsetBox(box.halfWidth, box.halfHeight, middle, b2.b2MakeRot(0)));
  }
  const hull = b2.b2ComputeHull(vertices.map(([x, y]) => ({ x, y })));
  if (hull.count !== vertices.length) {
    throw new Error(`Box2D made a hull of ${hull.count} corners of ${vertices.length}`);
  }
  return b2.b2MakePolygon(hull, 0);
}

function circleOf({ radius, origin }) {
  const circle = new b2.b2Circle();
  circle.center.Set(...origin);
  circle.radius = radius;
  return circle;
}

class Box2DWorld extends PeerWorld {
  constructor({ gravity, allowSleeping }) {
    super();
    const def = b2.b2DefaultWorldDef();
    def.gravity.Set(...gravity);
    def.enableSleep = allowSleeping;
    this.world = b2.b2CreateWorld(def);
  }

  create(added, { type, position, rotation, velocity, angularVelocity, linearDrag, angularDrag, shapes }) {
    const def = b2.b2DefaultBodyDef();
    def.type = type === 'static' ? b2.b2BodyType.b2_staticBody : b2.b2BodyType.b2_dynamicBody;
    def.position.Set(...position);
    def.rotation = b2.b2MakeRot(rotation);
    def.linearVelocity.Set(...velocity);
    def.angularVelocity = angularVelocity;
    def.linearDamping = linearDrag;
    def.angularDamping = angularDrag;
    added.body = b2.b2CreateBody(this.world, def);
    for (const { group, mask, material, ...shape } of shapes) {
      const surface = b2.b2DefaultShapeDef();
      surface.density = material.density;
      surface.material.friction = material.dynamicFriction;
      surface.material.restitution = material.elasticity;
      surface.filter.categoryBits = group;
      surface.filter.maskBits = mask;
      if (shape.radius !== undefined) {
        b2.b2CreateCircleShape(added.body, surface, circleOf(shape));
      } else {
        b2.b2CreatePolygonShape(added.body, surface, polygonOf(shape.vertices));
      }
    }
  }

  destroy(body) {
    b2.b2DestroyBody(body);
  }

  join({ bodyA, bodyB, anchorA, anchorB }) {
    const def = b2.b2DefaultRevoluteJointDef();
    def.base.bodyIdA = bodyA.body;
    def.base.bodyIdB = bodyB.body;
    def.base.localFrameA.p.Set(...anchorA);
    def.base.localFrameB.p.Set(...anchorB);
    b2.b2CreateRevoluteJoint(this.world, def);
  }

  step(deltaTime) {
    b2.b2World_Step(this.world, deltaTime, SUBSTEPS);
  }
}

/** Box2D as it comes. */
export const box2d = createDevice((params) => new Box2DWorld(params), Box2DBody);
