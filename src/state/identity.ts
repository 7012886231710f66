import { RigidBody } from '../body.js';
import { bringPolygons } from '../collide/polygon-works.js';
import { Constraint } from '../constraint/constraint.js';
import { createBoxVertices } from '../geometry/vertices.js';
import { Circle } from '../shape/circle.js';
import { Polygon } from '../shape/polygon.js';
import { Shape } from '../shape/shape.js';
import { CIRCLE } from '../shape/shape-kind.js';
import { polygonWorks } from '../solver/polygons.js';
import type { World } from '../world.js';
import { copyObjects, emptyScene, type Objects, type Scene } from './scene.js';
import type { Tape } from './tape.js';

/** Why a snapshot does not fit these objects. */
export const OTHER_BODIES = 'a constraint of it has other bodies';

/** How many integers come before those of single objects. */
export const HEAD = 6;

/**
 * Writes which objects a snapshot is of, as integers. First how many integers follow, then `nextOrder`, and the numbers of bodies in the
 * world, bodies outside, shapes, shapes that only an event names, and constraints. Then for each body in the world its `order` and number
 * of shapes; for each shape its `order`, and its kind plus twice the rank of its id, with all bits inverted for a sensor; for each
 * constraint its `order`; and for each body outside the index of a constraint, and of the body among its members.
 */
export function describe(tape: Tape, world: World, scene: Scene): void {
  const { bodies, inside, shapes, attached, counts, constraints } = scene;
  const ties = constraints.length;
  tape.word(lengthOf(bodies.length, shapes.length, ties));
  for (const word of [world.nextOrder, inside, bodies.length - inside, attached, shapes.length - attached, ties]) {
    tape.word(word);
  }
  for (let i = 0; i < inside; i += 1) {
    tape.word(bodies[i]!.order);
    tape.word(counts[i]!);
  }
  const ranks = ranksOf(shapes);
  for (let i = 0; i < shapes.length; i += 1) {
    tape.word(shapes[i]!.order);
    tape.word(turned(shapes[i]!.kind + 2 * ranks[i]!, shapes[i]!.sensor));
  }
  for (const { order } of constraints) {
    tape.word(order);
  }
  // They are listed in the order in which constraints name them first.
  let which = 0;
  for (const body of bodies.slice(inside)) {
    while (!constraints[which]!.members.includes(body)) which += 1;
    tape.word(which);
    tape.word(constraints[which]!.members.indexOf(body));
  }
}

/** Inverts all bits of a word if it is of a sensor; also back. */
export function turned(word: number, isSensor: boolean): number {
  return isSensor ? ~word : word;
}

/** How many integers describe so many objects. */
function lengthOf(bodies: number, shapes: number, constraints: number): number {
  return HEAD + 2 * bodies + 2 * shapes + constraints;
}

/** The rank of each shape by its id, which decides the order in which pairs are solved. */
export function ranksOf(shapes: readonly { readonly id: number }[]): number[] {
  const ranks: number[] = [];
  let isSorted = true;
  for (let i = 0; i < shapes.length; i += 1) {
    ranks.push(i);
    isSorted &&= i === 0 || shapes[i]!.id > shapes[i - 1]!.id;
  }
  if (!isSorted) {
    ranks
      .sort((a, b) => shapes[a]!.id - shapes[b]!.id)
      .slice()
      .forEach((shape, rank) => {
        ranks[shape] = rank;
      });
  }
  return ranks;
}

/**
 * Fills `scene` with the objects that `ids` describes: the known ones or, for a copy of a snapshot, those with the same `order` in the
 * world or in `held`.
 */
export function resolve(
  tape: Tape,
  world: World,
  ids: Int32Array,
  known: Objects | null,
  held: Iterable<unknown>,
  scene: Scene,
): void {
  const [, inside = -1, outside = -1, attached = -1, loose = -1, ties = -1] = ids;
  const isWhole =
    Math.min(inside, outside, attached, loose, ties) >= 0 &&
    ids.length === lengthOf(inside + outside, attached + loose, ties);
  tape.require(isWhole);
  const { counts } = scene;
  scene.inside = inside;
  scene.attached = attached;
  scene.isCopy = known === null;
  for (let i = 0; i < inside; i += 1) {
    counts[i] = ids[HEAD + 2 * i + 1]!;
  }
  counts.length = inside;
  if (known === null) {
    copyObjects(emptyScene(), scene);
    find(tape, ids, scene, new Finder(tape, world, held));
  } else {
    copyObjects(known, scene);
  }
  refuseOthers(tape, world, scene);
}

function find(tape: Tape, ids: Int32Array, scene: Scene, finder: Finder): void {
  const [, inside = 0, outside = 0, attached = 0, loose = 0, ties = 0] = ids;
  const { bodies, shapes, counts, constraints } = scene;
  let at = HEAD;
  for (let i = 0; i < inside; i += 1, at += 2) {
    bodies.push(finder.find(ids[at]!, RigidBody, 'a body'));
  }
  tape.require(counts.reduce((sum, own) => sum + Math.max(0, own), 0) === attached);
  const ranked: Shape[] = [];
  for (let i = 0; i < attached + loose; i += 1, at += 2) {
    const sensor = ids[at + 1]! < 0;
    const word = turned(ids[at + 1]!, sensor);
    const kind = word & 1;
    const shape =
      i < attached ? finder.find(ids[at]!, Shape, 'a shape') : (finder.loose(ids[at]!, kind) ?? standIn(kind));
    demand(tape, shape.kind === kind, 'a shape of it is of another kind');
    shapes.push(shape);
    if (i < attached) {
      demand(tape, shape.sensor === sensor, 'a shape of it is a sensor, or is none here');
      ranked[word >> 1] = shape;
    }
  }
  for (let i = 0; i < ties; i += 1, at += 1) {
    constraints.push(finder.find(ids[at]!, Constraint, 'a constraint'));
  }
  for (let i = 0; i < outside; i += 1, at += 2) {
    const body = constraints[ids[at]!]?.members[ids[at + 1]!];
    demand(tape, body !== undefined, OTHER_BODIES);
    bodies.push(body!);
  }
  demand(tape, areAscending(ranked, attached), 'its shapes were created in another order');
}

/** Refuses objects that are in another world now, as they cannot come back. A shape that only an event names need not. */
function refuseOthers(tape: Tape, world: World, { bodies, shapes, constraints, attached }: Scene): void {
  const isForeign = ({ owner }: RigidBody | Constraint) => isOther(world, owner);
  let isRefused = constraints.some(isForeign) || bodies.some(isForeign);
  for (let i = 0; i < attached; i += 1) {
    isRefused ||= isElsewhere(world, shapes[i]!);
  }
  demand(tape, !isRefused, 'an object of it is in another world now');
}

/** Refuses a snapshot that is not damaged, but is of another world. */
function demand(tape: Tape, holds: boolean, otherwise: string): void {
  if (!holds) {
    throw tape.refusal(otherwise);
  }
}

/** Whether the body of a shape is in another world. */
export function isElsewhere(world: World, { owner }: Shape): boolean {
  return isOther(world, owner?.owner);
}

function isOther(world: World, owner: World | null | undefined): boolean {
  return owner !== undefined && owner !== null && owner !== world;
}

/**
 * A shape in place of one that was gone when a snapshot was taken, and that its bytes cannot name: so that other shapes can still be told
 * that they parted from it.
 */
export function standIn(kind: number): Shape {
  const vertices = createBoxVertices(1, 1);
  bringPolygons(polygonWorks);
  const shape = kind === CIRCLE ? new Circle({ radius: 1 }) : new Polygon({ vertices });
  // Handlers ask whose it was.
  shape.former = new RigidBody({});
  return shape;
}

/** Whether no shape is missing, and each has a higher id than the one before. */
function areAscending(ranked: Shape[], count: number): boolean {
  const shapes = Object.values(ranked);
  return shapes.length === count && shapes.every(({ id }, i) => i === 0 || id > shapes[i - 1]!.id);
}

/** Looks objects up by their `order`. */
class Finder {
  private readonly found = new Map<number, object>();

  constructor(
    private readonly tape: Tape,
    world: World,
    held: Iterable<unknown>,
  ) {
    // After a restore, several objects may have the same `order`: then the one that is held is meant.
    for (const list of [world.rigidBodies, world.constraints, held]) {
      for (const object of list) {
        this.add(object);
      }
    }
  }

  private add(object: unknown): void {
    if (object instanceof RigidBody) {
      object.shapes.forEach(this.add, this);
    }
    if ((object instanceof RigidBody || object instanceof Shape || object instanceof Constraint) && object.order > 0) {
      this.found.set(object.order, object);
    }
  }

  /** A shape that was gone when the snapshot was taken, if it is held; else `null`. */
  loose(order: number, kind: number): Shape | null {
    const object = this.found.get(order);
    return object instanceof Shape && object.kind === kind ? object : null;
  }

  find<T>(order: number, kind: abstract new (...args: never[]) => T, name: string): T {
    const object = this.found.get(order);
    if (!(object instanceof kind)) {
      throw this.tape.refusal(`${name} of it, number ${order}, is neither in the world nor among those that are held`);
    }
    this.found.delete(order);
    return object;
  }
}
