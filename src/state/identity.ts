import { RigidBody } from '../body.js';
import { Constraint } from '../constraint/constraint.js';
import { createBoxVertices } from '../geometry/vertices.js';
import { Circle } from '../shape/circle.js';
import { Polygon } from '../shape/polygon.js';
import { Shape } from '../shape/shape.js';
import type { World } from '../world.js';
import { emptyScene, type Objects, type Scene } from './scene.js';
import type { Tape } from './tape.js';

/** How many integers come first. */
const HEAD = 6;

/**
 * Which objects a snapshot is of, as integers: `nextOrder`; how many bodies, bodies outside, shapes, shapes that only an event names,
 * constraints; then `order` and number of shapes of each body; `order`, kind and rank among the ids of each shape; `order` of each constraint;
 * and for each body outside a constraint and which of its members it is.
 */
export function describe(world: World, scene: Scene): number[] {
  const { bodies, inside, shapes, attached, counts, constraints } = scene;
  const ids = [world.nextOrder, inside, bodies.length - inside, attached, shapes.length - attached, constraints.length];
  for (let i = 0; i < inside; i += 1) {
    ids.push(bodies[i]!.order, counts[i]!);
  }
  const ranks = ranksOf(shapes);
  shapes.forEach((shape, i) => {
    ids.push(shape.order, shape.kind, ranks[i]!);
  });
  for (const { order } of constraints) {
    ids.push(order);
  }
  for (const body of bodies.slice(inside)) {
    const which = constraints.findIndex(({ members }) => members.includes(body));
    ids.push(which, constraints[which]!.members.indexOf(body));
  }
  return ids;
}

/** The place of each shape if they were sorted by their ids, as which decides in what order pairs are solved. */
export function ranksOf(shapes: readonly { readonly id: number }[]): number[] {
  const ranks = shapes.map((_, i) => i);
  if (shapes.some(({ id }, i) => i > 0 && id < shapes[i - 1]!.id)) {
    ranks
      .sort((a, b) => shapes[a]!.id - shapes[b]!.id)
      .slice()
      .forEach((shape, rank) => {
        ranks[shape] = rank;
      });
  }
  return ranks;
}

/** The objects that `ids` describe: those that are known to be meant or, of a copy of a snapshot, those of the same `order` in the world or in `held`. */
export function resolve(
  tape: Tape,
  world: World,
  ids: number[],
  known: Objects | null,
  held: Iterable<unknown>,
): Scene {
  const [, inside = -1, outside = -1, attached = -1, loose = -1, ties = -1] = ids;
  const isWhole =
    Math.min(inside, outside, attached, loose, ties) >= 0 &&
    ids.length === HEAD + 2 * inside + 3 * (attached + loose) + ties + 2 * outside;
  tape.require(isWhole);
  const finder = new Finder(tape, world, held, known === null);
  const scene: Scene = { ...emptyScene(), inside, attached, isCopy: known === null };
  const { bodies, shapes, counts, constraints } = scene;
  let at = HEAD;
  for (let i = 0; i < inside; i += 1, at += 2) {
    bodies.push(known?.bodies[i] ?? finder.find(ids[at]!, RigidBody, 'a body'));
    counts.push(ids[at + 1]!);
  }
  const count = counts.reduce((sum, own) => sum + Math.max(0, own), 0);
  tape.require(count === attached);
  const ranked: Shape[] = [];
  for (let i = 0; i < attached + loose; i += 1, at += 3) {
    const isGone = known === null && i >= attached;
    const shape = isGone ? standIn(ids[at + 1]!) : (known?.shapes[i] ?? finder.find(ids[at]!, Shape, 'a shape'));
    demand(tape, shape.kind === ids[at + 1], 'a shape of it is of another kind');
    shapes.push(shape);
    if (i < attached) {
      ranked[ids[at + 2]!] = shape;
    }
  }
  for (let i = 0; i < ties; i += 1, at += 1) {
    constraints.push(known?.constraints[i] ?? finder.find(ids[at]!, Constraint, 'a constraint'));
  }
  for (let i = 0; i < outside; i += 1, at += 2) {
    const body = known?.bodies[inside + i] ?? constraints[ids[at]!]?.members[ids[at + 1]!];
    demand(tape, body !== undefined, 'a constraint of it has other bodies');
    bodies.push(body!);
  }
  demand(tape, areAscending(ranked, attached), 'its shapes were created in another order');
  scene.materials.push(...(known?.materials ?? []));
  finder.refuseOthers(scene);
  return scene;
}

/** A right snapshot may be of another world than this. */
function demand(tape: Tape, holds: boolean, otherwise: string): void {
  if (!holds) {
    throw tape.refusal(otherwise);
  }
}

/** Its body is in another world. */
export function isElsewhere(world: World, { owner }: Shape): boolean {
  return isOther(world, owner?.owner);
}

function isOther(world: World, owner: World | null | undefined): boolean {
  return owner !== undefined && owner !== null && owner !== world;
}

/** A shape that was gone when a snapshot was taken, whose bytes cannot name it: so that other shapes may still be told that they parted from it. */
export function standIn(kind: number): Shape {
  const vertices = createBoxVertices(1, 1);
  return kind === 0 ? new Circle({ radius: 1 }) : new Polygon({ vertices });
}

/** No shape is missing, and each has a higher id than the one before. */
function areAscending(ranked: Shape[], count: number): boolean {
  const shapes = Object.values(ranked);
  return shapes.length === count && shapes.every(({ id }, i) => i === 0 || id > shapes[i - 1]!.id);
}

/** Looks objects up by their `order`. */
class Finder {
  private readonly found = new Map<number, object>();

  constructor(
    private readonly tape: Tape,
    private readonly world: World,
    held: Iterable<unknown>,
    isNeeded: boolean,
  ) {
    for (const list of isNeeded ? [held, world.rigidBodies, world.constraints] : []) {
      for (const object of list) {
        this.add(object);
      }
    }
  }

  private add(object: unknown): void {
    if (object instanceof RigidBody) {
      object.shapes.forEach(this.add, this);
    }
    if (object instanceof RigidBody || object instanceof Shape || object instanceof Constraint) {
      this.found.set(object.order, object);
    }
  }

  find<T>(order: number, kind: abstract new (...args: never[]) => T, name: string): T {
    const object = this.found.get(order);
    if (!(object instanceof kind)) {
      throw this.tape.refusal(`${name} of it, number ${order}, is neither in the world nor among those that are held`);
    }
    this.found.delete(order);
    return object;
  }

  /** What is in another world cannot come back; a shape that only an event names need not. */
  refuseOthers({ bodies, shapes, constraints, inside, attached }: Scene): void {
    const { world } = this;
    if (
      bodies.slice(0, inside).some(({ owner }) => isOther(world, owner)) ||
      bodies.slice(inside).some(({ owner }) => owner !== null) ||
      shapes.slice(0, attached).some((shape) => isElsewhere(world, shape)) ||
      constraints.some(({ owner }) => isOther(world, owner))
    ) {
      throw this.tape.refusal('an object of it is in another world now');
    }
  }
}
