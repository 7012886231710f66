import type { RigidBody } from '../body.js';
import type { Constraint } from '../constraint/constraint.js';
import type { Arbiter } from '../contact/arbiter.js';
import type { Material } from '../material.js';
import { drop } from '../math/list.js';
import type { Shape } from '../shape/shape.js';
import type { Island } from '../solver/sleep.js';
import type { World } from '../world.js';

/** The objects that a state is about, in the order in which a tape has them. */
export interface Objects {
  /** Those of the world, then those of its constraints that are in no world. */
  readonly bodies: RigidBody[];
  /** How many are in the world. */
  inside: number;
  /** Those of the bodies in the world, body after body, then those that only an event names. */
  readonly shapes: Shape[];
  /** How many each body in the world has. */
  readonly counts: number[];
  readonly constraints: Constraint[];
  readonly materials: Material[];
}

/** … and what is made of them. */
export interface Scene extends Objects {
  /** How many shapes are in the world. */
  attached: number;
  /** The objects were found by what the bytes of a snapshot say of them. */
  isCopy: boolean;
  /** Without those of shapes that left, which the next step drops. Awake ones in the order of their shapes' ids, then sleeping ones, then those that were cut off and are named by an event. */
  readonly pairs: Arbiter[];
  /** How many of them are awake. */
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

/** Lists what there is in a world between two steps. */
export function gather(world: World, scene: Scene): void {
  clear(scene);
  const { bodies, constraints } = scene;
  for (const body of world.rigidBodies) {
    bodies.push(body);
    scene.counts.push(body.shapes.length);
    for (const shape of body.shapes) {
      addShape(scene, shape);
    }
    noteIsland(scene, body);
  }
  scene.inside = bodies.length;
  scene.attached = scene.shapes.length;
  for (const constraint of world.constraints) {
    constraints.push(constraint);
    noteIsland(scene, constraint);
    for (const body of constraint.members) {
      if (body.owner === null && !bodies.includes(body, scene.inside)) {
        bodies.push(body);
      }
    }
  }
  gatherPairs(world, scene);
}

/** Forgets everything. */
export function clear(scene: Scene): void {
  const { bodies, shapes, counts, constraints, materials, pairs, islands } = scene;
  for (const list of [bodies, shapes, counts, constraints, materials, pairs, islands]) {
    drop(list);
  }
}

/** Lists the same objects elsewhere. */
export function copyObjects(from: Objects, to: Objects): void {
  replace(to.bodies, from.bodies);
  replace(to.shapes, from.shapes);
  replace(to.constraints, from.constraints);
  replace(to.materials, from.materials);
}

function replace<T>(list: T[], by: readonly T[]): void {
  for (let i = 0; i < by.length; i += 1) {
    list[i] = by[i]!;
  }
  list.length = by.length;
}

function addShape({ shapes, materials }: Scene, shape: Shape): void {
  shape.stateIndex = shapes.push(shape) - 1;
  if (materials[materials.length - 1] !== shape.material && !materials.includes(shape.material)) {
    materials.push(shape.material);
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
  const { sorted } = world.pairs;
  world.pairs.merge();
  for (let i = 0; i < sorted.count; i += 1) {
    const pair = sorted.items[i]!;
    if (!pair.dead && isIn(world, pair.shapeA) && isIn(world, pair.shapeB)) {
      pairs.push(pair);
    }
  }
  scene.awake = pairs.length;
  for (let i = 0; i < scene.attached; i += 1) {
    const { arbiters } = shapes[i]!;
    for (let k = 0; k < arbiters.length; k += 1) {
      const pair = arbiters[k]!;
      if (!pair.awake && pair.indexA === k && pair.shapeA === shapes[i]) {
        pairs.push(pair);
      }
    }
  }
  const { all, count } = world.events.ended;
  for (let i = 0; i < count; i += 1) {
    const pair = all[i]!.arbiter!;
    for (const shape of [pair.shapeA, pair.shapeB]) {
      if (shapes[shape.stateIndex] !== shape) {
        addShape(scene, shape);
      }
    }
    pairs.push(pair);
  }
}
