import type { RigidBody } from '../body.js';
import type { BodyType } from '../body-params.js';
import type { Broadphase } from '../broadphase/broadphase.js';
import type { AngleConstraint } from '../constraint/angle.js';
import type { Constraint } from '../constraint/constraint.js';
import type { CustomConstraint } from '../constraint/custom.js';
import type { DistanceConstraint } from '../constraint/distance.js';
import type { LineConstraint } from '../constraint/line.js';
import type { MotorConstraint } from '../constraint/motor.js';
import type { PointConstraint } from '../constraint/point.js';
import type { PulleyConstraint } from '../constraint/pulley.js';
import type { WeldConstraint } from '../constraint/weld.js';
import type { Material } from '../material.js';
import type { Circle } from '../shape/circle.js';
import type { Polygon } from '../shape/polygon.js';
import type { Shape } from '../shape/shape.js';
import { callable, options as checkedOptions, typeError } from '../validate.js';
import type { World } from '../world.js';
import { toBase64 } from './base64.js';

/** A number as JSON can hold it: infinite ones as their names. */
export type PlainNumber = number | 'Infinity' | '-Infinity';

export interface PlainMaterial {
  elasticity: PlainNumber;
  staticFriction: number;
  dynamicFriction: number;
  rollingFriction: number;
  density: number;
  userData: unknown;
}

export interface PlainShape {
  /** When it was added; the first of two is the first of their arbiter. */
  order: number;
  /** Place among all shapes by when they were created. */
  rank: number;
  type: 'CIRCLE' | 'POLYGON';
  sensor: boolean;
  /** Index in `materials`. */
  material: number;
  group: number;
  mask: number;
  radius?: number;
  origin?: number[];
  vertices?: number[][];
  userData: unknown;
}

export interface PlainBody {
  order: number;
  /** `false` for what is only an anchor of constraints. */
  inWorld: boolean;
  type: BodyType;
  position: number[];
  rotation: number;
  velocity: number[];
  angularVelocity: number;
  shapes: PlainShape[];
  userData: unknown;
}

export interface PlainConstraint {
  order: number;
  type: Constraint['type'];
  /** Indices in `bodies`. */
  bodies: number[];
  /** One for each body. */
  anchors?: number[][];
  axis?: number[];
  phase?: number;
  ratio?: number;
  rate?: number;
  lowerBound?: PlainNumber;
  upperBound?: PlainNumber;
  userData: unknown;
}

/** A world as data that JSON can hold. What objects there are can be read and, with care, edited; `state` is what the solver knows of them. */
export interface PlainWorld {
  format: 'phys2d world';
  version: 1;
  materials: PlainMaterial[];
  bodies: PlainBody[];
  constraints: PlainConstraint[];
  /** A snapshot, base64. */
  state: string;
}

export interface SerializeOptions {
  /** Turns the user data of a material, shape, body or constraint into what JSON can hold. Default: it is left out. */
  userData?: ((userData: unknown) => unknown) | undefined;
}

export interface DeserializeOptions {
  /** The reverse of `SerializeOptions.userData`. Default: it is taken as it is. */
  userData?: ((plain: unknown) => unknown) | undefined;
  /** Makes a custom constraint anew, of as many rows, as its callbacks are code. Needed if there are any. */
  custom?: ((plain: PlainConstraint, bodies: RigidBody[]) => CustomConstraint) | undefined;
  /** For the new world; as in `createWorld`. */
  broadphase?: Broadphase | undefined;
}

function plain(value: number): PlainNumber {
  return Number.isFinite(value) ? value : value > 0 ? 'Infinity' : '-Infinity';
}

/**
 * A whole world as plain data: `JSON.stringify` it, and `deserialize` makes an equal world of it, that goes on to the bit. Listeners are not in it, nor
 * the callbacks of custom constraints, nor events of what was removed since the last step.
 *
 * @throws Error when called from a handler or callback of the world.
 */
export function serialize(world: World, options: SerializeOptions = {}): PlainWorld {
  if (typeof world?.snapshot !== 'function') {
    throw typeError('serialize', 'world', 'a World', world);
  }
  const { userData: convert } = checkedOptions('serialize', options, false, 'options');
  if (convert !== undefined) {
    callable('serialize', 'options.userData', convert);
  }
  const state = toBase64(world.snapshot());
  const bodies = [...new Set([...world.rigidBodies, ...world.constraints.flatMap(membersOf)])];
  const shapes = bodies.flatMap((body) => body.shapes);
  const materials = [...new Set(shapes.map((shape) => shape.getMaterial()))];
  const ranks = new Map([...shapes].sort((a, b) => a.id - b.id).map((shape, rank) => [shape, rank]));
  const userData = (value: unknown): unknown => convert?.(value) ?? null;
  return {
    format: 'phys2d world',
    version: 1,
    materials: materials.map((material) => plainMaterial(material, userData)),
    bodies: bodies.map((body) => ({
      order: body.order,
      inWorld: body.world === world,
      type: body.isDynamic() ? 'dynamic' : body.isStatic() ? 'static' : 'kinematic',
      position: body.getPosition(),
      rotation: body.getRotation(),
      velocity: body.getVelocity(),
      angularVelocity: body.getAngularVelocity(),
      shapes: body.shapes.map((shape) => plainShape(shape, ranks.get(shape)!, materials, userData)),
      userData: userData(body.userData),
    })),
    constraints: world.constraints.map((constraint) => plainConstraint(constraint, bodies, userData)),
    state,
  };
}

/** The bodies of a constraint, in their order. */
export function membersOf(constraint: Constraint): readonly RigidBody[] {
  if (constraint.type === 'CUSTOM') {
    return (constraint as CustomConstraint).bodies;
  }
  const { bodyA, bodyB } = constraint as PointConstraint;
  return constraint.type === 'PULLEY'
    ? [bodyA, bodyB, (constraint as PulleyConstraint).bodyC, (constraint as PulleyConstraint).bodyD]
    : [bodyA, bodyB];
}

type UserData = (value: unknown) => unknown;

function plainMaterial(material: Material, userData: UserData): PlainMaterial {
  return {
    elasticity: plain(material.getElasticity()),
    staticFriction: material.getStaticFriction(),
    dynamicFriction: material.getDynamicFriction(),
    rollingFriction: material.getRollingFriction(),
    density: material.getDensity(),
    userData: userData(material.userData),
  };
}

function plainShape(shape: Shape, rank: number, materials: readonly Material[], userData: UserData): PlainShape {
  return {
    order: shape.order,
    rank,
    type: shape.type,
    sensor: shape.sensor,
    material: materials.indexOf(shape.getMaterial()),
    group: shape.getGroup(),
    mask: shape.getMask(),
    ...(shape.type === 'CIRCLE'
      ? { radius: (shape as Circle).getRadius(), origin: (shape as Circle).getOrigin() }
      : { vertices: pairs((shape as Polygon).vertices) }),
    userData: userData(shape.userData),
  };
}

function pairs(numbers: ArrayLike<number>): number[][] {
  return Array.from({ length: numbers.length / 2 }, (_, i) => [numbers[2 * i]!, numbers[2 * i + 1]!]);
}

function plainConstraint(constraint: Constraint, bodies: readonly RigidBody[], userData: UserData): PlainConstraint {
  const { type } = constraint;
  const result: PlainConstraint = {
    order: constraint.order,
    type,
    bodies: membersOf(constraint).map((body) => bodies.indexOf(body)),
    userData: userData(constraint.userData),
  };
  if (type === 'POINT' || type === 'WELD' || type === 'DISTANCE' || type === 'LINE' || type === 'PULLEY') {
    const anchored = constraint as PulleyConstraint;
    result.anchors = [anchored.getAnchorA(), anchored.getAnchorB()];
    if (type === 'PULLEY') {
      result.anchors.push(anchored.getAnchorC(), anchored.getAnchorD());
    }
  }
  if (type === 'WELD') {
    result.phase = (constraint as WeldConstraint).getPhase();
  }
  if (type === 'LINE') {
    result.axis = (constraint as LineConstraint).getAxis();
  }
  if (type === 'MOTOR') {
    result.rate = (constraint as MotorConstraint).getRate();
  }
  if (type === 'ANGLE' || type === 'MOTOR' || type === 'PULLEY') {
    result.ratio = (constraint as AngleConstraint).getRatio();
  }
  if (type === 'DISTANCE' || type === 'LINE' || type === 'ANGLE' || type === 'PULLEY') {
    result.lowerBound = plain((constraint as DistanceConstraint).getLowerBound());
    result.upperBound = plain((constraint as DistanceConstraint).getUpperBound());
  }
  return result;
}
