// Each engine behind two functions, `ray` and `box`, which prepare a cast: what they return casts it, and returns the factor of the
// nearest hit, from 0 to 1, or −1. Nothing moves in the worlds, and nothing sleeps.
import { BOX_SIDE } from './casts-scene.mjs';

const NONE = -1;
const DT = 1 / 60;
const STEPS = 10;

export const casters = { phys2d: castInPhys2d, planck: castInPlanck, Rapier: castInRapier };

/** A few steps, so that every engine has its trees in order. */
function settle(step) {
  for (let i = 0; i < STEPS; i += 1) {
    step();
  }
}

async function castInPhys2d(bodies) {
  const { phys2D } = await import('../dist/phys2d.js');
  const world = phys2D.createWorld({ gravity: [0, 0], allowSleeping: false });
  const polygon = (vertices) => phys2D.createPolygonShape({ vertices });
  const shapes = {
    circle: ({ radius }) => phys2D.createCircleShape({ radius }),
    box: ({ width, height }) => polygon(phys2D.createBoxVertices(width, height)),
    polygon: ({ vertices }) => polygon(vertices),
  };
  for (const { x, y, angle, shape, isStatic } of bodies) {
    const type = isStatic ? 'static' : 'dynamic';
    const params = { type, position: [x, y], rotation: angle, shapes: [shapes[shape.kind](shape)] };
    world.addRigidBody(phys2D.createRigidBody(params));
  }
  settle(() => world.step(DT));
  const box = shapes.box({ width: BOX_SIDE, height: BOX_SIDE });
  const caster = phys2D.createRigidBody({ shapes: [box] });
  return {
    ray({ x, y, dx, dy }) {
      const ray = { origin: [x, y], direction: [dx, dy], maxFactor: 1 };
      return () => world.rayCast(ray)?.factor ?? NONE;
    },
    box({ x, y, angle, dx, dy }) {
      const start = { position: [x, y], velocity: [dx, dy] };
      return () => {
        caster.setPosition(start.position);
        caster.setRotation(angle);
        caster.setVelocity(start.velocity);
        return world.convexCast(box, 1)?.factor ?? NONE;
      };
    },
  };
}

async function castInPlanck(bodies) {
  const lib = await import('planck');
  const { Box, Circle, Polygon, Vec2, World } = lib;
  const world = new World({ gravity: new Vec2(0, 0), allowSleep: false });
  const shapes = {
    circle: ({ radius }) => new Circle(radius),
    box: ({ width, height }) => new Box(width / 2, height / 2),
    polygon: ({ vertices }) => new Polygon(vertices.map(([x, y]) => new Vec2(x, y))),
  };
  for (const { x, y, angle, shape, isStatic } of bodies) {
    const body = world.createBody({ type: isStatic ? 'static' : 'dynamic', position: new Vec2(x, y), angle });
    body.createFixture({ shape: shapes[shape.kind](shape), density: 1 });
  }
  settle(() => world.step(DT));
  const box = shapes.box({ width: BOX_SIDE, height: BOX_SIDE });
  return { ray: planckRays(lib, world), box: planckBoxes(lib, world, box) };
}

function planckRays({ Vec2 }, world) {
  const hit = { fixture: null, point: null, normal: null, fraction: NONE };
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
      hit.fraction = NONE;
      world.rayCast(from, to, note);
      return hit.fraction;
    };
  };
}

/** Its world casts no shapes: the box is cast at each fixture within the bounds of its way. */
function planckBoxes({ AABB, ShapeCast, ShapeCastInput, ShapeCastOutput, Transform, Vec2 }, world, box) {
  const input = new ShapeCastInput();
  const output = new ShapeCastOutput();
  const [atStart, atEnd, around] = [new AABB(), new AABB(), new AABB()];
  let nearest = NONE;
  const meet = (fixture) => {
    input.proxyA.set(fixture.getShape(), 0);
    input.transformA.set(fixture.getBody().getTransform());
    if (ShapeCast(output, input) && (nearest === NONE || output.lambda < nearest)) {
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
      nearest = NONE;
      world.queryAABB(around, meet);
      return nearest;
    };
  };
}

async function castInRapier(bodies) {
  const { default: RAPIER } = await import('@dimforge/rapier2d-compat');
  const { ColliderDesc, Cuboid, Ray, RigidBodyDesc, World } = RAPIER;
  await RAPIER.init();
  const world = new World({ x: 0, y: 0 });
  const shapes = {
    circle: ({ radius }) => ColliderDesc.ball(radius),
    box: ({ width, height }) => ColliderDesc.cuboid(width / 2, height / 2),
    polygon: ({ vertices }) => ColliderDesc.convexPolyline(Float32Array.from(vertices.flat())),
  };
  for (const { x, y, angle, shape, isStatic } of bodies) {
    const desc = isStatic ? RigidBodyDesc.fixed() : RigidBodyDesc.dynamic().setCanSleep(false);
    const body = world.createRigidBody(desc.setTranslation(x, y).setRotation(angle));
    world.createCollider(shapes[shape.kind](shape), body);
  }
  settle(() => world.step());
  const box = new Cuboid(BOX_SIDE / 2, BOX_SIDE / 2);
  return {
    ray({ x, y, dx, dy }) {
      const ray = new Ray({ x, y }, { x: dx, y: dy });
      return () => world.castRayAndGetNormal(ray, 1, false)?.timeOfImpact ?? NONE;
    },
    box({ x, y, angle, dx, dy }) {
      const position = { x, y };
      const velocity = { x: dx, y: dy };
      return () => world.castShape(position, angle, velocity, box, 0, 1, true)?.time_of_impact ?? NONE;
    },
  };
}
