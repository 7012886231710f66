import type { RigidBody } from '../body.js';
import { MOTION } from '../body-numbers.js';
import type { Constraint } from '../constraint/constraint.js';
import { Material } from '../material.js';
import type { Shape } from '../shape/shape.js';
import type { World } from '../world.js';
import { isElsewhere, OTHER_BODIES, standIn } from './identity.js';
import * as rows from './rows.js';
import type { Scene } from './scene.js';
import type { Tape } from './tape.js';
import { walkPairs } from './walk-pairs.js';

/**
 * Passes everything that influences the future of a world over a tape, except which objects there are, and what the solver keeps for groups
 * of joints.
 */
export function walk(tape: Tape, world: World, scene: Scene): void {
  tape.begins();
  rows.keepWorld(tape, world);
  if (!tape.hashes) {
    walkMaterials(tape, scene);
  }
  const { bodies, shapes, counts, constraints, inside } = scene;
  let first = 0;
  for (let i = 0; i < bodies.length; i += 1) {
    const shapeCount = i < inside ? counts[i]! : 0;
    walkBody(tape, world, scene, i, first, shapeCount);
    first += shapeCount;
  }
  for (; first < shapes.length; first += 1) {
    const shape = shapes[first]!;
    const isOther = walkShape(tape, scene, tape.holds && isElsewhere(world, shape) ? standIn(shape.kind) : shape);
    if (isOther && shape.owner !== null) shape.owner.claim(shape);
  }
  for (const constraint of constraints) {
    tape.begins();
    constraint.keep(tape);
    if (tape.hashes) {
      walkStrangers(tape, world, constraint);
    }
  }
  for (let i = 0; i < bodies.length && constraints.length > 0; i += 1) {
    walkTies(tape, world, bodies[i]!, constraints);
  }
  walkAwake(tape, world.liveDynamics, bodies, inside);
  walkAwake(tape, world.liveKinematics, bodies, inside);
  walkAwake(tape, world.liveConstraints, constraints, constraints.length);
  walkIslands(tape, scene);
  walkPairs(tape, world, scene);
  walkWoken(tape, world, scene);
}

/**
 * Passes the bodies of other worlds that a constraint has. They are no part of the state, but where they are and how they move has an
 * influence.
 */
function walkStrangers(tape: Tape, world: World, { members }: Constraint): void {
  for (const { owner, kind, numbers, at } of members) {
    if (owner !== null && owner !== world) {
      tape.word(kind);
      tape.block(numbers, at, at + MOTION);
    }
  }
}

function walkMaterials(tape: Tape, { materials, shapes }: Scene): void {
  const count = tape.count(materials.length, shapes.length);
  let known: Map<string, Material> | null = null;
  tape.checksOnto(true);
  for (let i = 0; i < count; i += 1) {
    const own = materials[i] === undefined ? new Float64Array(5) : rows.materialNumbers(materials[i]!);
    const stored = tape.shared(own, Infinity);
    tape.require(stored.length === 5);
    if (tape.checks && (materials[i] === undefined || stored !== own)) {
      known ??= byNumbers(shapes);
      materials[i] = known.get(stored.join()) ?? makeMaterial(stored);
    }
  }
  tape.checksOnto(false);
}

/** The materials of shapes by their numbers; of those with the same numbers, the first. */
function byNumbers(shapes: readonly Shape[]): Map<string, Material> {
  const known = new Map<string, Material>();
  for (const { material } of shapes) {
    const key = rows.materialNumbers(material).join();
    if (!known.has(key)) known.set(key, material);
  }
  return known;
}

function isMadeOf(material: Material, stored: Float64Array): boolean {
  return rows.materialNumbers(material).every((value, i) => Object.is(value, stored[i]));
}

function makeMaterial(numbers: Float64Array): Material {
  const [elasticity, staticFriction, dynamicFriction, rollingFriction, density] = numbers;
  return new Material({ elasticity, staticFriction, dynamicFriction, rollingFriction, density });
}

/** Passes a body, and its `shapeCount` shapes from index `first` on. The shapes of a body outside the world do not matter. */
function walkBody(tape: Tape, world: World, scene: Scene, i: number, first: number, shapeCount: number): void {
  const body = scene.bodies[i]!;
  const { x, y, cos, sin } = body;
  let isOther = rows.keepBody(tape, body);
  let isMoved = body.x !== x || body.y !== y || body.cos !== cos || body.sin !== sin;
  for (let k = 0; k < shapeCount; k += 1) {
    if (walkShape(tape, scene, scene.shapes[first + k]!)) {
      isOther = true;
      isMoved = true;
    }
  }
  body.massStale ||= isOther;
  if (isMoved) {
    body.moved();
    body.touchConstraints();
    body.rouseTies(world);
  }
}

/** Passes a shape. @returns whether its geometry or material is another now. */
function walkShape(tape: Tape, { materials, isCopy }: Scene, shape: Shape): boolean {
  const { material } = shape;
  if (tape.hashes) {
    tape.shared(rows.materialNumbers(material), Infinity);
    return rows.keepShape(tape, shape);
  }
  const which = tape.index(tape.holds ? 0 : material.stateIndex, materials.length);
  // A copy of a snapshot cannot tell materials with the same numbers apart: shapes keep theirs if it has the right numbers.
  if (tape.reads && !(isCopy && isMadeOf(material, rows.materialNumbers(materials[which]!)))) {
    shape.material = materials[which]!;
  }
  return rows.keepShape(tape, shape) || material !== shape.material;
}

const NONE: readonly Constraint[] = [];

/** Passes in what order a body has its constraints, and which of their bodies it is. Constraints of other worlds come first. */
function walkTies(tape: Tape, world: World, body: RigidBody, constraints: Constraint[]): void {
  const list = body.constraints;
  const own = tape.holds || list.length === 0 ? NONE : list.filter(({ owner }) => owner === world);
  const count = tape.count(own.length, constraints.length);
  if (count === 0) {
    return;
  }
  const found = new Set<Constraint>();
  for (let i = 0; i < count; i += 1) {
    const constraint = constraints[tape.index(own[i]?.index ?? 0, constraints.length)]!;
    const role = roleOf(constraint, body);
    tape.size(role, OTHER_BODIES);
    tape.require(!found.has(constraint) && role !== 0);
    found.add(constraint);
    if (tape.reads) {
      list.push(constraint);
    }
  }
}

/** A number for which of a constraint's bodies it is; 0 if none. In a custom constraint, it may be several. */
function roleOf({ members }: Constraint, body: RigidBody): number {
  let role = 0;
  for (let i = 0; i < members.length; i += 1) {
    if (members[i] === body) role = (Math.imul(role, 31) + i + 1) | 0;
  }
  return role;
}

/** Passes which objects are awake, in the order of the solver. */
function walkAwake<T extends RigidBody | Constraint>(tape: Tape, list: T[], all: T[], allCount: number): void {
  const count = tape.count(list.length, allCount);
  const found = new Uint8Array(allCount);
  for (let i = 0; i < count; i += 1) {
    const at = tape.index(tape.holds ? 0 : list[i]!.index, allCount);
    tape.require(found[at] === 0);
    found[at] = 1;
    if (tape.reads) {
      list[i] = all[at]!;
      list[i]!.liveIndex = i;
    }
  }
  if (tape.reads) {
    list.length = count;
  }
}

function walkIslands(tape: Tape, { islands, bodies, constraints, inside }: Scene): void {
  const count = tape.count(islands.length, inside + constraints.length);
  for (let i = 0; i < count; i += 1) {
    const island = tape.holds ? { number: -1, bodies: [], constraints: [] } : islands[i]!;
    walkMembers(tape, island.bodies, bodies, inside, island);
    walkMembers(tape, island.constraints, constraints, constraints.length, island);
  }
}

function walkMembers<T extends RigidBody | Constraint>(
  tape: Tape,
  list: T[],
  all: T[],
  allCount: number,
  island: NonNullable<RigidBody['island']>,
): void {
  const own = tape.holds ? list : list.filter((member) => member.island === island);
  const count = tape.count(own.length, allCount);
  for (let i = 0; i < count; i += 1) {
    const member = all[tape.index(tape.holds ? 0 : own[i]!.index, allCount)]!;
    if (tape.reads) {
      member.island = island;
      list.push(member);
    }
  }
}

/** Passes what woke since the last step, and was not reported yet. */
function walkWoken(tape: Tape, world: World, { bodies, constraints, inside }: Scene): void {
  const { woken } = world.events;
  const own = tape.holds ? [] : [...woken].filter((object) => object.woken && object.owner === world);
  const most = inside + constraints.length;
  const count = tape.count(own.length, most);
  for (let i = 0; i < count; i += 1) {
    const object = own[i];
    const at = object === undefined ? 0 : 'shapes' in object ? object.index : inside + object.index;
    const which = tape.index(at, most);
    if (tape.reads) {
      woken.add(which < inside ? bodies[which]! : constraints[which - inside]!);
    }
  }
}
