import { describe, expect, it } from 'vitest';
import type { CustomConstraint, RigidBody, World } from '../../src/index.js';
import type { PlainWorld } from '../../src/state/index.js';
import { GAMES } from '../scenes/states.js';
import { deserialize, phys2D, serialize } from './built.js';

/** As JSON has it. */
function asText(data: PlainWorld): PlainWorld {
  return JSON.parse(JSON.stringify(data)) as PlainWorld;
}

/** A custom constraint is code: the scenes' own are found by their place. */
function customOf(world: World) {
  const found = world.constraints.filter((constraint) => constraint.type === 'CUSTOM');
  return (_: unknown, bodies: ConstructorParameters<typeof CustomConstraint>[0]['bodies'] & object) => {
    const { callbacks } = found.shift()!;
    return phys2D.createCustomConstraint({ ...callbacks, bodies });
  };
}

describe.each(Object.keys(GAMES).filter((name) => name !== 'events' && name !== 'constraints'))('%s', (name) => {
  it('goes on to the bit in a fresh world', () => {
    const game = GAMES[name]!(phys2D);
    for (let i = 0; i < 150; i += 1) {
      game.step();
    }
    const { world } = game;
    world.liveDynamics[0]?.applyForce([0.1, 0], [0.2, 0.3]);
    const copy = deserialize(phys2D, asText(serialize(world)), {
      broadphase: phys2D.createSweepAndPruneBroadphase(),
    });
    expect(copy.hash()).toBe(world.hash());
    for (let i = 0; i < 200; i += 1) {
      world.step(1 / 60);
      copy.step(1 / 60);
    }
    expect(copy.hash()).toBe(world.hash());
  });
});

it('bodies, shapes, constraints and their numbers can be read', () => {
  const world = phys2D.createWorld({ gravity: [1, 2] });
  const material = phys2D.createMaterial({ elasticity: Infinity, userData: 'rubber' });
  const [one, two] = [1, 2].map((x) => {
    const shape = phys2D.createCircleShape({ radius: 0.25, material, userData: `disc ${x}` });
    const body = phys2D.createRigidBody({ position: [x, 0], shapes: [shape], userData: { secret: x } });
    world.addRigidBody(body);
    return body;
  });
  const anchor = phys2D.createRigidBody({ type: 'static', position: [7, 8] });
  world.addConstraint(phys2D.createDistanceConstraint({ bodyA: one!, bodyB: two!, upperBound: Infinity }));
  world.addConstraint(
    phys2D.createPulleyConstraint({ bodyA: one!, bodyB: anchor, bodyC: anchor, bodyD: two!, upperBound: 9 }),
  );
  const data = asText(serialize(world, { userData: (value) => (typeof value === 'string' ? value : null) }));
  expect(data.materials).toHaveLength(1);
  expect(data.materials[0]).toMatchObject({ elasticity: 'Infinity', density: 1, userData: 'rubber' });
  expect(data.bodies.map(({ inWorld, position, userData }) => [inWorld, position, userData])).toEqual([
    [true, [1, 0], null],
    [true, [2, 0], null],
    [false, [7, 8], null],
  ]);
  expect(data.bodies[0]!.shapes[0]).toMatchObject({ type: 'CIRCLE', radius: 0.25, material: 0, userData: 'disc 1' });
  expect(data.constraints[0]).toMatchObject({ type: 'DISTANCE', bodies: [0, 1], upperBound: 'Infinity' });
  expect(data.constraints[1]).toMatchObject({ type: 'PULLEY', bodies: [0, 2, 2, 1], upperBound: 9, ratio: 1 });
  const copy = deserialize(phys2D, data, { userData: (value) => value ?? 'nothing' });
  expect(copy.hash()).toBe(world.hash());
  expect(copy.getGravity()).toEqual([1, 2]);
  expect(copy.rigidBodies[0]!.userData).toBe('nothing');
  expect(copy.rigidBodies[0]!.shapes[0]!.userData).toBe('disc 1');
  expect(copy.rigidBodies[0]!.shapes[0]!.getMaterial()).toBe(copy.rigidBodies[1]!.shapes[0]!.getMaterial());
  expect(copy.rigidBodies[0]!.shapes[0]!.getMaterial().userData).toBe('rubber');
});

it('custom constraints are made by the caller, and all kinds keep their settings', () => {
  const game = GAMES.constraints!(phys2D);
  for (let i = 0; i < 50; i += 1) {
    game.step();
  }
  const { world } = game;
  const data = asText(serialize(world));
  expect(() => deserialize(phys2D, data)).toThrow(
    /options.custom: its result must be a new custom constraint of these bodies, got undefined/,
  );
  const copy = deserialize(phys2D, data, { custom: customOf(world) as never });
  expect(copy.hash()).toBe(world.hash());
  expect(copy.constraints.map(({ type }) => type)).toEqual(world.constraints.map(({ type }) => type));
});

it('what is no new custom constraint of the bodies is refused, and keeps its user data', () => {
  const world = phys2D.createWorld();
  const [a, b] = [0, 1].map(() => phys2D.createRigidBody({ shapes: [phys2D.createCircleShape({ radius: 1 })] }));
  const make = (...bodies: RigidBody[]) =>
    phys2D.createCustomConstraint({ dimension: 1, bodies, jacobian: () => undefined, userData: 'mine' });
  world.addRigidBody(a!);
  world.addRigidBody(b!);
  world.addConstraint(make(a!, b!));
  const data = asText(serialize(world));
  const wrong: [(bodies: RigidBody[]) => unknown, string][] = [
    [() => undefined, 'undefined'],
    [() => null, 'null'],
    [() => ({}), 'an object'],
    [([bodyA, bodyB]) => phys2D.createPointConstraint({ bodyA: bodyA!, bodyB: bodyB! }), 'an object'],
    [([one]) => make(one!), 'an object'],
    [() => make(a!, b!), 'an object'],
    [() => world.constraints[0], 'an object'],
  ];
  for (const [custom, got] of wrong) {
    const call = () => deserialize(phys2D, data, { custom: (_, bodies) => custom(bodies) as never });
    expect(call).toThrow(TypeError);
    expect(call).toThrow(
      `deserialize: data.constraints[0]: options.custom: its result must be a new custom constraint of these bodies, got ${got}`,
    );
  }
  expect(world.constraints[0]!.userData).toBe('mine');
  expect(deserialize(phys2D, data, { custom: (_, bodies) => make(...bodies) }).hash()).toBe(world.hash());
});

it('an `end` that waits is told of a shape that stands in for what is gone', () => {
  const game = GAMES.events!(phys2D);
  for (let i = 0; i < 400; i += 1) {
    game.step();
    const copy = deserialize(phys2D, asText(serialize(game.world)));
    if (i % 50 === 0) {
      copy.step(1 / 60);
      expect(copy.timeStamp).toBe(game.world.timeStamp + 1);
    }
  }
});

describe('refuses', () => {
  const world = phys2D.createWorld();
  const shape = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1, 1) });
  const body = phys2D.createRigidBody({ shapes: [shape] });
  const anchor = phys2D.createRigidBody({ type: 'static' });
  world.addRigidBody(body);
  world.addConstraint(phys2D.createPointConstraint({ bodyA: body, bodyB: anchor }));
  const good = serialize(world);
  const spoil = (change: (data: PlainWorld) => void): (() => void) => {
    const data = asText(good);
    change(data);
    return () => void deserialize(phys2D, data);
  };

  it.each<[string, (data: PlainWorld) => void, string]>([
    [
      'another format',
      (data) => void Object.assign(data, { format: 'x' }),
      'deserialize: data must be a phys2d world of version 1, got an object',
    ],
    ['another version', (data) => void Object.assign(data, { version: 2 }), 'got "phys2d world 2"'],
    [
      'no list of bodies',
      (data) => void Object.assign(data, { bodies: {} }),
      'data.bodies must be an array, got an object',
    ],
    ['a body that is none', (data) => void Object.assign(data.bodies, [7]), 'data.bodies[0] must be an object, got 7'],
    [
      'a bad position',
      (data) => {
        data.bodies[0]!.position = [1];
      },
      'data.bodies[0]: createRigidBody: position',
    ],
    [
      'a bad material',
      (data) => {
        data.materials[0]!.density = -1;
      },
      'data.materials[0]: createMaterial: density',
    ],
    [
      'no such material',
      (data) => {
        data.bodies[0]!.shapes[0]!.material = 4;
      },
      'data.bodies[0].shapes[0].material',
    ],
    [
      'a bad polygon',
      (data) => {
        data.bodies[0]!.shapes[0]!.vertices = [];
      },
      'shapes[0]: createPolygonShape',
    ],
    ['another shape', (data) => void Object.assign(data.bodies[0]!.shapes[0]!, { type: 'BLOB' }), 'CIRCLE or POLYGON'],
    [
      'no such body',
      (data) => {
        data.constraints[0]!.bodies = [0, 9];
      },
      'data.constraints[0].bodies must be',
    ],
    [
      'another kind',
      (data) => void Object.assign(data.constraints[0]!, { type: 'GLUE' }),
      'deserialize: data.constraints[0]: type: it must be a kind of constraint',
    ],
    [
      'a bad state',
      (data) => {
        data.state = '?';
      },
      'data.state must be a text in base64',
    ],
    [
      'a state cut short',
      (data) => {
        data.state = data.state.slice(0, 40);
      },
      'snapshot',
    ],
    ['a missing body', (data) => void data.bodies.pop(), 'data.constraints[0].bodies'],
    ['a missing constraint', (data) => void data.constraints.pop(), 'is neither in the world nor'],
    [
      'another order',
      (data) => {
        data.bodies[0]!.order = 77;
      },
      'is neither in the world nor',
    ],
  ])('%s', (_, change, message) => {
    expect(spoil(change)).toThrow(message);
  });

  it.each<[string, (data: PlainWorld) => void, string]>([
    ['data.bodies[0].position[1]', (data) => void data.bodies[0]!.position.splice(1, 1, 7), '0'],
    ['data.bodies[0].velocity[0]', (data) => void data.bodies[0]!.velocity.splice(0, 1, 7), '0'],
    ['data.bodies[0].rotation', (data) => void Object.assign(data.bodies[0]!, { rotation: 7 }), '0'],
    ['data.bodies[0].type', (data) => void Object.assign(data.bodies[0]!, { type: 'kinematic' }), 'dynamic'],
    [
      'data.bodies[0].shapes[0].mask',
      (data) => void Object.assign(data.bodies[0]!.shapes[0]!, { mask: 7 }),
      '4294967295',
    ],
    [
      'data.bodies[0].shapes[0].vertices[0][0]',
      (data) => void data.bodies[0]!.shapes[0]!.vertices![0]!.splice(0, 1, -7),
      '-0.5',
    ],
    [
      'data.bodies[0].shapes[0].vertices.length',
      (data) => void data.bodies[0]!.shapes[0]!.vertices!.push([-0.7, 0]),
      '4',
    ],
    ['data.materials[0].density', (data) => void Object.assign(data.materials[0]!, { density: 7 }), '1'],
    ['data.constraints[0].anchors[1][0]', (data) => void data.constraints[0]!.anchors![1]!.splice(0, 1, 7), '0'],
  ])('%s, edited', (name, change, kept) => {
    expect(spoil(change)).toThrow(
      new RegExp(`^deserialize: ${name.replace(/[[\].]/g, '\\$&')} must be ${kept}, as in data.state, got `),
    );
  });

  it('anchors that are none', () => {
    expect(spoil((data) => void Object.assign(data.constraints[0]!, { anchors: 5 }))).toThrow(
      /anchors must be an array, got 5$/,
    );
  });

  it('nothing at all', () => {
    for (const wrong of [undefined, null, 7, 'x', []]) {
      expect(() => deserialize(phys2D, wrong as never)).toThrow(/^deserialize: data must be/);
    }
  });
});

it('a material whose numbers have −0 keeps its user data', () => {
  const material = phys2D.createMaterial({ elasticity: -0, density: -0, rollingFriction: -0, userData: 'ice' });
  const world = phys2D.createWorld();
  const shapes = [phys2D.createCircleShape({ radius: 0.5, material })];
  world.addRigidBody(phys2D.createRigidBody({ mass: 1, inertia: 1, shapes }));
  const copy = deserialize(phys2D, asText(serialize(world, { userData: (userData) => userData })));
  expect(copy.rigidBodies[0]!.shapes[0]!.getMaterial().userData).toBe('ice');
});
