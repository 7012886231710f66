import { RigidBody } from '../body.js';
import { EASE_STEPS } from '../config-joints.js';
import { Constraint } from '../constraint/constraint.js';
import { drop } from '../math/list.js';
import { Shape } from '../shape/shape.js';
import { Group, resetJoints } from '../solver/joints/joint-data.js';
import { orderJoints } from '../solver/joints/order/order.js';
import { insertHandle } from '../solver/refresh.js';
import { leaveWorld, listIgnoring } from '../solver/ties.js';
import { instance, typeError } from '../validate.js';
import type { World } from '../world.js';
import type { WorldSaving } from '../world-state.js';
import { beginClaims } from './claims.js';
import { VERSION } from './format.js';
import { describe, HEAD, isElsewhere, ranksOf, resolve, turned } from './identity.js';
import { keepGroup, ROWS } from './rows.js';
import { copyObjects, emptyScene, gather, type Objects, releaseScene, type Scene } from './scene.js';
import { Tape } from './tape.js';
import { walk } from './walk.js';

/** Scratch. */
const tape = /* @__PURE__ */ new Tape(ROWS);
const scene = /* @__PURE__ */ emptyScene();

/**
 * The objects that a snapshot was taken of, as long as its buffer exists, and its checksum. While that is the same, these objects are the
 * ones that are meant, whatever became of them.
 */
interface Known extends Objects {
  checksum: string;
}

const known = /* @__PURE__ */ new WeakMap<ArrayBuffer, Known>();

/** A digest of everything that influences the future, as 16 hexadecimal digits. */
function hashOf(world: World): string {
  gather(world, scene);
  tape.hash();
  // Shapes that only an event names have no influence: other shapes are just told of them.
  const attached = scene.shapes.slice(0, scene.attached);
  const ofShapes = ranksOf(attached).map((rank, i) => turned(rank, attached[i]!.sensor));
  for (const ranks of [ofShapes, ranksOf(scene.constraints.map(({ order }) => ({ id: order })))]) {
    tape.word(ranks.length);
    for (let i = 0; i < ranks.length; i += 1) {
      tape.word(ranks[i]!);
    }
  }
  walk(tape, world, scene);
  walkGroups(tape, world);
  releaseScene(scene);
  return tape.hashed();
}

/** The snapshot of a world, in `target` if that is large enough. */
function snapshotOf(where: string, world: World, target: ArrayBuffer | undefined): ArrayBuffer {
  if (target !== undefined) {
    instance(where, 'target', target, ArrayBuffer, 'an ArrayBuffer');
  }
  gather(world, scene);
  tape.write();
  describe(tape, world, scene);
  walk(tape, world, scene);
  walkGroups(tape, world);
  const buffer = tape.written(target);
  remember(buffer);
  releaseScene(scene);
  return buffer;
}

function remember(buffer: ArrayBuffer): void {
  const found: Known = known.get(buffer) ?? { ...emptyScene(), checksum: '' };
  copyObjects(scene, found);
  found.checksum = tape.checksum;
  known.set(buffer, found);
}

/** Restores a world from a snapshot; nothing changes unless the snapshot is right. */
function restoreTo(
  where: string,
  world: World,
  snapshot: ArrayBuffer | ArrayBufferView,
  held: Iterable<unknown>,
): void {
  const list = checkedHeld(where, held);
  const buffer = ArrayBuffer.isView(snapshot) ? bytesOf(snapshot) : snapshot;
  instance(where, 'snapshot', buffer, ArrayBuffer, 'an ArrayBuffer or a view of one');
  tape.load(where, buffer);
  const found = known.get(buffer);
  const own = found?.checksum === tape.checksum ? found : null;
  const ids = tape.integers();
  const from = tape.passed;
  resolve(tape, world, ids, own, list, scene);
  if (own === null) {
    walk(tape, world, scene);
    walkGroups(tape, world);
    tape.finish();
  }
  if (scene.inside > 0) world.claimBroadphase(where);
  tape.read(from);
  empty(world, scene);
  assemble(world, scene, ids);
  walk(tape, world, scene);
  for (const constraint of scene.constraints) {
    listIgnoring(constraint, true);
  }
  walkGroups(tape, world);
  place(world, scene);
  releaseScene(scene);
  tape.unload();
}

/** A copy of a view, in a buffer of its own. */
function bytesOf({ buffer, byteOffset, byteLength }: ArrayBufferView): ArrayBuffer {
  return new Uint8Array(buffer, byteOffset, byteLength).slice().buffer;
}

function checkedHeld(where: string, held: unknown): (RigidBody | Shape | Constraint)[] {
  if (typeof held !== 'object' || held === null || !(Symbol.iterator in held)) {
    throw typeError(where, 'held', 'a list of bodies, shapes and constraints', held);
  }
  const list = [...(held as Iterable<unknown>)];
  const isRight = (each: unknown) => [RigidBody, Shape, Constraint].some((kind) => each instanceof kind);
  const wrong = list.findIndex((each) => !isRight(each));
  if (wrong >= 0) {
    throw typeError(where, `held[${wrong}]`, 'a RigidBody, Shape or Constraint', list[wrong]);
  }
  return list as (RigidBody | Shape | Constraint)[];
}

/** Passes what groups of joints carry over, unless they will be listed anew in the next step. */
function walkGroups(on: Tape, world: World): void {
  const { joints } = world.solver;
  const { groups } = joints;
  on.begins();
  on.checksOnto(true);
  const isListed = on.flag(!world.jointsStale);
  const count = on.count(isListed ? groups.length : 0);
  if (on.reads) {
    // Ordering them resets the impulses of constraints that do not act any more. If they are stale, that is left to the next step, as it
    // would have been.
    if (isListed) {
      orderJoints(world);
    } else {
      resetJoints(joints);
    }
    world.jointsStale = !isListed;
    world.jointsTouched = true;
  }
  for (let i = 0; i < count; i += 1) {
    keepGroup(on, on.checks || groups[i] === undefined ? new Group(0) : groups[i]!);
  }
  on.checksOnto(false);
  if (count > 0) joints.age = on.integer(joints.age, 0, EASE_STEPS);
}

/** Takes everything out of the world that is not to stay, and all relations between objects. */
function empty(world: World, { bodies, inside }: Scene): void {
  for (const constraint of world.constraints) {
    leaveWorld(constraint);
  }
  takeOutOthers(world, bodies, inside);
  beginClaims(world.pairs);
  world.events.clear();
  for (const list of [world.constraints, world.dynamicArbiters, world.staticArbiters]) {
    drop(list);
  }
}

/** Takes out of the world the bodies that are not to stay. Mostly all stay, in this order. */
function takeOutOthers(world: World, bodies: readonly RigidBody[], inside: number): void {
  const { rigidBodies } = world;
  let areSame = rigidBodies.length === inside;
  for (let i = 0; i < inside && areSame; i += 1) {
    areSame = rigidBodies[i] === bodies[i];
  }
  if (areSame) {
    return;
  }
  for (const body of rigidBodies) {
    body.index = -1;
  }
  for (let i = 0; i < inside; i += 1) {
    bodies[i]!.index = i;
  }
  for (const body of rigidBodies) {
    if (body.index < 0) {
      takeOut(world, body);
    }
  }
}

function takeOut(world: World, body: RigidBody): void {
  for (const shape of body.shapes) {
    world.broadphase.remove(shape.handle!);
  }
  body.leave();
}

/** Puts the bodies, their shapes and the constraints into the world. */
function assemble(world: World, { bodies, inside, shapes, counts, constraints }: Scene, ids: Int32Array): void {
  const known = new Set(constraints.length > 0 ? bodies : []);
  let at = HEAD;
  let first = 0;
  world.nextOrder = ids[0]!;
  for (let i = 0; i < inside; i += 1, at += 2) {
    const body = bodies[i]!;
    takeShapes(world, body, shapes, first, counts[i]!);
    first += counts[i]!;
    body.owner = world;
    body.order = ids[at]!;
    body.liveIndex = -1;
    body.slot = 0;
    body.island = null;
    world.rigidBodies[i] = body;
  }
  world.rigidBodies.length = inside;
  for (let i = 0; i < shapes.length; i += 1, at += 2) {
    if (isElsewhere(world, shapes[i]!)) {
      continue;
    }
    shapes[i]!.order = ids[at]!;
    drop(shapes[i]!.arbiters);
    shapes[i]!.grounds = null;
    shapes[i]!.groundStamp = -1;
  }
  for (let i = 0; i < constraints.length; i += 1, at += 1) {
    const constraint = constraints[i]!;
    constraint.owner = world;
    world.jointSolver = constraint.solver;
    constraint.order = ids[at]!;
    constraint.index = i;
    world.constraints.push(constraint);
    for (const body of constraint.members) {
      // For bodies of the snapshot, the order of this list passes over the tape. Other bodies were in another world, wherever they are now.
      if (!known.has(body) && !body.constraints.includes(constraint)) {
        body.constraints.push(constraint);
      }
    }
  }
}

/** Gives a body back the shapes it had, if it has others now. */
function takeShapes(world: World, body: RigidBody, shapes: readonly Shape[], first: number, count: number): void {
  let isSame = count === body.shapes.length;
  for (let i = 0; i < count && isSame; i += 1) {
    isSame = shapes[first + i] === body.shapes[i];
  }
  if (isSame) {
    return;
  }
  const own = shapes.slice(first, first + count);
  for (const shape of [...body.shapes, ...own]) {
    if (shape.owner !== null) {
      detach(world, shape);
    }
  }
  for (const shape of own) {
    body.claim(shape);
    body.shapes.push(shape);
  }
  body.massStale = true;
  body.placeStale = true;
}

function detach(world: World, shape: Shape): void {
  const { owner, handle } = shape;
  owner!.shapes.splice(owner!.shapes.indexOf(shape), 1);
  owner!.massStale = true;
  shape.detach();
  if (handle !== null) {
    world.broadphase.remove(handle);
    shape.leave();
    world.someLeft = true;
  }
}

/** Adds new shapes to the broadphase, and notes which bodies moved, for whoever asks next where they are. */
function place(world: World, { bodies, inside }: Scene): void {
  world.stale.clear();
  world.pushed.clear();
  for (let i = 0; i < inside; i += 1) {
    const body = bodies[i]!;
    body.refreshMass();
    if (body.asleep && body.applied !== null) world.pushed.add(body);
    for (const shape of body.shapes) {
      if (shape.handle === null) {
        body.place();
        insertHandle(world, shape);
      }
      body.placeStale ||= shape.handle!.isStatic !== body.asleep;
    }
    if (body.placeStale) {
      world.stale.add(body);
    }
  }
}

/** For `createWorld({ state: worldState })`: lets the world be saved, restored and hashed. Worlds that `phys2D` makes always can be. */
export const worldState: WorldSaving = {
  version: VERSION,
  bodyClass: RigidBody,
  hash: hashOf,
  snapshot: snapshotOf,
  restore: restoreTo,
};
