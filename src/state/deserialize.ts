import type { RigidBody } from '../body.js';
import type { Constraint } from '../constraint/constraint.js';
import type { Physics2DDevice } from '../device.js';
import type { Material } from '../material.js';
import type { Vec2 } from '../math/vectors.js';
import type { Shape } from '../shape/shape.js';
import { callable, options as checkedOptions, integer, rangeError, typeError } from '../validate.js';
import type { World } from '../world.js';
import { fromBase64 } from './base64.js';
import {
  type DeserializeOptions,
  type PlainBody,
  type PlainConstraint,
  type PlainMaterial,
  type PlainNumber,
  type PlainShape,
  type PlainWorld,
  plainObjects,
} from './serialize.js';

const WHERE = 'deserialize';

/**
 * Makes a world from what `serialize` returned, by the factories of a device; it goes on as the first one does, to the bit.
 *
 * @throws TypeError, RangeError or Error for data that `serialize` cannot have made; the message names the place.
 */
export function deserialize(phys2D: Physics2DDevice, data: PlainWorld, options: DeserializeOptions = {}): World {
  if (typeof phys2D?.createWorld !== 'function') {
    throw typeError(WHERE, 'phys2D', 'a Physics2DDevice', phys2D);
  }
  const given = checkedOptions(WHERE, options, false, 'options');
  const source = object<PlainWorld>('data', data);
  checkFormat(source);
  const state = typeof source.state === 'string' ? fromBase64(source.state) : null;
  if (state === null) {
    throw typeError(WHERE, 'data.state', 'a text in base64', source.state);
  }
  const maker = new Maker(phys2D, given);
  const materials = list<PlainMaterial>('data.materials', source.materials).map((plain, i) =>
    maker.material(`data.materials[${i}]`, plain),
  );
  const bodies = maker.bodies(list<PlainBody>('data.bodies', source.bodies), materials);
  const plainConstraints = list<PlainConstraint>('data.constraints', source.constraints);
  const constraints = plainConstraints.map((plain, i) => maker.constraint(`data.constraints[${i}]`, plain, bodies));
  const world = phys2D.createWorld({ broadphase: given.broadphase });
  source.bodies.forEach((plain, i) => {
    if (plain.inWorld) {
      world.addRigidBody(bodies[i]!);
    }
    bodies[i]!.order = integer(WHERE, `data.bodies[${i}].order`, plain.order, 0);
    plain.shapes.forEach((shape, k) => {
      bodies[i]!.shapes[k]!.order = integer(WHERE, `data.bodies[${i}].shapes[${k}].order`, shape.order, 0);
    });
  });
  constraints.forEach((constraint, i) => {
    world.addConstraint(constraint);
    constraint.order = integer(WHERE, `data.constraints[${i}].order`, plainConstraints[i]!.order, 0);
  });
  world.restore(state);
  checkUnchanged(
    'data',
    plainObjects(world, () => null),
    source,
  );
  return world;
}

/** Checks that data say the same as the state, which is all that the world goes on from: data that do not were edited, in vain. */
function checkUnchanged(name: string, stated: unknown, plain: unknown): void {
  if (typeof stated !== 'object' || stated === null) {
    if (stated !== plain) {
      throw rangeError(WHERE, name, `${String(stated)}, as in data.state`, plain);
    }
    return;
  }
  const given = Object(plain) as Record<string, unknown>;
  for (const [key, value] of Object.entries(stated)) {
    if (key !== 'userData') {
      checkUnchanged(Array.isArray(stated) ? `${name}[${key}]` : `${name}.${key}`, value, given[key]);
    }
  }
  if (Array.isArray(stated)) {
    checkUnchanged(`${name}.length`, stated.length, given.length);
  }
}

function checkFormat(data: PlainWorld): void {
  const rule = 'a phys2d world of version 1';
  if (data.format !== 'phys2d world') {
    throw typeError(WHERE, 'data', rule, data);
  }
  if (data.version !== 1) {
    throw rangeError(WHERE, 'data', rule, `${data.format} ${data.version}`);
  }
}

function object<T extends object>(name: string, value: unknown): T {
  if (typeof value !== 'object' || value === null) {
    throw typeError(WHERE, name, 'an object', value);
  }
  return value as T;
}

function array<T>(name: string, value: unknown): T[] {
  if (!Array.isArray(value)) {
    throw typeError(WHERE, name, 'an array', value);
  }
  return value;
}

function list<T extends object>(name: string, value: unknown): T[] {
  return array<unknown>(name, value).map((entry, i) => object<T>(`${name}[${i}]`, entry));
}

function number(value: PlainNumber | undefined): number | undefined {
  return value === 'Infinity' ? Infinity : value === '-Infinity' ? -Infinity : value;
}

class Maker {
  constructor(
    private readonly phys2D: Physics2DDevice,
    private readonly options: Partial<DeserializeOptions>,
  ) {
    for (const name of ['userData', 'custom'] as const) {
      if (options[name] !== undefined) {
        callable(WHERE, `options.${name}`, options[name]);
      }
    }
  }

  private userData(plain: unknown): unknown {
    return this.options.userData === undefined ? plain : this.options.userData(plain);
  }

  /** Calls a factory; its errors name the place in the data. */
  private at<T>(name: string, make: () => T): T {
    try {
      return make();
    } catch (error) {
      if (error instanceof TypeError || error instanceof RangeError) {
        error.message = `${WHERE}: ${name}: ${error.message}`;
      }
      throw error;
    }
  }

  material(name: string, plain: PlainMaterial): Material {
    const { staticFriction, dynamicFriction, rollingFriction, density } = plain;
    const elasticity = number(plain.elasticity);
    const params = { elasticity, staticFriction, dynamicFriction, rollingFriction, density };
    return this.at(name, () => this.phys2D.createMaterial({ ...params, userData: this.userData(plain.userData) }));
  }

  /** Makes the bodies. Their shapes are created in the order in which they once were. */
  bodies(plains: PlainBody[], materials: Material[]): RigidBody[] {
    const shapes = plains.flatMap((plain, i) => {
      const name = `data.bodies[${i}].shapes`;
      return list<PlainShape>(name, plain.shapes).map((shape, k) => ({ shape, name: `${name}[${k}]` }));
    });
    const made = new Map<PlainShape, Shape>();
    for (const { shape, name } of shapes.sort((a, b) => a.shape.rank - b.shape.rank)) {
      const material = materials[integer(WHERE, `${name}.material`, shape.material, 0)];
      if (material === undefined) {
        throw rangeError(WHERE, `${name}.material`, `less than ${materials.length}`, shape.material);
      }
      made.set(
        shape,
        this.at(name, () => this.shape(shape, material)),
      );
    }
    return plains.map((plain, i) =>
      this.at(`data.bodies[${i}]`, () =>
        this.phys2D.createRigidBody({
          type: plain.type,
          position: plain.position as Vec2,
          rotation: plain.rotation,
          velocity: plain.velocity as Vec2,
          angularVelocity: plain.angularVelocity,
          shapes: plain.shapes.map((shape) => made.get(shape)!),
          userData: this.userData(plain.userData),
        }),
      ),
    );
  }

  private shape(plain: PlainShape, material: Material): Shape {
    const { type, sensor, group, mask } = plain;
    const common = { sensor, group, mask, material, userData: this.userData(plain.userData) };
    if (type === 'CIRCLE') {
      return this.phys2D.createCircleShape({ ...common, radius: plain.radius!, origin: plain.origin as Vec2 });
    }
    if (type !== 'POLYGON') {
      throw rangeError('type', 'it', 'CIRCLE or POLYGON', type);
    }
    return this.phys2D.createPolygonShape({ ...common, vertices: plain.vertices as Vec2[] });
  }

  constraint(name: string, plain: PlainConstraint, bodies: RigidBody[]): Constraint {
    const members = array<number>(`${name}.bodies`, plain.bodies).map((i) => {
      const body = bodies[i];
      if (body === undefined) {
        throw rangeError(WHERE, `${name}.bodies`, 'indices in data.bodies', i);
      }
      return body;
    });
    const constraint = this.at(name, () => this.constraintOf(plain, members));
    constraint.userData = this.userData(plain.userData);
    return constraint;
  }

  private constraintOf(plain: PlainConstraint, members: RigidBody[]): Constraint {
    const { phys2D } = this;
    const [bodyA, bodyB, bodyC, bodyD] = members as [RigidBody, RigidBody, RigidBody, RigidBody];
    const [anchorA, anchorB, anchorC, anchorD] = (
      plain.anchors === undefined ? [] : array('anchors', plain.anchors)
    ) as Vec2[];
    const both = { bodyA, bodyB };
    const anchored = { ...both, anchorA, anchorB };
    const bounds = { lowerBound: number(plain.lowerBound), upperBound: number(plain.upperBound) };
    const { ratio, rate, phase } = plain;
    switch (plain.type) {
      case 'POINT':
        return phys2D.createPointConstraint(anchored);
      case 'WELD':
        return phys2D.createWeldConstraint({ ...anchored, phase });
      case 'DISTANCE':
        return phys2D.createDistanceConstraint({ ...anchored, ...bounds });
      case 'LINE':
        return phys2D.createLineConstraint({ ...anchored, ...bounds, axis: plain.axis as Vec2 });
      case 'ANGLE':
        return phys2D.createAngleConstraint({ ...both, ...bounds, ratio });
      case 'MOTOR':
        return phys2D.createMotorConstraint({ ...both, ratio, rate });
      case 'PULLEY':
        return phys2D.createPulleyConstraint({ ...anchored, ...bounds, bodyC, bodyD, anchorC, anchorD, ratio });
      case 'CUSTOM':
        return this.custom(plain, members);
      default:
        throw rangeError('type', 'it', 'a kind of constraint', plain.type);
    }
  }

  private custom(plain: PlainConstraint, members: RigidBody[]): Constraint {
    const made = this.options.custom?.(plain, members);
    if (made?.type !== 'CUSTOM' || made.world !== null || members.some((body, i) => body !== made.bodies[i])) {
      throw typeError('options.custom', 'its result', 'a new custom constraint of these bodies', made);
    }
    return made;
  }
}
