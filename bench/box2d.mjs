// Box2D v3 behind the few functions of a phys2d device that scenes use, so that both engines are given the very same scene.
import { createDevice, MISS, PeerBody, PeerWorld } from './peer.mjs';

/** What its author recommends, in b2World_Step. */
const SUBSTEPS = 4;

let substeps = SUBSTEPS;
/** The module in use: the flavour that is loaded first is that of the process. */
let b2;
/** Definitions that are filled in anew for each body, shape and joint: their memory is never given back. */
let defs;

function createDefs() {
  const body = b2.b2DefaultBodyDef();
  const shape = b2.b2DefaultShapeDef();
  const circle = new b2.b2Circle();
  return {
    body,
    position: body.position,
    velocity: body.linearVelocity,
    shape,
    material: shape.material,
    filter: shape.filter,
    circle,
    center: circle.center,
    unturned: b2.b2MakeRot(0),
    types: {
      dynamic: b2.b2BodyType.b2_dynamicBody,
      kinematic: b2.b2BodyType.b2_kinematicBody,
      static: b2.b2BodyType.b2_staticBody,
    },
  };
}

/** Reads a vector of the engine, and gives its memory back. */
function take(vector) {
  const { x, y } = vector;
  vector.delete();
  return [x, y];
}

/** Does something with a new object of the engine, and gives its memory back. */
function withNew(object, action) {
  const result = action(object);
  object.delete();
  return result;
}

class Box2DBody extends PeerBody {
  getPosition() {
    return take(b2.b2Body_GetPosition(this.body));
  }

  getRotation() {
    return withNew(b2.b2Body_GetRotation(this.body), (rotation) => b2.b2Rot_GetAngle(rotation));
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

  setVelocity([x, y]) {
    withNew(new b2.b2Vec2(x, y), (velocity) => b2.b2Body_SetLinearVelocity(this.body, velocity));
  }

  /** For good: waking does not set its clock back, as it does in other engines, so that it would fall asleep now and then. */
  wake() {
    b2.b2Body_EnableSleep(this.body, false);
  }
}

/** Boxes by b2MakeOffsetBox: b2ComputeHull takes corners that are within its slop for one. No polygon has a radius. */
function polygonOf({ vertices, box }) {
  if (box !== null) {
    return withNew(new b2.b2Vec2(...box.middle), (middle) =>
      b2.b2MakeOffsetBox(box.halfWidth, box.halfHeight, middle, defs.unturned),
    );
  }
  return withNew(b2.b2ComputeHull(vertices.map(([x, y]) => ({ x, y }))), (hull) => {
    if (hull.count !== vertices.length) {
      throw new Error(`Box2D made a hull of ${hull.count} corners of ${vertices.length}`);
    }
    return b2.b2MakePolygon(hull, 0);
  });
}

function createShape(body, { group, mask, material, ...shape }) {
  const def = defs.shape;
  def.density = material.density;
  defs.material.friction = material.dynamicFriction;
  defs.material.restitution = material.elasticity;
  defs.filter.categoryBits = group;
  defs.filter.maskBits = mask;
  if (shape.radius !== undefined) {
    defs.center.Set(...shape.origin);
    defs.circle.radius = shape.radius;
    b2.b2CreateCircleShape(body, def, defs.circle);
  } else {
    withNew(polygonOf(shape), (polygon) => b2.b2CreatePolygonShape(body, def, polygon));
  }
}

class Box2DWorld extends PeerWorld {
  constructor({ gravity, allowSleeping }) {
    super();
    const def = b2.b2DefaultWorldDef();
    def.gravity.Set(...gravity);
    def.enableSleep = allowSleeping;
    this.world = b2.b2CreateWorld(def);
  }

  create(added, params) {
    const def = defs.body;
    def.type = defs.types[params.type];
    defs.position.Set(...params.position);
    withNew(b2.b2MakeRot(params.rotation), (rotation) => {
      def.rotation = rotation;
    });
    defs.velocity.Set(...params.velocity);
    def.angularVelocity = params.angularVelocity;
    def.linearDamping = params.linearDrag;
    def.angularDamping = params.angularDrag;
    def.isBullet = params.bullet;
    def.isAwake = !params.sleeping;
    added.body = b2.b2CreateBody(this.world, def);
    for (const shape of params.shapes) {
      createShape(added.body, shape);
    }
  }

  destroy(body) {
    b2.b2DestroyBody(body);
  }

  join({ bodyA, bodyB, anchorA, anchorB, ignoreInteractions }) {
    return withNew(b2.b2DefaultRevoluteJointDef(), (def) => {
      def.base.bodyIdA = bodyA.body;
      def.base.bodyIdB = bodyB.body;
      def.base.localFrameA.p.Set(...anchorA);
      def.base.localFrameB.p.Set(...anchorB);
      def.base.collideConnected = !ignoreInteractions;
      return b2.b2CreateRevoluteJoint(this.world, def);
    });
  }

  limit(joint, lower, upper) {
    b2.b2RevoluteJoint_SetLimits(joint, lower, upper);
    b2.b2RevoluteJoint_EnableLimit(joint, true);
  }

  brake(joint, torque) {
    b2.b2RevoluteJoint_SetMaxMotorTorque(joint, torque);
    b2.b2RevoluteJoint_EnableMotor(joint, true);
  }

  step(deltaTime) {
    b2.b2World_Step(this.world, deltaTime, substeps);
  }

  /** Rays are made before, as a program does that casts them from the same places again. */
  caster() {
    const filter = b2.b2DefaultQueryFilter();
    return {
      ray: ({ x, y, dx, dy }) => {
        const from = new b2.b2Vec2(x, y);
        const way = new b2.b2Vec2(dx, dy);
        return () =>
          withNew(b2.b2World_CastRayClosest(this.world, from, way, filter), (hit) => (hit.hit ? hit.fraction : MISS));
      },
    };
  }
}

/** Box2D as it comes, of one flavour: the factory of its module with SIMD, or with plain code. One thread in either. */
export async function box2d({ default: flavour }, steps = SUBSTEPS) {
  substeps = steps;
  b2 = await flavour();
  defs = createDefs();
  return createDevice((params) => new Box2DWorld(params), Box2DBody);
}
