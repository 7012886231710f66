import { describe, expect, it } from 'vitest';
import { validate } from '../../src/audit/index.js';
import {
  type Broadphase,
  type Circle,
  type CustomConstraint,
  type DistanceConstraint,
  phys2D,
  type RigidBody,
  type World,
} from '../../src/index.js';
import { FixedStepRunner } from '../../src/runner.js';

// Code of the user that throws: the error reaches the caller, the world is consistent, the next step works.

class Mine extends Error {}

/** Throws when it is called for the first time. */
class Thrower {
  calls = 0;

  readonly call = (): void => {
    this.calls += 1;
    if (this.calls === 1) {
      throw new Mine();
    }
  };
}

interface Scene {
  readonly world: World;
  /** Falls onto the floor, and is there in the tenth step at the latest. */
  readonly ball: Circle;
  /** Far away, falls freely. */
  readonly free: RigidBody;
  /** Asleep on the floor. */
  readonly sleeper: RigidBody;
  /** Holds a box up, and breaks under the pull of `pull`. */
  readonly rope: DistanceConstraint;
  readonly custom: CustomConstraint;
}

function makeScene(thrower: Thrower, callback?: string, broadphase?: Broadphase): Scene {
  const world = phys2D.createWorld(broadphase && { broadphase });
  const add = (type: 'static' | 'dynamic', x: number, y: number, size = 1): RigidBody => {
    const shape = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(size, 1) });
    const body = phys2D.createRigidBody({ type, position: [x, y], shapes: [shape] });
    world.addRigidBody(body);
    return body;
  };
  const floor = add('static', 0, 0.5, 100);
  const ball = phys2D.createCircleShape({ radius: 0.5 });
  world.addRigidBody(phys2D.createRigidBody({ position: [0, -0.6], velocity: [0, 3], shapes: [ball] }));
  const free = add('dynamic', 1000, 0);
  const sleeper = add('dynamic', 10, -0.5);
  sleeper.sleep();
  const hanging = add('dynamic', 20, -10);
  const rope = phys2D.createDistanceConstraint({
    bodyA: floor,
    bodyB: hanging,
    anchorA: [20, -15],
    lowerBound: 0,
    upperBound: 5,
    maxForce: 1000,
    breakUnderForce: true,
  });
  const custom = phys2D.createCustomConstraint({
    dimension: 1,
    bodies: [add('dynamic', 40, -10)],
    stiff: callback !== 'position',
    jacobian(data, index) {
      data[index] = 1;
    },
    position(data, index) {
      data[index] = this.bodies[0]!.getPosition()[0] - 40.1;
    },
    velocityClamp() {},
    positionClamp() {},
    ...(callback === undefined ? {} : { [callback]: thrower.call }),
  });
  world.addConstraint(rope);
  world.addConstraint(custom);
  return { world, ball, free, sleeper, rope, custom };
}

/** Steps until the error comes, which it does; then on: as if nothing had been. */
function survives({ world, free }: Scene, thrower: Thrower): void {
  let thrown: unknown = null;
  for (let i = 0; i < 100 && thrown === null; i += 1) {
    try {
      world.step(1 / 60);
    } catch (error) {
      thrown = error;
    }
  }
  expect(thrown).toBeInstanceOf(Mine);
  validate(world);
  for (let i = 0; i < 10; i += 1) {
    world.step(1 / 60);
    validate(world);
  }
  const alone = phys2D.createWorld();
  const twin = phys2D.createRigidBody({ position: [1000, 0], shapes: free.shapes.map((shape) => shape.clone()) });
  alone.addRigidBody(twin);
  for (let i = 0; i < world.timeStamp; i += 1) {
    alone.step(1 / 60);
  }
  expect(free.getPosition()).toEqual(twin.getPosition());
  expect(thrower.calls).toBeGreaterThan(0);
}

describe('a handler that throws', () => {
  it.each(['begin', 'progress', 'end', 'preSolve', 'hit'] as const)('of %s', (type) => {
    const thrower = new Thrower();
    const scene = makeScene(thrower);
    scene.ball.addEventListener(type, thrower.call);
    if (type === 'end') {
      scene.ball.addEventListener('progress', () => scene.ball.body!.setVelocity([0, -30]));
    }
    survives(scene, thrower);
  });

  it.each(['wake', 'sleep'] as const)('of %s of a body', (type) => {
    const thrower = new Thrower();
    const scene = makeScene(thrower);
    scene.sleeper.addEventListener(type, thrower.call);
    if (type === 'wake') {
      scene.sleeper.sleep();
      scene.sleeper.setVelocity([1, 0]);
    }
    survives(scene, thrower);
  });

  it.each(['wake', 'sleep', 'break'] as const)('of %s of a constraint', (type) => {
    const thrower = new Thrower();
    const scene = makeScene(thrower);
    const { rope } = scene;
    const { bodyB } = rope;
    rope.addEventListener(type, thrower.call);
    if (type === 'wake') {
      rope.sleep();
      rope.setUpperBound(6);
    } else if (type === 'break') {
      bodyB.setForce([0, 1e4]);
    } else {
      // With nothing awake that it could hold.
      bodyB.sleep();
    }
    survives(scene, thrower);
  });

  it('and the others are called all the same', () => {
    const [first, second] = [new Thrower(), new Thrower()];
    const scene = makeScene(first);
    scene.ball.addEventListener('progress', first.call);
    scene.ball.addEventListener('progress', second.call, 0xffffffff);
    survives(scene, first);
    expect(second.calls).toBe(first.calls);
  });
});

describe('a callback of a custom constraint that throws', () => {
  it.each(['jacobian', 'position', 'positionConstants', 'velocityClamp', 'positionClamp'])('%s', (name) => {
    const thrower = new Thrower();
    survives(makeScene(thrower, name), thrower);
  });
});

describe('a callback that throws, of', () => {
  const ray = { origin: [0, -20], direction: [0, 1], maxFactor: 100 };
  it.each<[string, (scene: Scene, thrower: Thrower) => unknown]>([
    ['rayCast', ({ world }, { call }) => world.rayCast(ray, false, () => call() === undefined)],
    [
      'convexCast',
      ({ world, ball }, { call }) => {
        ball.body!.setVelocity([20, 0]);
        world.convexCast(ball, 1, () => call() === undefined);
      },
    ],
    ['Broadphase.sample', ({ world }, { call }) => world.broadphase.sample([-9, -9, 9, 9], call)],
    ['Broadphase.perform', ({ world }, { call }) => world.broadphase.perform(call)],
    ['FixedStepRunner.advance', ({ world }, { call }) => FixedStepRunner.create({ world }).advance(1 / 30, call)],
  ])('%s', (_, use) => {
    const thrower = new Thrower();
    const scene = makeScene(thrower);
    for (let i = 0; i < 20; i += 1) {
      scene.world.step(1 / 60);
    }
    expect(() => use(scene, thrower)).toThrow(Mine);
    validate(scene.world);
    use(scene, thrower);
    scene.world.step(1 / 60);
    validate(scene.world);
    expect(thrower.calls).toBeGreaterThan(1);
  });

  it('World.clock', () => {
    // In any of the phases that it times, and in the next step.
    for (let healthy = 0; healthy < 20; healthy += 1) {
      const scene = makeScene(new Thrower());
      let calls = 0;
      scene.world.clock = () => {
        calls += 1;
        if (calls === healthy + 1) {
          throw new Mine();
        }
        return calls;
      };
      survives(scene, { calls: 1, call() {} });
    }
  });
});

describe('options with getters that throw', () => {
  const bad = {
    get position(): [number, number] {
      throw new Mine();
    },
  };
  it('leave nothing behind', () => {
    const { world } = makeScene(new Thrower());
    const before = world.rigidBodies.length;
    const shape = phys2D.createCircleShape({ radius: 1 });
    expect(() =>
      phys2D.createRigidBody({
        shapes: [shape],
        ...Object.create(bad),
        get position() {
          return bad.position;
        },
      }),
    ).toThrow(Mine);
    expect(shape.body).toBeNull();
    const vector = {
      length: 2,
      0: 1,
      get 1(): number {
        throw new Mine();
      },
    };
    for (const call of [
      () => world.setGravity(vector),
      () => world.rigidBodies[1]!.setPosition(vector),
      () => world.rigidBodies[1]!.setVelocity(vector),
      () => world.rigidBodies[1]!.applyImpulse([1, 1], vector),
      () => shape.setOrigin(vector),
    ]) {
      expect(call).toThrow(Mine);
    }
    expect(world.rigidBodies.length).toBe(before);
    validate(world);
  });
});
