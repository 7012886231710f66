import { describe, expect, it } from 'vitest';
import { validate } from '../../src/audit/index.js';
import * as g from '../../src/collide/layout.js';
import { ACTIVE, AWAKE, SENSOR, SLEEPING } from '../../src/contact/bits.js';
import * as c from '../../src/contact/layout.js';
import { type Arbiter, type Circle, type Constraint, type Polygon, phys2D, type World } from '../../src/index.js';
import { Tangle } from '../scenes/tangle.js';

interface Scene {
  readonly world: World;
  /** A circle that rolls along the floor, tied to a box that hangs. */
  readonly ball: Circle;
  readonly box: Polygon;
  readonly rod: Constraint;
  /** Of ball and floor. */
  readonly arbiter: Arbiter;
  /** Asleep, with the body below it. */
  readonly sleeper: Polygon;
}

function spoil({ numbers, at }: Arbiter, value: number, field: number): void {
  numbers[at + field] = value;
}

function sleepAlone(arbiter: Arbiter): void {
  arbiter.mark(SLEEPING);
  arbiter.unmark(ACTIVE);
}

/** Something rolls, something hangs, two boxes sleep on each other. */
function makeScene(): Scene {
  const world = phys2D.createWorld();
  const box = (width: number, height: number) =>
    phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, height) });
  const add = (shape: Circle | Polygon, x: number, y: number, type: 'static' | 'dynamic' = 'dynamic') => {
    world.addRigidBody(phys2D.createRigidBody({ type, position: [x, y], shapes: [shape] }));
    return shape;
  };
  add(box(100, 1), 0, 0.5, 'static');
  add(box(1, 1), 20, -0.5);
  const sleeper = add(box(1, 1), 20, -1.5) as Polygon;
  const ball = add(phys2D.createCircleShape({ radius: 0.5 }), -10, -0.5) as Circle;
  const hanging = add(box(1, 1), -10, -6) as Polygon;
  ball.body!.setVelocity([1, 0]);
  const [bodyA, bodyB] = [ball.body!, hanging.body!];
  const rod = phys2D.createDistanceConstraint({
    bodyA,
    bodyB,
    lowerBound: 0,
    upperBound: 20,
    ignoreInteractions: true,
  });
  world.addConstraint(rod);
  for (let i = 0; i < 80; i += 1) {
    world.step(1 / 60);
    ball.body!.setVelocity([1, 0]);
    hanging.body!.setPosition([-10, -6]);
  }
  world.step(1 / 60);
  return { world, ball, box: hanging, rod, arbiter: ball.arbiters[0]!, sleeper };
}

/** What is changed by force, and what is said then. */
const DAMAGES: readonly [damage: (scene: Scene) => unknown, message: RegExp][] = [
  [
    ({ world }) => world.rigidBodies.push(world.rigidBodies[0]!),
    /^validate: world: rigidBodies must have each entry once/,
  ],
  [({ world }) => world.rigidBodies.reverse(), /^validate: world\.rigidBodies\[0\]: index must be 0, got 4/],
  [({ ball }) => Object.assign(ball.body!, { owner: null }), /must know its world/],
  [
    ({ ball }) => Object.assign(ball.body!, { vx: NaN }),
    /^validate: world\.rigidBodies\[3\]: velocity x must be a finite/,
  ],
  [({ ball }) => Object.assign(ball.body!, { x: Infinity }), /position x must be a finite number, got Infinity/],
  [({ ball }) => Object.assign(ball.body!, { cos: 2 }), /cosine and sine must be/],
  [({ ball }) => Object.assign(ball.body!, { mass: NaN }), /mass must be a number >= 0, got NaN/],
  [({ ball }) => Object.assign(ball.body!, { liveIndex: 7 }), /is awake, but in no live list/],
  [({ ball }) => Object.assign(ball.body!, { asleep: true }), /is asleep, but has a place in a live list/],
  [({ world }) => world.liveDynamics.push(world.rigidBodies[0]!), /is in a live list that it does not belong to/],
  [({ world }) => Object.assign(world.rigidBodies[0]!, { vx: 1 }), /is static, but moves/],
  [({ sleeper }) => Object.assign(sleeper.body!, { island: null }), /left an island that sleeps on/],
  [({ sleeper }) => sleeper.body!.island!.bodies.splice(0, 2), /must be in its island/],
  [({ ball }) => Object.assign(ball.body!, { woken: true }), /waits for a wake event that is not noted/],
  [({ world, ball }) => Object.assign(world.stale, { count: 0 }) && ball, /is not among those to be refreshed/],
  [({ sleeper }) => sleeper.numbers.fill(1, sleeper.at, sleeper.at + 4), /bounds must be those of its placement/],
  [({ sleeper }) => Object.assign(sleeper.handle!, { minX: -1 }), /its handle must have its bounds/],
  [
    ({ sleeper }) => Object.assign(sleeper.handle!, { isStatic: false }),
    /handle must be static just while its body sleeps/,
  ],
  [({ sleeper }) => Object.assign(sleeper, { handle: null }), /must have a handle in the broadphase/],
  [({ world }) => world.broadphase.insert({}, [0, 0, 1, 1], true), /the broadphase must have 5 handles, got 6/],
  [
    ({ world, ball }) => world.broadphase.remove(ball.handle!),
    /^validate: shape \d+: its handle is not in the broadphase/,
  ],
  [({ ball }) => Object.assign(ball, { radius: 0 }), /radius must be > 0, got 0/],
  [({ box }) => box.localEdges.fill(0.5, 2, 4), /normal of edge 0 must be a unit vector, got 0.5, 0.5/],
  [({ box }) => box.vertices.fill(NaN, 2, 3), /corner 1 must be a finite number/],
  [({ ball }) => ball.arbiters.pop(), /must be listed by both shapes/],
  [({ ball, arbiter }) => ball.arbiters.push(arbiter), /its index in the arbiters of shape \d+ must be 1, got 0/],
  [({ arbiter }) => arbiter.mark(SLEEPING), /^validate: the arbiter of shapes \d+ and \d+: cannot be both/],
  [({ arbiter }) => sleepAlone(arbiter), /is asleep, but a body of it is not/],
  [({ arbiter }) => arbiter.mark(SENSOR), /must know whether one is a sensor/],
  [({ arbiter }) => arbiter.unmark(AWAKE), /is in the list of awake pairs, and must know it/],
  [({ arbiter }) => spoil(arbiter, 0.5, g.NX), /normal must be a unit vector/],
  [({ arbiter }) => spoil(arbiter, NaN, g.S0), /separation of contact 0 must be a finite number/],
  [({ arbiter }) => spoil(arbiter, -1, c.STEP_NORMAL), /normal impulse must be a number >= 0/],
  [({ arbiter }) => spoil(arbiter, Infinity, c.TANGENT), /impulse must be a finite number/],
  [
    ({ world }) => world.dynamicArbiters.push(world.staticArbiters[0]!),
    /is in a list of the world that it does not belong to/,
  ],
  [({ world }) => world.staticArbiters.pop(), /must be in the list of the world that it belongs to/],
  [
    ({ world }) => world.pairs.sorted.add(world.pairs.sorted.items[0]!),
    /the list of awake pairs must have each entry once/,
  ],
  [({ world }) => Object.assign(world.pairs.table, { size: 9 }), /the table of pairs must count \d+, got 9/],
  [({ world, arbiter }) => world.pairs.table.remove(arbiter), /must be in the table of pairs/],
  [({ world, arbiter }) => Object.assign(world.pairs, { pool: arbiter }), /is in a pool and in the table of pairs/],
  [
    ({ world, arbiter }) => Object.assign(world.pairs, { pool: Object.assign(arbiter, { next: arbiter }) }),
    /is in a pool twice/,
  ],
  [({ world, arbiter }) => world.pairs.cut.push(arbiter, arbiter), /is in a pool twice/],
  [({ world, rod }) => world.constraints.push(rod), /constraints must have each entry once/],
  [
    ({ rod }) => Object.assign(rod, { index: 3 }),
    /^validate: world\.constraints\[0\] \(DISTANCE\): index must be 0, got 3/,
  ],
  [({ rod }) => Object.assign(rod, { liveIndex: -1 }), /must be live just while it is enabled and awake/],
  [({ rod }) => Object.assign(rod, { asleep: true }), /must be live just while it is enabled and awake/],
  [({ rod, ball }) => ball.body!.constraints.splice(0) && rod, /must be listed by its bodies/],
  [({ ball }) => Object.assign(ball.body!, { ignoring: [] }), /must list 2 that it ignores, got 0/],
  [({ rod }) => rod.impulse.fill(NaN), /impulse must be a finite number, got NaN/],
  [({ rod }) => Object.assign(rod, { lower: 100 }), /lower bound must not be above/],
  [({ world, ball }) => world.toWake.add(ball.body!), /what was hit must be woken within the step/],
];

describe('validate', () => {
  it('has nothing to say of a world as it is, awake, asleep and in between', () => {
    for (const broadphase of [phys2D.createBoxTreeBroadphase(), phys2D.createSweepAndPruneBroadphase()]) {
      const { world } = new Tangle(phys2D, phys2D.createWorld({ broadphase }), 5, 30, 30);
      for (let i = 0; i < 60; i += 1) {
        validate(world);
        world.step(1 / 60);
      }
      validate(world);
      world.clear();
      validate(world);
    }
    validate(makeScene().world);
    expect(makeScene().sleeper.body!.sleeping).toBe(true);
  });

  it.each(DAMAGES)('finds what %s does', (damage, message) => {
    const scene = makeScene();
    damage(scene);
    expect(() => validate(scene.world)).toThrow(message);
  });

  it('changes nothing', () => {
    const [watched, free] = [makeScene(), makeScene()];
    for (let i = 0; i < 30; i += 1) {
      validate(watched.world);
      watched.world.step(1 / 60);
      free.world.step(1 / 60);
    }
    expect(watched.ball.body!.getPosition()).toEqual(free.ball.body!.getPosition());
    expect(watched.box.body!.getPosition()).toEqual(free.box.body!.getPosition());
  });

  it('may be called in event handlers, and is refused during a step', () => {
    const { world, ball } = makeScene();
    let calls = 0;
    ball.addEventListener('progress', () => {
      validate(world);
      calls += 1;
    });
    world.step(1 / 60);
    expect(calls).toBe(1);
    ball.addEventListener('preSolve', () => validate(world));
    expect(() => world.step(1 / 60)).toThrow('validate: must not be called during a step');
    validate(world);
  });

  it.each([undefined, null, 1, 'world', {}, { step() {} }])('refuses %s', (value) => {
    expect(() => validate(value as never)).toThrow(TypeError);
    expect(() => validate(value as never)).toThrow('validate: world must be a World');
  });
});
