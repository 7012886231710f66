// p2-es behind the few functions of a phys2d device that scenes use, so that both engines are given the very same scene.
import p2 from 'p2-es';
import { centroidOf, createDevice, MISS, PeerBody, PeerWorld } from './peer.mjs';

const { Body, Circle, ContactMaterial, Convex, Material, Ray, RaycastResult, RevoluteConstraint, World } = p2;

const TYPES = { dynamic: Body.DYNAMIC, kinematic: Body.KINEMATIC, static: Body.STATIC };

class P2Body extends PeerBody {
  /** Of its origin; the engine's is that of the centre of mass, which is at `centre` from there. */
  getPosition() {
    const [x, y] = this.body.position;
    const [c, s] = [Math.cos(this.body.angle), Math.sin(this.body.angle)];
    const [cx, cy] = this.centre;
    return [x - c * cx + s * cy, y - s * cx - c * cy];
  }

  getRotation() {
    return this.body.angle;
  }

  /** Of the centre of mass. */
  getVelocity() {
    const [x, y] = this.body.velocity;
    return [x, y];
  }

  getAngularVelocity() {
    return this.body.angularVelocity;
  }

  getMass() {
    return this.body.mass;
  }

  getInertia() {
    return 1 / this.body.invInertia;
  }

  get sleeping() {
    return this.body.sleepState === Body.SLEEPING;
  }

  setVelocity([x, y]) {
    this.body.velocity[0] = x;
    this.body.velocity[1] = y;
  }

  wake() {
    this.body.wakeUp();
  }
}

/** Its polygons are convex ones around their centroid, counterclockwise. @returns one, where it is in its body, and its area. */
function shapeOf({ radius, origin, vertices, group, mask }) {
  const filter = { collisionGroup: group, collisionMask: mask };
  if (radius !== undefined) {
    return { shape: new Circle({ radius, ...filter }), place: origin, area: Math.PI * radius ** 2 };
  }
  const { area, centroid } = centroidOf(vertices);
  const around = vertices.map(([x, y]) => [x - centroid[0], y - centroid[1]]);
  const cross = around[0][0] * around[1][1] - around[0][1] * around[1][0];
  const shape = new Convex({ vertices: cross < 0 ? around.reverse() : around, ...filter });
  return { shape, place: centroid, area };
}

class P2World extends PeerWorld {
  constructor({ gravity, allowSleeping }) {
    super();
    this.world = new World({ gravity: [...gravity] });
    this.world.sleepMode = allowSleeping ? World.ISLAND_SLEEPING : World.NO_SLEEPING;
    this.materials = [];
  }

  /** One material for each friction and elasticity, and what comes of any two of them. */
  materialOf({ dynamicFriction, elasticity }) {
    const known = this.materials.find((it) => it.dynamicFriction === dynamicFriction && it.elasticity === elasticity);
    if (known !== undefined) {
      return known.material;
    }
    const added = { dynamicFriction, elasticity, material: new Material() };
    this.materials.push(added);
    for (const other of this.materials) {
      const friction = Math.sqrt(dynamicFriction * other.dynamicFriction);
      const restitution = Math.max(elasticity, other.elasticity);
      this.world.addContactMaterial(new ContactMaterial(added.material, other.material, { friction, restitution }));
    }
    return added.material;
  }

  create(added, params) {
    const { type, position, rotation, velocity, angularVelocity, linearDrag, angularDrag, shapes } = params;
    const isDynamic = type === 'dynamic';
    const made = shapes.map((shape) => {
      const { area, ...part } = shapeOf(shape);
      return { ...part, material: shape.material, mass: area * shape.material.density };
    });
    const mass = isDynamic ? made.reduce((sum, part) => sum + part.mass, 0) : 0;
    const moment = (axis) => made.reduce((sum, part) => sum + part.mass * part.place[axis], 0);
    const centre = isDynamic ? [moment(0) / mass, moment(1) / mass] : [0, 0];
    const [c, s] = [Math.cos(rotation), Math.sin(rotation)];
    added.centre = centre;
    added.body = new Body({
      mass,
      type: TYPES[type],
      position: [position[0] + c * centre[0] - s * centre[1], position[1] + s * centre[0] + c * centre[1]],
      angle: rotation,
      velocity: [...velocity],
      angularVelocity,
      damping: linearDrag,
      angularDamping: angularDrag,
      ccdSpeedThreshold: params.bullet ? 1 : -1,
    });
    for (const { shape, place, material } of made) {
      shape.material = this.materialOf(material);
      added.body.addShape(shape, [place[0] - centre[0], place[1] - centre[1]]);
    }
    if (isDynamic) {
      // As it comes it is that of shapes of 1 kg each: https://github.com/schteppe/p2.js, Body.updateMassProperties.
      added.body.inertia = made.reduce((sum, { shape, mass }) => {
        const [x, y] = shape.position;
        return sum + mass * (shape.computeMomentOfInertia() + x * x + y * y);
      }, 0);
      added.body.invInertia = 1 / added.body.inertia;
    }
    this.world.addBody(added.body);
    if (params.sleeping) {
      added.body.sleep();
    }
  }

  destroy(body) {
    this.world.removeBody(body);
  }

  join({ bodyA, bodyB, anchorA, anchorB, ignoreInteractions }) {
    const pivot = ([x, y], { centre }) => [x - centre[0], y - centre[1]];
    const pivots = { localPivotA: pivot(anchorA, bodyA), localPivotB: pivot(anchorB, bodyB) };
    const options = { ...pivots, collideConnected: !ignoreInteractions };
    const joint = new RevoluteConstraint(bodyA.body, bodyB.body, options);
    this.world.addConstraint(joint);
    return joint;
  }

  limit(joint, lower, upper) {
    joint.setLimits(lower, upper);
  }

  brake(joint, torque) {
    joint.motorMaxForce = torque;
    joint.motorSpeed = 0;
    joint.motorEnabled = true;
  }

  step(deltaTime) {
    this.world.step(deltaTime);
  }

  caster() {
    const result = new RaycastResult();
    return {
      ray: ({ x, y, dx, dy }) => {
        const ray = new Ray({ mode: Ray.CLOSEST, from: [x, y], to: [x + dx, y + dy] });
        return () => {
          result.reset();
          this.world.raycast(result, ray);
          return result.hasHit() ? result.fraction : MISS;
        };
      },
    };
  }
}

/** p2-es as it comes: 10 iterations, and contacts and joints of stiffness 1e6 and relaxation 4. */
export const p2es = createDevice((params) => new P2World(params), P2Body);
