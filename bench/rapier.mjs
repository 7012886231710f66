// Rapier behind the few functions of a phys2d device that scenes use, so that both engines are given the very same scene.
import RAPIER from '@dimforge/rapier2d-compat';
import { boxOf, createDevice, PeerBody, PeerWorld } from './peer.mjs';

await RAPIER.init();
const { ColliderDesc, JointData, RigidBodyDesc, World } = RAPIER;

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
}

/** Boxes as cuboids, others as convex polygons as they are. */
function colliderOf({ radius, origin, vertices }) {
  if (radius !== undefined) {
    return ColliderDesc.ball(radius).setTranslation(...origin);
  }
  const box = boxOf(vertices);
  return box === null
    ? ColliderDesc.convexPolyline(Float32Array.from(vertices.flat()))
    : ColliderDesc.cuboid(box.halfWidth, box.halfHeight).setTranslation(...box.middle);
}

class RapierWorld extends PeerWorld {
  constructor({ gravity, allowSleeping }) {
    super();
    this.world = new World(vec(gravity));
    this.allowSleeping = allowSleeping;
  }

  create(added, { type, position, rotation, velocity, angularVelocity, linearDrag, angularDrag, shapes }) {
    const desc = type === 'static' ? RigidBodyDesc.fixed() : RigidBodyDesc.dynamic();
    desc
      .setTranslation(...position)
      .setRotation(rotation)
      .setLinvel(...velocity)
      .setAngvel(angularVelocity)
      .setLinearDamping(linearDrag)
      .setAngularDamping(angularDrag)
      .setCanSleep(this.allowSleeping);
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

  join({ bodyA, bodyB, anchorA, anchorB }) {
    const data = JointData.revolute(vec(anchorA), vec(anchorB));
    this.world.createImpulseJoint(data, bodyA.body, bodyB.body, true);
  }

  step(deltaTime) {
    this.world.timestep = deltaTime;
    this.world.step();
  }
}

/** Rapier as it comes: 4 solver iterations. */
export const rapier = createDevice((params) => new RapierWorld(params), RapierBody);
