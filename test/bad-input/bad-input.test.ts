import { describe, expect, it } from 'vitest';
import { phys2D, type RigidBody, type World } from '../../src/index.js';
import { add, box, disc, plainBody, weightless } from '../conformance/setting.js';
import {
  type Bad,
  factory,
  NOT_BITS,
  NOT_BOOLEAN,
  NOT_COUNT,
  NOT_FINITE,
  NOT_MASS,
  NOT_NON_NEGATIVE,
  NOT_NUMBERS,
  NOT_POSITIVE,
  NOT_VECTOR,
  refuses,
} from './refuses.js';

// Every factory and setter refuses bad arguments before anything changes; the message names function, argument, rule and value.

const SHAPE = {
  sensor: NOT_BOOLEAN,
  group: NOT_BITS,
  mask: NOT_BITS,
  material: [[{}, TypeError, 'an object']] as Bad[],
};

factory(
  'createMaterial',
  (params) => phys2D.createMaterial(params),
  {},
  {
    elasticity: [...NOT_NUMBERS, [NaN, RangeError]],
    staticFriction: NOT_NON_NEGATIVE,
    dynamicFriction: NOT_NON_NEGATIVE,
    rollingFriction: NOT_NON_NEGATIVE,
    density: NOT_NON_NEGATIVE,
  },
);
factory(
  'createCircleShape',
  (params) => phys2D.createCircleShape(params),
  { radius: 1 },
  {
    radius: NOT_POSITIVE,
    origin: NOT_VECTOR,
    ...SHAPE,
  },
);
factory(
  'createPolygonShape',
  (params) => phys2D.createPolygonShape(params),
  { vertices: phys2D.createBoxVertices(1, 1) },
  SHAPE,
);
factory(
  'createRigidBody',
  (params) => phys2D.createRigidBody(params),
  {},
  {
    type: [
      ['bullet', TypeError, '"bullet"'],
      [1, TypeError],
      ['toString', TypeError, '"toString"'],
    ],
    shapes: [
      [1, TypeError],
      [{}, TypeError, 'an object'],
    ],
    mass: NOT_MASS,
    inertia: NOT_MASS,
    sleeping: NOT_BOOLEAN,
    allowSleeping: NOT_BOOLEAN,
    bullet: NOT_BOOLEAN,
    position: NOT_VECTOR,
    rotation: NOT_FINITE,
    velocity: NOT_VECTOR,
    angularVelocity: NOT_FINITE,
    force: NOT_VECTOR,
    torque: NOT_FINITE,
    linearDrag: NOT_NON_NEGATIVE,
    angularDrag: NOT_NON_NEGATIVE,
    gravityScale: NOT_FINITE,
    surfaceVelocity: NOT_VECTOR,
  },
);
factory(
  'createWorld',
  (params) => phys2D.createWorld(params),
  {},
  {
    gravity: NOT_VECTOR,
    velocityIterations: NOT_COUNT,
    positionIterations: NOT_COUNT,
    substeps: NOT_COUNT,
    allowSleeping: NOT_BOOLEAN,
    broadphase: [
      [1, TypeError],
      [null, TypeError],
    ],
  },
);

describe('vectors', () => {
  it('name the component that is bad', () => {
    expect(() => phys2D.createRigidBody({ position: [0, NaN] })).toThrow(
      'createRigidBody: position[1] must be a finite number, got NaN',
    );
    expect(() => phys2D.createRigidBody({ velocity: ['1', 0] as never })).toThrow(
      new TypeError('createRigidBody: velocity[0] must be a finite number, got "1"'),
    );
    expect(() => phys2D.createWorld({ gravity: [Infinity, 0] })).toThrow(RangeError);
  });

  it('name the shape that is none', () => {
    expect(() => phys2D.createRigidBody({ shapes: [disc(1), {} as never] })).toThrow(
      'createRigidBody: shapes[1] must be a Shape, got an object',
    );
  });

  it('name the class of what is given, if it has one', () => {
    const message = (value: unknown) => {
      try {
        return String(weightless().addRigidBody(value as RigidBody));
      } catch (error) {
        return (error as Error).message.split(', got ')[1];
      }
    };
    const called = (name: unknown) => {
      const kind = class {};
      Object.defineProperty(kind, 'name', { value: name });
      return new kind();
    };
    expect(message(disc(1))).toBe('an object of class Circle');
    expect(message(new Map())).toBe('an object of class Map');
    expect(message(new Float64Array(2))).toBe('an object of class Float64Array');
    for (const plain of [{}, Object.create(null), called(''), called('Zq'), called(5), { constructor: null }]) {
      expect(message(plain)).toBe('an object');
    }
  });

  it('name the method that a broadphase lacks', () => {
    expect(() => phys2D.createWorld({ broadphase: { insert() {} } as never })).toThrow(
      'createWorld: broadphase must be a Broadphase with the method update, got an object',
    );
  });

  it('name a broadphase that is in use: two worlds would cut each other for ever', () => {
    const broadphase = phys2D.createBoxTreeBroadphase();
    const world = phys2D.createWorld({ broadphase });
    expect(() => phys2D.createWorld({ broadphase })).not.toThrow();
    world.addRigidBody(phys2D.createRigidBody());
    phys2D.createWorld({ broadphase: phys2D.createBoxTreeBroadphase() });
    const other = phys2D.createWorld();
    other.addRigidBody(phys2D.createRigidBody());
    expect(() => phys2D.createWorld({ broadphase: other.broadphase })).toThrow(
      'createWorld: broadphase must not be that of another world that has bodies',
    );
    other.clear();
    expect(() => phys2D.createWorld({ broadphase: other.broadphase })).not.toThrow();
  });

  it('name it where one was given to two worlds, as bodies come to the second', () => {
    const broadphase = phys2D.createBoxTreeBroadphase();
    const [one, other] = [phys2D.createWorld({ broadphase }), phys2D.createWorld({ broadphase })];
    const [body, stranger] = [phys2D.createRigidBody(), phys2D.createRigidBody()];
    one.addRigidBody(body);
    const message = 'World.addRigidBody: broadphase must not be that of another world that has bodies';
    expect(() => other.addRigidBody(stranger)).toThrow(message);
    expect([other.rigidBodies.length, stranger.world]).toEqual([0, null]);
    one.removeRigidBody(body);
    expect([other.addRigidBody(stranger), stranger.world === other]).toEqual([true, true]);
    expect(() => one.addRigidBody(body)).toThrow(message);
  });
});

describe('legal infinities', () => {
  it('elasticity, mass and inertia may be infinite', () => {
    expect(phys2D.createMaterial({ elasticity: -Infinity }).getElasticity()).toBe(-Infinity);
    const body = phys2D.createRigidBody({ mass: Infinity, inertia: Infinity });
    expect([body.getMass(), body.getInertia()]).toEqual([Infinity, Infinity]);
  });
});

describe('vertex helpers', () => {
  for (const [where, call] of [
    ['createBoxVertices', (...a: [number, number]) => phys2D.createBoxVertices(...a)],
    ['createRegularPolygonVertices', (...a: [number, number]) => phys2D.createRegularPolygonVertices(...a, 5)],
  ] as const) {
    const [first, second] = where === 'createBoxVertices' ? ['width', 'height'] : ['diameterX', 'diameterY'];
    it(`${where} refuses bad sizes`, () => {
      for (const bad of NOT_POSITIVE) {
        refuses((value) => call(value, 1), where, first!, bad);
        refuses((value) => call(1, value), where, second!, bad);
      }
    });
  }

  it('createRegularPolygonVertices refuses bad counts', () => {
    for (const bad of [...NOT_COUNT, [2, RangeError, '2']] as Bad[]) {
      refuses((n) => phys2D.createRegularPolygonVertices(1, 1, n), 'createRegularPolygonVertices', 'numVertices', bad);
    }
  });

  it('createRectangleVertices refuses bad corners and empty rectangles', () => {
    for (const bad of NOT_FINITE) {
      refuses((x) => phys2D.createRectangleVertices(x, 0, 1, 1), 'createRectangleVertices', 'x1', bad);
      refuses((y) => phys2D.createRectangleVertices(0, 0, 1, y), 'createRectangleVertices', 'y2', bad);
    }
    expect(() => phys2D.createRectangleVertices(1, 0, 1, 2)).toThrow('createRectangleVertices: x2 must differ from x1');
  });
});

describe('polygons', () => {
  const pentagram = [0, 2, 4, 1, 3].map((k) => phys2D.createRegularPolygonVertices(2, 2, 5)[k]!);
  it.each([
    ['no list', 5, TypeError, 'vertices must be an array of vertices'],
    [
      'two vertices',
      [
        [0, 0],
        [1, 0],
      ],
      RangeError,
      'must have at least 3 vertices, got 2',
    ],
    ['a vertex that is no vector', [[0, 0], [1, 0], 3], TypeError, 'vertices[2] must be 2 finite numbers'],
    [
      'NaN',
      [
        [0, 0],
        [1, NaN],
        [1, 1],
      ],
      RangeError,
      'vertices[1][1] must be a finite number, got NaN',
    ],
    [
      'a repeated vertex',
      [
        [0, 0],
        [1, 0],
        [1, 0],
        [0, 1],
      ],
      RangeError,
      'vertex 2 equal to vertex 1',
    ],
    [
      'first and last equal',
      [
        [0, 0],
        [1, 0],
        [1, 1],
        [0, 0],
      ],
      RangeError,
      'vertex 0 equal to vertex 3',
    ],
    [
      'a dent',
      [
        [0, 0],
        [2, 0],
        [1, 1],
        [2, 2],
        [0, 2],
      ],
      RangeError,
      'vertex 2 bending the other way',
    ],
    [
      'a dent, counter-clockwise',
      [
        [0, 2],
        [2, 2],
        [1, 1],
        [2, 0],
        [0, 0],
      ],
      RangeError,
      'vertex 2 bending',
    ],
    [
      'an hourglass',
      [
        [0, 0],
        [2, 2],
        [2, 0],
        [0, 2],
      ],
      RangeError,
      'vertex',
    ],
    ['a pentagram', pentagram, RangeError, 'a second round at vertex'],
    [
      'no area',
      [
        [0, 0],
        [1, 0],
        [2, 0],
      ],
      RangeError,
      'vert',
    ],
    [
      'a way out and back',
      [
        [0, 0],
        [2, 0],
        [1, 0],
      ],
      RangeError,
      'vert',
    ],
  ] as const)('refuse %s', (_, vertices, kind, message) => {
    const make = () => phys2D.createPolygonShape({ vertices: vertices as never });
    expect(make).toThrow(kind);
    expect(make).toThrow(message);
    const shape = box(1, 1);
    expect(() => shape.setVertices(vertices as never)).toThrow(message);
    expect(shape.computeArea()).toBe(1);
  });

  it('turn counter-clockwise vertices round', () => {
    const vertices = [
      [0, 0],
      [0, 2],
      [3, 4],
    ];
    expect(phys2D.createPolygonShape({ vertices }).computeArea()).toBe(3);
  });

  it('drop vertices inside an edge', () => {
    const vertices = [
      [0, 0],
      [1, 0],
      [2, 0],
      [2, 1],
      [2, 2],
      [0, 2],
    ];
    const shape = phys2D.createPolygonShape({ vertices });
    expect(shape.computeArea()).toBe(4);
    expect(shape.clone().computeArea()).toBe(4);
  });

  it('may have any number of vertices', () => {
    const vertices = phys2D.createRegularPolygonVertices(2, 2, 200);
    expect(phys2D.createPolygonShape({ vertices }).computeArea()).toBeCloseTo(Math.PI, 2);
  });
});

/** What a body shows of itself, to see that nothing changed. */
function state(body: RigidBody): unknown[] {
  return [
    body.getPosition(),
    body.getRotation(),
    body.getVelocity(),
    body.getAngularVelocity(),
    body.getForce(),
    body.getTorque(),
    body.getLinearDrag(),
    body.getAngularDrag(),
    body.getGravityScale(),
    body.getSurfaceVelocity(),
    body.getMass(),
    body.getInertia(),
    body.shapes.length,
  ];
}

describe('bodies', () => {
  const VECTORS: Bad[] = NOT_VECTOR;
  const setters: [method: keyof RigidBody, argument: string, values: readonly Bad[]][] = [
    ['setPosition', 'position', VECTORS],
    ['setRotation', 'rotation', NOT_FINITE],
    ['setVelocity', 'velocity', VECTORS],
    ['setAngularVelocity', 'angularVelocity', NOT_FINITE],
    ['applyImpulse', 'impulse', VECTORS],
    ['integrate', 'deltaTime', NOT_FINITE],
    ['setForce', 'force', VECTORS],
    ['setTorque', 'torque', NOT_FINITE],
    ['applyForce', 'force', VECTORS],
    ['applyTorque', 'torque', NOT_FINITE],
    ['applyAngularImpulse', 'impulse', NOT_FINITE],
    ['getVelocityAtPoint', 'position', VECTORS],
    ['setLinearDrag', 'linearDrag', NOT_NON_NEGATIVE],
    ['setAngularDrag', 'angularDrag', NOT_NON_NEGATIVE],
    ['setGravityScale', 'gravityScale', NOT_FINITE],
    ['setSurfaceVelocity', 'velocity', VECTORS],
    ['setMass', 'mass', NOT_MASS],
    ['setInertia', 'inertia', NOT_MASS],
    ['addShape', 'shape', [[{}, TypeError, 'an object']]],
    ['removeShape', 'shape', [[null, TypeError]]],
    ['transformWorldPointToLocal', 'worldPoint', VECTORS],
    ['transformWorldVectorToLocal', 'worldVector', VECTORS],
    ['transformLocalPointToWorld', 'localPoint', VECTORS],
    ['transformLocalVectorToWorld', 'localVector', VECTORS],
  ];
  it.each(setters)('%s refuses a bad %s, and nothing changes', (method, argument, values) => {
    const body = plainBody({ velocity: [1, 2], angularVelocity: 3 });
    const before = state(body);
    for (const bad of values) {
      refuses((value) => (body[method] as (value: never) => unknown)(value), `RigidBody.${method}`, argument, bad);
    }
    expect(state(body)).toEqual(before);
  });

  it('further arguments are checked too', () => {
    const body = plainBody();
    const before = state(body);
    expect(() => body.applyImpulse([1, 0], [NaN, 0])).toThrow('RigidBody.applyImpulse: position[0] must be');
    expect(() => body.setVelocityFromPosition([0, 0], 0, 0)).toThrow('deltaTime must be a finite number > 0, got 0');
    expect(() => body.setVelocityFromPosition([0, 0], NaN, 1)).toThrow('targetRotation must be');
    expect(() => body.addEventListener('wake', 1 as never)).toThrow(
      'RigidBody.addEventListener: handler must be a function, got 1',
    );
    expect(state(body)).toEqual(before);
  });
});

describe('shapes', () => {
  it.each([
    ['setGroup', 'group', NOT_BITS],
    ['setMask', 'mask', NOT_BITS],
    ['setMaterial', 'material', [[{}, TypeError, 'an object']]],
    ['scale', 'scaleX', NOT_FINITE],
    ['translate', 'translation', NOT_VECTOR],
    ['rotate', 'clockwiseRadians', NOT_FINITE],
    ['transform', 'matrix', [[[1, 0, 0, 1], TypeError, 'an array of length 4'], ...NOT_VECTOR]],
  ] as [keyof typeof shape, string, readonly Bad[]][])('Shape.%s refuses a bad %s', (method, argument, values) => {
    const before = [shape.getGroup(), shape.getMask(), shape.getMaterial(), shape.getRadius(), shape.getOrigin()];
    for (const bad of values) {
      refuses((value) => (shape[method] as (value: never) => unknown)(value), `Shape.${method}`, argument, bad);
    }
    const after = [shape.getGroup(), shape.getMask(), shape.getMaterial(), shape.getRadius(), shape.getOrigin()];
    expect(after).toEqual(before);
  });
  const shape = phys2D.createCircleShape({ radius: 1, origin: [2, 3] });

  it('circles refuse bad geometry', () => {
    for (const bad of NOT_POSITIVE) {
      refuses((value) => shape.setRadius(value), 'Circle.setRadius', 'radius', bad);
    }
    for (const bad of NOT_VECTOR) {
      refuses((value) => shape.setOrigin(value), 'Circle.setOrigin', 'origin', bad);
    }
    expect([shape.getRadius(), shape.getOrigin()]).toEqual([1, [2, 3]]);
  });

  it('listeners are checked', () => {
    expect(() => shape.addEventListener('begin', 'f' as never)).toThrow('handler must be a function, got "f"');
    expect(() => shape.addEventListener('begin', () => {}, 0.5)).toThrow('mask must be an integer of 32 bits, got 0.5');
  });
});

describe('worlds', () => {
  it('step refuses anything but a length of time', () => {
    const world = weightless();
    for (const bad of NOT_POSITIVE) {
      refuses((value) => world.step(value), 'World.step', 'deltaTime', bad);
    }
    expect([world.timeStamp, world.simulatedTime]).toEqual([0, 0]);
  });

  it('step inside a step is an error, and the step goes on', () => {
    for (const type of ['begin', 'preSolve'] as const) {
      const world = weightless();
      const [a, b] = [plainBody(), plainBody({ position: [0.9, 0] })];
      let nested: unknown;
      a.shapes[0]!.addEventListener(type, () => {
        try {
          world.step(1 / 60);
        } catch (error) {
          nested ??= error;
        }
      });
      add(world, a, b);
      world.step(1 / 60);
      expect(String(nested)).toContain('World.step: must not be called from a handler');
      expect(world.timeStamp).toBe(1);
      world.step(1 / 60);
      expect(world.timeStamp).toBe(2);
    }
  });

  it.each([
    ['velocityIterations', NOT_COUNT],
    ['positionIterations', NOT_COUNT],
    ['substeps', NOT_COUNT],
    ['allowSleeping', NOT_BOOLEAN],
  ] as [keyof World, readonly Bad[]][])('%s is checked when set', (name, values) => {
    const world = weightless();
    const before = world[name];
    for (const bad of values) {
      refuses((value) => Object.assign(world, { [name]: value }), 'World', name, bad);
    }
    expect(world[name]).toBe(before);
  });

  it.each([
    ['bullet', false],
    ['allowSleeping', true],
  ] as const)('%s of a body is checked when set', (name, usual) => {
    const body = plainBody();
    for (const bad of NOT_BOOLEAN) {
      refuses((value) => Object.assign(body, { [name]: value }), 'RigidBody', name, bad);
    }
    expect(body[name]).toBe(usual);
    body[name] = !usual;
    expect(body[name]).toBe(!usual);
  });

  it('gravity and bodies are checked', () => {
    const world = weightless();
    for (const bad of NOT_VECTOR) {
      refuses((value) => world.setGravity(value), 'World.setGravity', 'gravity', bad);
    }
    refuses((value) => world.addRigidBody(value), 'World.addRigidBody', 'body', [{}, TypeError, 'an object']);
    refuses((value) => world.removeRigidBody(value), 'World.removeRigidBody', 'body', [null, TypeError]);
    expect([world.getGravity(), world.rigidBodies]).toEqual([[0, 0], []]);
  });
});

describe('arbiters', () => {
  it('setters refuse bad values, and nothing changes', () => {
    const world = weightless();
    add(world, plainBody(), plainBody({ position: [0.9, 0] }));
    world.step(1 / 60);
    const arbiter = world.dynamicArbiters[0]!;
    const before = [arbiter.getElasticity(), arbiter.getStaticFriction(), arbiter.getDynamicFriction()];
    for (const bad of [...NOT_NUMBERS, [NaN, RangeError]] as Bad[]) {
      refuses((value) => arbiter.setElasticity(value), 'Arbiter.setElasticity', 'elasticity', bad);
    }
    for (const bad of NOT_NON_NEGATIVE) {
      refuses((value) => arbiter.setStaticFriction(value), 'Arbiter.setStaticFriction', 'friction', bad);
      refuses((value) => arbiter.setDynamicFriction(value), 'Arbiter.setDynamicFriction', 'friction', bad);
      refuses((value) => arbiter.setRollingFriction(value), 'Arbiter.setRollingFriction', 'friction', bad);
    }
    for (const bad of NOT_BOOLEAN) {
      refuses((value) => arbiter.setAcceptedState(value), 'Arbiter.setAcceptedState', 'accepted', bad);
      refuses((value) => arbiter.setPersistentState(value), 'Arbiter.setPersistentState', 'persistent', bad);
    }
    expect([arbiter.getElasticity(), arbiter.getStaticFriction(), arbiter.getDynamicFriction()]).toEqual(before);
    expect(arbiter.isStateAccepted()).toBe(true);
  });
});
