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

/** A number as JSON can hold it: infinite ones by their names. */
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
  /** When it was added. Of two shapes, the one added first is the first of their arbiter. */
  order: number;
  /** Rank among all shapes by when they were created. */
  rank: number;
  /** Its kind, which decides which of the optional properties it has. */
  type: 'CIRCLE' | 'POLYGON';
  /** Collides with nothing. */
  sensor: boolean;
  /** Index in `materials`. */
  material: number;
  /** Bits of the groups that it is in. */
  group: number;
  /** Bits of the groups that it interacts with. */
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
  /** `false` for a body that is not in the world, but an anchor of constraints. */
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
  /** Its kind, which decides which of the optional properties it has. */
  type: Constraint['type'];
  /** Indices in `bodies`. */
  bodies: number[];
  /** Anchors in body coordinates, `[x, y]`, m: one for each body. */
  anchors?: number[][];
  /** Of a line: its direction in coordinates of body A, `[x, y]`, length 1. */
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

/**
 * A world as data that JSON can hold. It is for reading only: the world goes on from `state`, and `deserialize` refuses data that were
 * edited, but for shapes of bodies that are in no world, which are made as the data say. To change something, change the world that
 * `deserialize` makes.
 */
export interface PlainWorld {
  /** Distinguishes it from other data. */
  format: 'phys2d world';
  /** Version of the format. */
  version: 1;
  /** The materials of the shapes, each once. */
  materials: PlainMaterial[];
  /** The bodies of the world, and those that are only anchors of its constraints, in no world. */
  bodies: PlainBody[];
  /** The constraints of the world. */
  constraints: PlainConstraint[];
  /** A snapshot of the world, base64. */
  state: string;
}

/** Options of {@link serialize}. */
export interface SerializeOptions {
  /** Turns the user data of a material, shape, body or constraint into something that JSON can hold. Default: user data are left out. */
  userData?: ((userData: unknown) => unknown) | undefined;
}

/** Options of {@link deserialize}. */
export interface DeserializeOptions {
  /** The reverse of `SerializeOptions.userData`. Default: user data are taken as they are. */
  userData?: ((plain: unknown) => unknown) | undefined;
  /**
   * Makes a custom constraint anew, as its callbacks are code: with as many rows, these bodies, and as much `state`. Without it, data with
   * custom constraints are refused.
   */
  custom?: ((plain: PlainConstraint, bodies: RigidBody[]) => CustomConstraint) | undefined;
  /** The broadphase of the new world. Default: a box tree, as in `createWorld`. */
  broadphase?: Broadphase | undefined;
}

function plain(value: number): PlainNumber {
  return Number.isFinite(value) ? value : value > 0 ? 'Infinity' : '-Infinity';
}

/**
 * A whole world as plain data. Save it with `JSON.stringify`; `deserialize` makes an equal world of it, which goes on the same to the bit.
 * Listeners are not included, nor the callbacks of custom constraints, nor events of what was removed since the last step.
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

/** All of the data that can be read, without the state. */
export function plainObjects(
  world: World,
  userData: UserData,
): Pick<PlainWorld, 'materials' | 'bodies' | 'constraints'> {
  const bodies = [...new Set([...world.rigidBodies, ...world.constraints.flatMap(({ members }) => members)])];
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
    bodies: constraint.members.map((body) => bodies.get(body)!),
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
