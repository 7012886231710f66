import type { RigidBody } from '../body.js';
import type { Constraint } from '../constraint/constraint.js';
import type { Arbiter } from '../contact/arbiter.js';
import { AWAKE, DEAD } from '../contact/bits.js';
import type { Material } from '../material.js';
import { drop, release } from '../math/list.js';
import type { Shape } from '../shape/shape.js';
import type { Island } from '../solver/sleep.js';
import type { World } from '../world.js';

/** The objects of a state, in the order in which they pass over a tape. */
export interface Objects {
  /** The bodies of the world, then those of its constraints that are in no world. */
  readonly bodies: RigidBody[];
  /** How many bodies are in the world. */
  inside: number;
  /** The shapes of the bodies in the world, body by body, then those that only an event names. */
  readonly shapes: Shape[];
  /** How many shapes each body in the world has. */
  readonly counts: number[];
  readonly constraints: Constraint[];
  readonly materials: Material[];
}

/** … and what is derived from them. */
export interface Scene extends Objects {
  /** How many shapes are in the world. */
  attached: number;
  /** The objects were found from the bytes of a snapshot alone, not known from when it was taken. */
  isCopy: boolean;
  /**
   * All pairs, without those of shapes that left, which the next step drops: awake ones in the order of their shapes' ids, sleeping ones,
   * then those that were cut off and that an event names.
   */
  readonly pairs: Arbiter[];
  /** How many of the pairs are awake. */
  awake: number;
  readonly islands: Island[];
}

export function emptyScene(): Scene {
  return {
    bodies: [],
    inside: 0,
    shapes: [],
    attached: 0,
    isCopy: false,
    counts: [],
    constraints: [],
    materials: [],
    pairs: [],
    awake: 0,
    islands: [],
  };
}

/** Lists everything in a world between two steps. */
export function gather(world: World, scene: Scene): void {
  const { bodies, shapes, counts, constraints, materials, islands } = scene;
  for (const list of [constraints, materials, islands]) {
    drop(list);
  }
  replace(bodies, world.rigidBodies);
  scene.inside = bodies.length;
  scene.attached = 0;
  for (let i = 0; i < scene.inside; i += 1) {
    const body = bodies[i]!;
    counts[i] = body.shapes.length;
    for (const shape of body.shapes) {
      addShape(scene, shape, scene.attached);
      scene.attached += 1;
    }
    noteIsland(scene, body);
  }
  counts.length = scene.inside;
  shapes.length = scene.attached;
  const outside = new Set<RigidBody>();
  for (const constraint of world.constraints) {
    constraints.push(constraint);
    noteIsland(scene, constraint);
    for (const body of constraint.members) {
      if (body.owner === null) outside.add(body);
    }
  }
  for (const body of outside) {
    bodies.push(body);
  }
  gatherPairs(world, scene);
}

/** Empties the lists, so that nothing is kept alive by them. */
export function releaseScene({ bodies, shapes, constraints, materials, pairs, islands }: Scene): void {
  for (const list of [bodies, shapes, constraints, materials, pairs, islands]) {
    release(list, 0);
  }
}

/** Copies the lists of objects. */
export function copyObjects(from: Objects, to: Objects): void {
  replace(to.bodies, from.bodies);
  replace(to.shapes, from.shapes);
  replace(to.constraints, from.constraints);
  replace(to.materials, from.materials);
}

/** Replaces the entries of a list in place: to empty and refill a list of thousands takes three times as long. */
function replace<T>(list: T[], by: readonly T[]): void {
  for (let i = 0; i < by.length; i += 1) {
    list[i] = by[i]!;
  }
  list.length = by.length;
}

function addShape({ shapes, materials }: Scene, shape: Shape, at: number): void {
  shapes[at] = shape;
  shape.stateIndex = at;
  const { material } = shape;
  if (materials[material.stateIndex] !== material) {
    material.stateIndex = materials.push(material) - 1;
  }
}

function noteIsland({ islands }: Scene, { island }: RigidBody | Constraint): void {
  if (island !== null && islands[island.number] !== island) {
    island.number = islands.push(island) - 1;
  }
}

function isIn(world: World, { owner }: Shape): boolean {
  return owner !== null && owner.owner === world;
}

function gatherPairs(world: World, scene: Scene): void {
  const { pairs, shapes } = scene;
  const { sorted, table } = world.pairs;
  world.pairs.merge();
  let sleeping = table.size;
  let count = 0;
  for (let i = 0; i < sorted.count; i += 1) {
    const pair = sorted.items[i]!;
    if (!pair.is(DEAD)) {
      sleeping -= 1;
      if (isIn(world, pair.shapeA) && isIn(world, pair.shapeB)) {
        pairs[count] = pair;
        count += 1;
      }
    }
  }
  pairs.length = count;
  scene.awake = count;
  for (let i = 0; i < scene.attached && sleeping > 0; i += 1) {
    const { arbiters } = shapes[i]!;
    for (let k = 0; k < arbiters.length; k += 1) {
      const pair = arbiters[k]!;
      if (!pair.is(AWAKE) && pair.indexA === k && pair.shapeA === shapes[i]) {
        pairs.push(pair);
      }
    }
  }
  const { ended } = world.events;
  for (let i = 0; i < ended.count; i += 1) {
    const pair = ended.all[i]!.arbiter!;
    for (const shape of [pair.shapeA, pair.shapeB]) {
      if (shapes[shape.stateIndex] !== shape) {
        addShape(scene, shape, shapes.length);
      }
    }
    pairs.push(pair);
  }
}
