// matter-js behind the few functions of a phys2d device that scenes use, so that both engines are given the very same scene.
import Matter from 'matter-js';
import { createDevice, PeerBody, PeerWorld } from './peer.mjs';

const { Bodies, Body, Composite, Constraint, Engine, Sleeping, Vertices } = Matter;

/** Pixels in a metre: its default gravity of 0.001 px/ms² is 10 m/s² then, and boxes of a metre are as large as in its demos. */
const SCALE = 100;
/** Per kg/m²: its default density. */
const DENSITY = 0.001;
/** It multiplies this with the friction: its default. */
const STATIC_FACTOR = 1;
/** ms. What it counts velocities and drag in. */
const FRAME = 1000 / 60;

const px = ([x, y]) => ({ x: SCALE * x, y: SCALE * y });

function turn({ x, y }, angle) {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return { x: c * x - s * y, y: s * x + c * y };
}

class MatterBody extends PeerBody {
  /** Of its origin; the engine's is that of the centre of mass, which is at `centre` from there. */
  getPosition() {
    const { x, y } = turn(this.centre, this.body.angle);
    return [(this.body.position.x - x) / SCALE, (this.body.position.y - y) / SCALE];
  }

  getRotation() {
    return this.body.angle;
  }

  /** Of the centre of mass. */
  getVelocity() {
    const { x, y } = Body.getVelocity(this.body);
    return [(60 * x) / SCALE, (60 * y) / SCALE];
  }

  getAngularVelocity() {
    return 60 * Body.getAngularVelocity(this.body);
  }

  getMass() {
    return this.body.mass / (DENSITY * SCALE ** 2);
  }

  getInertia() {
    return this.body.inertia / (DENSITY * SCALE ** 4);
  }

  get sleeping() {
    return this.body.isSleeping;
  }

  setVelocity(velocity) {
    this.params.velocity = velocity;
    if (this.params.type === 'dynamic') {
      Body.setVelocity(this.body, { x: (SCALE * velocity[0]) / 60, y: (SCALE * velocity[1]) / 60 });
    }
  }

  wake() {
    Sleeping.set(this.body, false);
  }
}

/** A shape as a body around the origin. It has no circles, but polygons of 25 or 26 sides for them. */
function partOf({ radius, origin, vertices, material, group, mask }) {
  const options = {
    density: material.density * DENSITY,
    restitution: material.elasticity,
    friction: material.dynamicFriction,
    frictionStatic: (STATIC_FACTOR * material.staticFriction) / (material.dynamicFriction || 1),
    collisionFilter: { category: group, mask, group: 0 },
  };
  if (radius !== undefined) {
    const { x, y } = px(origin);
    return Bodies.circle(x, y, SCALE * radius, options);
  }
  const corners = vertices.map(px);
  return Body.create({ ...options, vertices: corners, position: Vertices.centre(corners) });
}

/** What has no shape, as an anchor, gets one that meets nothing. */
function bodyOf(shapes) {
  const parts = shapes.map(partOf);
  if (parts.length === 0) {
    return Bodies.circle(0, 0, SCALE, { collisionFilter: { category: 0, mask: 0, group: 0 } });
  }
  return parts.length === 1 ? parts[0] : Body.create({ parts });
}

class MatterWorld extends PeerWorld {
  constructor({ gravity: [x, y], allowSleeping }) {
    super();
    // Its unit of gravity is `scale` px/ms².
    const gravity = { x: x / 10, y: y / 10, scale: SCALE / 1e5 };
    this.engine = Engine.create({ gravity, enableSleeping: allowSleeping });
    this.kinematic = [];
  }

  create(added, params) {
    const { type, position, rotation, velocity, angularVelocity, linearDrag, angularDrag, shapes } = params;
    const body = bodyOf(shapes);
    added.body = body;
    added.centre = { ...body.position };
    const { x, y } = px(position);
    const centre = turn(added.centre, rotation);
    Body.setAngle(body, rotation);
    Body.setPosition(body, { x: x + centre.x, y: y + centre.y });
    if (type === 'dynamic') {
      added.setVelocity(velocity);
      Body.setAngularVelocity(body, angularVelocity / 60);
      body.frictionAir = Math.max(linearDrag, angularDrag) / 60;
      Sleeping.set(body, params.sleeping);
    } else {
      Body.setStatic(body, true);
    }
    if (type === 'kinematic') {
      this.kinematic.push(added);
    }
    Composite.add(this.engine.world, body);
  }

  destroy(body) {
    Composite.remove(this.engine.world, body);
  }

  join({ bodyA, bodyB, anchorA, anchorB }) {
    const point = (anchor, { body, centre }) => {
      const { x, y } = px(anchor);
      return turn({ x: x - centre.x, y: y - centre.y }, body.angle);
    };
    const points = { pointA: point(anchorA, bodyA), pointB: point(anchorB, bodyB) };
    const joint = Constraint.create({ bodyA: bodyA.body, bodyB: bodyB.body, ...points, length: 0 });
    Composite.add(this.engine.world, joint);
    return joint;
  }

  /** It has no kinematic bodies: static ones are put where they are next, so that it knows their velocity. */
  step(deltaTime) {
    for (const { body, params } of this.kinematic) {
      const [vx, vy] = params.velocity;
      const { x, y } = body.position;
      Body.setPosition(body, { x: x + SCALE * vx * deltaTime, y: y + SCALE * vy * deltaTime }, true);
      Body.setAngle(body, body.angle + params.angularVelocity * deltaTime, true);
    }
    Engine.update(this.engine, deltaTime * 60 * FRAME);
  }
}

/** matter-js as it comes: 6 position, 4 velocity and 2 constraint iterations, and pins of stiffness 0.7. */
export const matter = { ...createDevice((params) => new MatterWorld(params), MatterBody), lacksLimits: true };
