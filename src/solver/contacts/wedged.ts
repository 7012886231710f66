import type { RigidBody } from '../../body.js';
import { DYNAMIC } from '../../body-kind.js';
import { Along, separationAlong } from '../../collide/along.js';
import * as g from '../../collide/layout.js';
import { findLeastSeparation, leastSeparation } from '../../collide/manifold.js';
import { endOfEdges } from '../../collide/polygons.js';
import { WEDGED_DEPTH } from '../../config.js';
import type { Arbiter } from '../../contact/arbiter.js';
import { LOOKED_AT } from '../../contact/bits.js';
import * as c from '../../contact/layout.js';
import { updateManifoldAlong } from '../../contact/update.js';
import { EDGE_NX, EDGE_NY, EDGE_STRIDE, EDGES } from '../../geometry/layout.js';
import type { Vec2 } from '../../math/vectors.js';
import { halfWidthOf, type Shape } from '../../shape/shape.js';
import { POLYGON } from '../../shape/shape-kind.js';
import type { World } from '../../world.js';

// Where a body of several shapes got deep into another body, each contact asks for the shortest way out of one shape, which may lead into
// the next. Then their pushes cancel out, and both bodies stay in each other for good. So what stands in the way of the shortest way out of
// all of them is turned along that. It happens so rarely that it may allocate.

/** The least cosine of the angle between the way out and a push along it. */
const ALONG = 0.5;

/** The sine of an angle that counts as none; and by the sine of which angle the directions of pushes along one way are short of half a turn. */
const SAME = 1e-3;
const OPENING = 0.5;

/** By what share ways are taken as shorter that lead to where the other body is already, or went last: else the choice would go to and fro. */
const ONWARDS = 0.25;

/** m. A way that tells a direction is longer. */
const LEAST_WAY = 1e-3;

/**
 * m²/s². Bodies that move faster relative to each other are not held yet: what is pressed into each other by a load would sink in where its
 * contacts are turned.
 */
const MOST_SPEED_SQUARED = 0.25;

/**
 * m/s. Contacts of two bodies whose impulses together would give these more in a sub-step are not turned: they carry a load, about as much
 * as two hundred of their like weigh. With 4 some are left in each other at the bottom of a heap, of 16,800 Us, gears and others 28 instead of 4.
 */
const MOST_LOAD = 15;

const along = /* @__PURE__ */ new Along();

/** What a contact of two bodies, a and b, does to b: it pushes it along (x, y). */
class Push {
  readonly x: number;
  readonly y: number;
  readonly depth: number;

  /** `sign` is 1 if body A of the pair is a, else −1. */
  constructor(
    readonly pair: Arbiter,
    readonly sign: number,
  ) {
    const { numbers: n, at: o } = pair;
    this.x = sign * n[o + g.NX]!;
    this.y = sign * n[o + g.NY]!;
    findLeastSeparation(n, o);
    this.depth = -leastSeparation[0]!;
  }

  /** Whether its shapes are so deep in each other that they will be pushed apart the other way once they have moved a little. */
  isUnsure(): boolean {
    const { shapeA, shapeB } = this.pair;
    return this.depth > Math.min(halfWidthOf(shapeA), halfWidthOf(shapeB));
  }

  /** Whether the direction of another push is the same, or to the left by less than what leaves a way along both. */
  opensTo({ x, y }: Push): boolean {
    const sine = this.x * y - this.y * x;
    return sine >= (this.x * x + this.y * y < 0 ? OPENING : -SAME);
  }

  /** Whether it is in the way of b along (x, y): it does not push b along, and b does not just slide along it. */
  blocks([x, y]: Vec2): boolean {
    const cosine = this.x * x + this.y * y;
    return cosine <= ALONG && (cosine < -ALONG || this.depth > WEDGED_DEPTH);
  }

  /** How far b has to go along (x, y) until it is past this, m. */
  wayAlong(way: Vec2): number {
    const [x, y] = way;
    if (!this.blocks(way)) {
      return this.depth / Math.max(ALONG, this.x * x + this.y * y);
    }
    const { numbers: n, at: o, shapeA, shapeB } = this.pair;
    along.x = this.sign * x;
    along.y = this.sign * y;
    along.dx = n[o + g.DX]!;
    along.dy = n[o + g.DY]!;
    separationAlong(shapeA, shapeB, along);
    return -along.found;
  }

  turn([x, y]: Vec2): void {
    const { numbers: n, at: o } = this.pair;
    n[o + g.NX] = this.sign * x;
    n[o + g.NY] = this.sign * y;
    updateManifoldAlong(this.pair);
  }
}

/** Notes an accepted contact, if it is deep and one of its bodies has several shapes. */
export function noteDeep(world: World, pair: Arbiter): void {
  findLeastSeparation(pair.numbers, pair.at);
  if (leastSeparation[0]! < -WEDGED_DEPTH && (pair.bodyA.shapes.length > 1 || pair.bodyB.shapes.length > 1)) {
    pair.unmark(LOOKED_AT);
    world.deep.add(pair);
  }
}

/** Turns those contacts of the bodies of deep ones that hold these in each other. */
export function partWedged({ deep }: World): void {
  for (let i = 0; i < deep.count; i += 1) {
    const pair = deep.items[i]!;
    if (!pair.is(LOOKED_AT)) {
      const { bodyA, bodyB } = pair;
      if (bodyB.kind === DYNAMIC) part(bodyA, bodyB);
      else part(bodyB, bodyA);
    }
  }
}

/** The same for the contacts of two bodies, of which b is dynamic. */
function part(a: RigidBody, b: RigidBody): void {
  if (!areFree(a, b)) {
    return;
  }
  const pushes = pushesOn(b, a);
  for (const { pair } of pushes) pair.mark(LOOKED_AT);
  if (!bear(pushes) && areWedged(pushes)) {
    const way = findWayOut(pushes, a, b);
    for (const push of pushes) {
      if (push.blocks(way)) push.turn(way);
    }
  }
}

function pushesOn(b: RigidBody, a: RigidBody): Push[] {
  return b.shapes
    .flatMap(({ arbiters }) => arbiters)
    .filter((pair) => pair.isSolid() && (pair.bodyA === a || pair.bodyB === a))
    .map((pair) => new Push(pair, pair.bodyA === a ? 1 : -1));
}

/** Whether no joint holds both bodies where they are, and they do not just run into each other. Asked of many, so it allocates nothing. */
function areFree(a: RigidBody, b: RigidBody): boolean {
  const x = b.vx - a.vx;
  const y = b.vy - a.vy;
  if (!(x * x + y * y < MOST_SPEED_SQUARED)) {
    return false;
  }
  for (const { enabled, members } of b.constraints) {
    if (enabled && members.includes(a)) return false;
  }
  return true;
}

/** Whether pushes carry a load: turned, they would let it through. What they only hold against each other counts as none. */
function bear(pushes: readonly Push[]): boolean {
  const sum: Vec2 = [0, 0];
  for (const { x, y, pair } of pushes) {
    const { numbers: n, at: o } = pair;
    const impulse = n[o + c.NORMAL]! + n[o + c.NORMAL + c.IMPULSES]!;
    sum[0] += x * impulse;
    sum[1] += y * impulse;
  }
  const { bodyA, bodyB } = pushes[0]!.pair;
  return Math.sqrt(sum[0] * sum[0] + sum[1] * sum[1]) * (bodyA.inverseMass() + bodyB.inverseMass()) > MOST_LOAD;
}

/** Whether there is no way along all pushes, or will be none. */
function areWedged(pushes: readonly Push[]): boolean {
  return pushes.some((push) => push.isUnsure()) || !pushes.some((push) => pushes.every((other) => push.opensTo(other)));
}

/** The direction in which b gets out of a the soonest: across an edge of one of the shapes; for circles, along or across a push. */
function findWayOut(pushes: readonly Push[], a: RigidBody, b: RigidBody): Vec2 {
  const there: Vec2 = directionOf(b.x - a.x, b.y - a.y);
  const onwards = directionOf(b.lastDx - a.lastDx, b.lastDy - a.lastDy);
  let best: Vec2 = there;
  let least = Infinity;
  for (const way of pushes.flatMap(waysOf)) {
    const [x, y] = way;
    const gone = x * (there[0] + onwards[0]) + y * (there[1] + onwards[1]);
    const length = (1 - ONWARDS * gone) * Math.max(...pushes.map((push) => push.wayAlong(way)));
    if (length < least) {
      least = length;
      best = way;
    }
  }
  return best;
}

/** The unit vector along a way, or [0, 0] if that is hardly any. */
function directionOf(x: number, y: number): Vec2 {
  const length = Math.sqrt(x * x + y * y);
  return length > LEAST_WAY ? [x / length, y / length] : [0, 0];
}

function waysOf({ pair: { shapeA, shapeB }, x, y }: Push): Vec2[] {
  const areRound = shapeA.kind !== POLYGON && shapeB.kind !== POLYGON;
  const ways: Vec2[] = areRound
    ? [
        [x, y],
        [-y, x],
      ]
    : [...normalsOf(shapeA), ...normalsOf(shapeB)];
  return ways.flatMap(([x, y]) => [
    [-x, -y],
    [x, y],
  ]);
}

function normalsOf(shape: Shape): Vec2[] {
  const normals: Vec2[] = [];
  const { numbers: edges, at } = shape;
  for (let k = at + EDGES; shape.kind === POLYGON && k < endOfEdges(shape); k += EDGE_STRIDE) {
    normals.push([edges[k + EDGE_NX]!, edges[k + EDGE_NY]!]);
  }
  return normals;
}
