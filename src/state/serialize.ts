import type { RigidBody } from '../body.js';
import type { BodyType } from '../body-params.js';
import type { Broadphase } from '../broadphase/broadphase.js';
import type { Constraint } from '../constraint/constraint.js';
import type { CustomConstraint } from '../constraint/custom.js';
import type { Material } from '../material.js';
import type { Shape } from '../shape/shape.js';
import { callable, options as checkedOptions, typeError } from '../validate.js';
import type { World } from '../world.js';
import { toBase64 } from './base64.js';

/** A number as JSON can hold it: infinite ones as their names. */
export type PlainNumber = number | 'Infinity' | '-Infinity';

/** A material of a {@link PlainWorld}. */
export interface PlainMaterial {
  /** As `MaterialParams.elasticity`. */
  elasticity: PlainNumber;
  /** >= 0. */
  staticFriction: number;
  /** >= 0. */
  dynamicFriction: number;
  /** >= 0. */
  rollingFriction: number;
  /** kg/m². */
  density: number;
  /** What `SerializeOptions.userData` made of it; else `null`. */
  userData: unknown;
}

/** A shape of a {@link PlainBody}. */
export interface PlainShape {
  /** When it was added; the first of two is the first of their arbiter. */
  order: number;
  /** Place among all shapes by when they were created. */
  rank: number;
  /** Which of the options below it has. */
  type: 'CIRCLE' | 'POLYGON';
  /** Collides with nothing. */
  sensor: boolean;
  /** Index in `materials`. */
  material: number;
  /** Bits that say what it is. */
  group: number;
  /** Bits of the groups that it meets. */
  mask: number;
  /** Of a circle, m. */
  radius?: number;
  /** Centre of a circle in body coordinates, m. */
  origin?: number[];
  /** Corners of a polygon in body coordinates, `[x, y]` each, m. */
  vertices?: number[][];
  /** What `SerializeOptions.userData` made of it; else `null`. */
  userData: unknown;
}

/** A body of a {@link PlainWorld}. */
export interface PlainBody {
  /** When it was added. */
  order: number;
  /** `false` for what is only an anchor of constraints. */
  inWorld: boolean;
  /** What moves it. */
  type: BodyType;
  /** `[x, y]`, m. */
  position: number[];
  /** rad, clockwise on screen. */
  rotation: number;
  /** `[x, y]`, m/s. */
  velocity: number[];
  /** rad/s, clockwise on screen. */
  angularVelocity: number;
  /** In the order of `body.shapes`. */
  shapes: PlainShape[];
  /** What `SerializeOptions.userData` made of it; else `null`. */
  userData: unknown;
}

/** A constraint of a {@link PlainWorld}. */
export interface PlainConstraint {
  /** When it was added. */
  order: number;
  /** Which kind it is, and so which of the options below it has. */
  type: Constraint['type'];
  /** Indices in `bodies`. */
  bodies: number[];
  /** One for each body. */
  anchors?: number[][];
  /** Of a line: its direction in coordinates of body A, length 1. */
  axis?: number[];
  /** Of a weld: the angle that it keeps, rad. */
  phase?: number;
  /** Of an angle, a motor, a pulley. */
  ratio?: number;
  /** Of a motor, rad/s. */
  rate?: number;
  /** m, of an angle rad. */
  lowerBound?: PlainNumber;
  /** m, of an angle rad. */
  upperBound?: PlainNumber;
  /** What `SerializeOptions.userData` made of it; else `null`. */
  userData: unknown;
}

/** A world as data that JSON can hold. To be read: `state` is what the world goes on from, and `deserialize` refuses data that were edited, but for shapes of bodies that are in no world, which are made as told. To change something, change the world that it makes. */
export interface PlainWorld {
  /** Tells it from other data. */
  format: 'phys2d world';
  /** Of the format. */
  version: 1;
  /** Those of the shapes, each once. */
  materials: PlainMaterial[];
  /** Those of the world, and anchors of its constraints that are in none. */
  bodies: PlainBody[];
  /** Those of the world. */
  constraints: PlainConstraint[];
  /** A snapshot, base64. */
  state: string;
}

/** Options of {@link serialize}. */
export interface SerializeOptions {
  /** Turns the user data of a material, shape, body or constraint into what JSON can hold. Default: it is left out. */
  userData?: ((userData: unknown) => unknown) | undefined;
}

/** Options of {@link deserialize}. */
export interface DeserializeOptions {
  /** The reverse of `SerializeOptions.userData`. Default: it is taken as it is. */
  userData?: ((plain: unknown) => unknown) | undefined;
  /** Makes a custom constraint anew, of as many rows, with these bodies and as much `state`, as its callbacks are code. Without it, data with custom constraints is refused. */
  custom?: ((plain: PlainConstraint, bodies: RigidBody[]) => CustomConstraint) | undefined;
  /** For the new world. Default: a box tree, as in `createWorld`. */
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
  return { format: 'phys2d world', version: 1, ...plainObjects(world, (value) => convert?.(value) ?? null), state };
}

/** All of it that can be read. */
export function plainObjects(
  world: World,
  userData: UserData,
): Pick<PlainWorld, 'materials' | 'bodies' | 'constraints'> {
  const bodies = [...new Set([...world.rigidBodies, ...world.constraints.flatMap(membersOf)])];
  const shapes = bodies.flatMap((body) => body.shapes);
  const materials = [...new Set(shapes.map((shape) => shape.getMaterial()))];
  const materialNumbers = numbered(materials);
  const bodyNumbers = numbered(bodies);
  const ranks = numbered([...shapes].sort((a, b) => a.id - b.id));
  return {
    materials: materials.map((material) => plainMaterial(material, userData)),
    bodies: bodies.map((body) => ({
      order: body.order,
      inWorld: body.world === world,
      type: body.isDynamic() ? 'dynamic' : body.isStatic() ? 'static' : 'kinematic',
      position: body.getPosition(),
      rotation: body.getRotation(),
      velocity: body.getVelocity(),
      angularVelocity: body.getAngularVelocity(),
      shapes: body.shapes.map((shape) => plainShape(shape, ranks.get(shape)!, materialNumbers, userData)),
      userData: userData(body.userData),
    })),
    constraints: world.constraints.map((constraint) => plainConstraint(constraint, bodyNumbers, userData)),
  };
}

function numbered<T>(list: readonly T[]): Map<T, number> {
  return new Map(list.map((item, i) => [item, i]));
}

/** The bodies of a constraint, in their order. */
export function membersOf(constraint: Constraint): readonly RigidBody[] {
  if (constraint.type === 'CUSTOM') {
    return constraint.bodies;
  }
  const { bodyA, bodyB } = constraint;
  return constraint.type === 'PULLEY' ? [bodyA, bodyB, constraint.bodyC, constraint.bodyD] : [bodyA, bodyB];
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

function plainShape(
  shape: Shape,
  rank: number,
  materials: ReadonlyMap<Material, number>,
  userData: UserData,
): PlainShape {
  return {
    order: shape.order,
    rank,
    type: shape.type,
    sensor: shape.sensor,
    material: materials.get(shape.getMaterial())!,
    group: shape.getGroup(),
    mask: shape.getMask(),
    ...(shape.type === 'CIRCLE'
      ? { radius: shape.getRadius(), origin: shape.getOrigin() }
      : { vertices: shape.getVertices() }),
    userData: userData(shape.userData),
  };
}

function plainConstraint(
  constraint: Constraint,
  bodies: ReadonlyMap<RigidBody, number>,
  userData: UserData,
): PlainConstraint {
  const result: PlainConstraint = {
    order: constraint.order,
    type: constraint.type,
    bodies: membersOf(constraint).map((body) => bodies.get(body)!),
    userData: userData(constraint.userData),
  };
  if ('getAnchorA' in constraint) {
    result.anchors = [constraint.getAnchorA(), constraint.getAnchorB()];
    if (constraint.type === 'PULLEY') {
      result.anchors.push(constraint.getAnchorC(), constraint.getAnchorD());
    }
  }
  if (constraint.type === 'WELD') {
    result.phase = constraint.getPhase();
  }
  if (constraint.type === 'LINE') {
    result.axis = constraint.getAxis();
  }
  if (constraint.type === 'MOTOR') {
    result.rate = constraint.getRate();
  }
  if ('getRatio' in constraint) {
    result.ratio = constraint.getRatio();
  }
  if ('getLowerBound' in constraint) {
    result.lowerBound = plain(constraint.getLowerBound());
    result.upperBound = plain(constraint.getUpperBound());
  }
  return result;
}
