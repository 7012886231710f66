// Rapier behind the few functions of a phys2d device that scenes use, so that both engines are given the very same scene.
import { createDevice, MISS, PeerBody, PeerWorld } from './peer.mjs';

/** The module in use: the flavour that is loaded first is that of the process. */
let RAPIER;

const vec = ([x, y]) => ({ x, y });

class RapierBody extends PeerBody {
  getPosition() {
    const { x, y } = this.body.translation();
    return [x, y];
  }

  getRotation() {
    return this.body.rotation();
  }

  getVelocity() {
    const { x, y } = this.body.linvel();
    return [x, y];
  }

  getAngularVelocity() {
    return this.body.angvel();
  }

  getMass() {
    return this.body.mass();
  }

  getInertia() {
    return this.body.principalInertia();
  }

  get sleeping() {
    return this.body.isSleeping();
  }

  setVelocity(velocity) {
    this.body.setLinvel(vec(velocity), true);
  }

  wake() {
    this.body.wakeUp();
  }
}

function descOf(type) {
  const { RigidBodyDesc } = RAPIER;
  if (type === 'static') {
    return RigidBodyDesc.fixed();
  }
  return type === 'kinematic' ? RigidBodyDesc.kinematicVelocityBased() : RigidBodyDesc.dynamic();
}

/** Boxes as cuboids, others as convex polygons as they are. */
function colliderOf({ radius, origin, vertices, box }) {
  const { ColliderDesc } = RAPIER;
  if (radius !== undefined) {
    return ColliderDesc.ball(radius).setTranslation(...origin);
  }
  return box === null
    ? ColliderDesc.convexPolyline(Float32Array.from(vertices.flat()))
    : ColliderDesc.cuboid(box.halfWidth, box.halfHeight).setTranslation(...box.middle);
}

class RapierWorld extends PeerWorld {
  constructor({ gravity, allowSleeping }) {
    super();
    this.world = new RAPIER.World(vec(gravity));
    this.allowSleeping = allowSleeping;
  }

  create(added, params) {
    const { type, position, rotation, velocity, angularVelocity, linearDrag, angularDrag, shapes } = params;
    const desc = descOf(type)
      .setTranslation(...position)
      .setRotation(rotation)
      .setLinvel(...velocity)
      .setAngvel(angularVelocity)
      .setLinearDamping(linearDrag)
      .setAngularDamping(angularDrag)
      .setCanSleep(this.allowSleeping)
      .setSleeping(params.sleeping)
      .setCcdEnabled(params.bullet);
    added.body = this.world.createRigidBody(desc);
    for (const shape of shapes) {
      const { density, dynamicFriction, elasticity } = shape.material;
      const collider = colliderOf(shape)
        .setDensity(density)
        .setFriction(dynamicFriction)
        .setRestitution(elasticity)
        .setCollisionGroups(((shape.group << 16) | (shape.mask & 0xffff)) >>> 0);
      this.world.createCollider(collider, added.body);
    }
  }

  destroy(body) {
    this.world.removeRigidBody(body);
  }

  join({ bodyA, bodyB, anchorA, anchorB, ignoreInteractions }) {
    const data = RAPIER.JointData.revolute(vec(anchorA), vec(anchorB));
    const joint = this.world.createImpulseJoint(data, bodyA.body, bodyB.body, true);
    joint.setContactsEnabled(!ignoreInteractions);
    return joint;
  }

  limit(joint, lower, upper) {
    joint.setLimits(lower, upper);
  }

  /** Viscous, as not both flavours can limit the torque of a motor. */
  brake(joint, torque) {
    joint.configureMotorModel(RAPIER.MotorModel.ForceBased);
    joint.configureMotorVelocity(0, torque);
  }

  step(deltaTime) {
    this.world.timestep = deltaTime;
    this.world.step();
  }

  snapshot() {
    return this.world.takeSnapshot();
  }

  /** Makes a new world: the bodies that there are do not belong to it. */
  restore(snapshot) {
    this.world.free();
    this.world = RAPIER.World.restoreSnapshot(snapshot);
  }

  caster() {
    const { Cuboid, Ray } = RAPIER;
    const { world } = this;
    return {
      ray({ x, y, dx, dy }) {
        const ray = new Ray({ x, y }, { x: dx, y: dy });
        return () => world.castRayAndGetNormal(ray, 1, false)?.timeOfImpact ?? MISS;
      },
      box(size) {
        const box = new Cuboid(size / 2, size / 2);
        return ({ x, y, angle, dx, dy }) => {
          const position = { x, y };
          const velocity = { x: dx, y: dy };
          return () => world.castShape(position, angle, velocity, box, 0, 1, true)?.time_of_impact ?? MISS;
        };
      },
    };
  }
}

/** Rapier as it comes, 4 solver iterations, of one flavour: its module with plain code, or with SIMD. */
export async function rapier({ default: flavour }) {
  RAPIER = flavour;
  await RAPIER.init();
  return createDevice((params) => new RapierWorld(params), RapierBody);
}
