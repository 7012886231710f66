import type { Physics2DDevice, RigidBody, Shape, Vec2, World } from '../../src/index.js';
import { buildMixed, generator } from './mixed.js';
import { buildPyramid } from './pyramid.js';
import { Tangle } from './tangle.js';

// Six scenes for tests of state: what happens in them depends on nothing but the world, so that it happens again when that is brought back. No
// functions whose last digit an engine decides.

export interface Game {
  readonly world: World;
  /** One step of 1/60 s, with what the game does before it. */
  step(): void;
}

type Build = (phys2D: Physics2DDevice) => Game;

function game(world: World, act: () => void = () => {}): Game {
  return {
    world,
    step() {
      act();
      world.step(1 / 60);
    },
  };
}

function box(phys2D: Physics2DDevice, width: number, height: number): Shape {
  return phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, height) });
}

function addBox(phys2D: Physics2DDevice, world: World, width: number, height: number, position: Vec2): RigidBody {
  const body = phys2D.createRigidBody({ position, shapes: [box(phys2D, width, height)] });
  world.addRigidBody(body);
  return body;
}

function addWall(phys2D: Physics2DDevice, world: World, width: number, height: number, position: Vec2): RigidBody {
  const body = phys2D.createRigidBody({ type: 'static', position, shapes: [box(phys2D, width, height)] });
  world.addRigidBody(body);
  return body;
}

/** A pyramid that falls asleep, and from the third second on rain, whose drops are taken away when there are too many. */
const rain: Build = (phys2D) => {
  const world = phys2D.createWorld();
  buildPyramid(phys2D, world, 8);
  return game(world, () => {
    const { timeStamp } = world;
    if (timeStamp < 180 || timeStamp % 7 !== 0) {
      return;
    }
    const random = generator(timeStamp);
    const shape =
      random() < 0.5
        ? phys2D.createCircleShape({ radius: 0.1 + 0.2 * random() })
        : phys2D.createPolygonShape({ vertices: phys2D.createRegularPolygonVertices(0.5, 0.5, 3 + (timeStamp % 5)) });
    world.addRigidBody(
      phys2D.createRigidBody({ position: [12 * random() - 6, -12], rotation: 6 * random(), shapes: [shape] }),
    );
    if (world.rigidBodies.length > 80) {
      world.removeRigidBody(world.rigidBodies[40]!);
    }
  });
};

/** Constraints of all kinds that cannot all be met; some break. */
const constraints: Build = (phys2D) => {
  const world = phys2D.createWorld();
  addWall(phys2D, world, 40, 1, [0, 12]);
  new Tangle(phys2D, world, 5, 40, 50);
  const hook = addWall(phys2D, world, 0.5, 0.5, [20, -8]);
  let last = hook;
  for (let i = 0; i < 12; i += 1) {
    const link = addBox(phys2D, world, 0.6, 0.2, [20.6 + 0.6 * i, -8]);
    const anchors = { anchorA: [last === hook ? 0.3 : 0.3, 0] as Vec2, anchorB: [-0.3, 0] as Vec2 };
    world.addConstraint(
      phys2D.createPointConstraint({ bodyA: last, bodyB: link, ...anchors, ignoreInteractions: true }),
    );
    last = link;
  }
  return game(world, () => {
    if (world.timeStamp % 90 === 60) {
      const found = world.constraints.filter((constraint) => constraint.isEnabled());
      found[world.timeStamp % found.length]?.disable();
    }
  });
};

/** Handlers that add and remove bodies, change shapes and materials, and decide about collisions. */
const events: Build = (phys2D) => {
  const world = phys2D.createWorld();
  const ice = phys2D.createMaterial({ staticFriction: 0.05, dynamicFriction: 0.02, elasticity: 0.6 });
  const ground = addWall(phys2D, world, 30, 1, [0, 0.5]);
  addWall(phys2D, world, 1, 12, [-8, -6]);
  addWall(phys2D, world, 1, 12, [8, -6]);
  const platform = addWall(phys2D, world, 4, 0.4, [0, -4]);
  platform.shapes[0]!.addEventListener('preSolve', (arbiter) => {
    const [, y] = arbiter.getNormal();
    arbiter.setAcceptedState((arbiter.bodyA === platform ? y : -y) < 0);
  });
  const zone = phys2D.createCircleShape({ radius: 1, sensor: true });
  world.addRigidBody(phys2D.createRigidBody({ type: 'static', position: [5, -1.5], shapes: [zone] }));
  zone.addEventListener('begin', function (_arbiter, other) {
    const { body } = other;
    if (body !== null && body.world === world && body.isDynamic()) {
      other.setMaterial(ice);
      body.setVelocity([-3, -6]);
    }
    void this;
  });
  ground.shapes[0]!.addEventListener('hit', (_arbiter, other, hit) => {
    const { body } = other;
    if (body === null || body.world === null || hit.approachSpeed < 4 || other.type !== 'POLYGON') {
      return;
    }
    const [x, y] = body.getPosition();
    world.removeRigidBody(body);
    for (const side of [-1, 1]) {
      const radius = 0.15;
      const piece = phys2D.createRigidBody({
        position: [x + 0.3 * side, y - 0.3],
        velocity: [side, -3],
        shapes: [phys2D.createCircleShape({ radius })],
      });
      world.addRigidBody(piece);
    }
  });
  ground.shapes[0]!.addEventListener('end', (_arbiter, other) => {
    if (other.type === 'CIRCLE' && other.body?.world === world) {
      other.scale(1.05);
    }
  });
  return game(world, () => {
    const { timeStamp } = world;
    if (timeStamp % 12 === 0 && timeStamp < 500) {
      const random = generator(timeStamp + 1);
      const body = addBox(phys2D, world, 0.3 + 0.5 * random(), 0.3 + 0.5 * random(), [
        12 * random() - 6,
        -5 - 5 * random(),
      ]);
      if (timeStamp % 36 === 0) {
        body.addShape(phys2D.createCircleShape({ radius: 0.2, origin: [0.3, 0] }));
      }
    }
    if (timeStamp % 100 === 70) {
      const circles = world.rigidBodies.filter(({ shapes }) => shapes[0]?.type === 'CIRCLE' && !shapes[0].sensor);
      for (const body of circles.slice(0, 4)) {
        world.removeRigidBody(body);
      }
    }
  });
};

/** Bullets and slivers at high speed between thin walls. */
const bullets: Build = (phys2D) => {
  const world = phys2D.createWorld({ gravity: [0, 4] });
  for (const [width, height, x, y] of [
    [20, 0.05, 0, 8],
    [20, 0.05, 0, -8],
    [0.05, 16, 10, 0],
    [0.05, 16, -10, 0],
  ] as const) {
    addWall(phys2D, world, width, height, [x, y]);
  }
  const fan = phys2D.createRigidBody({ type: 'kinematic', angularVelocity: 9, shapes: [box(phys2D, 6, 0.05)] });
  world.addRigidBody(fan);
  const random = generator(11);
  for (let i = 0; i < 40; i += 1) {
    const bouncy = phys2D.createMaterial({ elasticity: i % 3 === 0 ? 1 : 0.3 });
    const shape =
      i % 4 === 0
        ? phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1, 0.04), material: bouncy })
        : phys2D.createCircleShape({ radius: 0.08 + 0.1 * random(), material: bouncy });
    world.addRigidBody(
      phys2D.createRigidBody({
        position: [16 * random() - 8, 5 + 2 * random()],
        velocity: [160 * random() - 80, 160 * random() - 80],
        angularVelocity: 40 * random() - 20,
        bullet: i % 2 === 0,
        shapes: [shape],
      }),
    );
  }
  return game(world);
};

/** A turning ring, in which boxes tumble. */
const drum: Build = (phys2D) => {
  const world = phys2D.createWorld({ gravity: [0, 20] });
  const ring = Array.from({ length: 24 }, (_, i) => {
    const shape = box(phys2D, 0.4, 1.2);
    shape.translate([4.2, 0]);
    shape.rotate((2 * Math.PI * i) / 24);
    return shape;
  });
  world.addRigidBody(phys2D.createRigidBody({ type: 'kinematic', angularVelocity: 1.5, shapes: ring }));
  const random = generator(3);
  for (let i = 0; i < 60; i += 1) {
    const [width, height] = [0.2 + 0.3 * random(), 0.2 + 0.3 * random()];
    addBox(phys2D, world, width, height, [-2.2 + 0.55 * (i % 9), -2 + 0.55 * Math.floor(i / 9)]);
  }
  return game(world);
};

/** A heap and a chain, a hundred kilometres from the origin. */
const far: Build = (phys2D) => {
  const world = phys2D.createWorld({ broadphase: phys2D.createSweepAndPruneBroadphase() });
  const bodies = buildMixed(phys2D, world, 60, 9);
  for (const body of [...world.rigidBodies]) {
    const [x, y] = body.getPosition();
    world.removeRigidBody(body);
    body.setPosition([x + 1e5, y - 7e4]);
    world.addRigidBody(body);
  }
  for (let i = 1; i < 12; i += 1) {
    const [bodyA, bodyB] = [bodies[i - 1]!, bodies[i]!];
    world.addConstraint(phys2D.createDistanceConstraint({ bodyA, bodyB, upperBound: 3 }));
  }
  return game(world);
};

export const GAMES: Readonly<Record<string, Build>> = { rain, constraints, events, bullets, drum, far };
