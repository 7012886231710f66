import type { RigidBody } from '../body.js';
import { DYNAMIC, KINEMATIC, STATIC } from '../body-kind.js';
import type { BroadphaseHandle } from '../broadphase/broadphase.js';
import { SPECULATIVE_MARGIN } from '../config.js';
import type { Constraint } from '../constraint/constraint.js';
import { EDGE_STRIDE } from '../geometry/layout.js';
import type { Circle } from '../shape/circle.js';
import type { Polygon } from '../shape/polygon.js';
import type { Shape } from '../shape/shape.js';
import type { Audit } from './audit.js';

/** How far the length of a unit vector may be from 1, if it was computed from finite numbers of any size. */
export const UNIT_TOLERANCE = 1e-9;

/** The handles of our own broadphases. */
interface Bounded extends BroadphaseHandle {
  readonly minX: number;
  readonly minY: number;
  readonly maxX: number;
  readonly maxY: number;
}

/** Checks bodies and their shapes: lists, sleeping, numbers, bounds. */
export function auditBodies(audit: Audit): void {
  const { world } = audit;
  const { rigidBodies, liveDynamics, liveKinematics } = world;
  const stale = new Set(world.stale.items.slice(0, world.stale.count));
  audit.distinct(rigidBodies, world, 'rigidBodies');
  rigidBodies.forEach((body, i) => {
    audit.demand(body.owner === world, body, 'must know its world');
    audit.demand(body.index === i, body, `index must be ${i}, got ${body.index}`);
    auditSleeping(audit, body);
    auditNumbers(audit, body);
    audit.demand(!body.placeStale || stale.has(body), body, 'was moved, but is not among those to be refreshed');
    audit.distinct(body.shapes, body, 'shapes');
    for (const shape of body.shapes) {
      audit.demand(shape.owner === body, shape, 'must know its body');
      auditShape(audit, body, shape);
    }
  });
  auditIslands(audit);
  for (const [list, kind] of [
    [liveDynamics, DYNAMIC],
    [liveKinematics, KINEMATIC],
  ] as const) {
    list.forEach((body, i) => {
      audit.demand(body.owner === world && rigidBodies[body.index] === body, body, 'is live, but not in the world');
      audit.demand(body.kind === kind && !body.asleep, body, 'is in a live list that it does not belong to');
      audit.demand(body.liveIndex === i, body, `liveIndex must be ${i}, got ${body.liveIndex}`);
    });
  }
}

function auditSleeping(audit: Audit, body: RigidBody): void {
  const { world } = audit;
  const { kind, asleep, island } = body;
  audit.demand(kind === DYNAMIC || kind === KINEMATIC || kind === STATIC, body, `has no type ${kind}`);
  const live = kind === DYNAMIC ? world.liveDynamics : world.liveKinematics;
  audit.demand(asleep || (kind !== STATIC && live[body.liveIndex] === body), body, 'is awake, but in no live list');
  audit.demand(!asleep || body.liveIndex === -1, body, 'is asleep, but has a place in a live list');
  audit.demand(kind !== STATIC || (body.vx === 0 && body.vy === 0 && body.w === 0), body, 'is static, but moves');
  if (island !== null) {
    audit.demand(asleep && kind === DYNAMIC, body, 'is in an island, but does not sleep there');
  }
  const isNoted = !body.woken || world.events.woken.has(body);
  audit.demand(isNoted, body, 'waits for a wake event that is not noted');
}

/** Checks that what fell asleep together sleeps together. */
function auditIslands(audit: Audit): void {
  const { rigidBodies, constraints } = audit.world;
  const members = [...rigidBodies, ...constraints].filter(({ island }) => island !== null);
  const listed = new Set<RigidBody | Constraint>();
  for (const island of new Set(members.map((member) => member.island!))) {
    for (const member of [...island.bodies, ...island.constraints]) {
      listed.add(member);
      const sleeps = member.island === island && member.owner === audit.world && member.asleep;
      audit.demand(sleeps, member, 'left an island that sleeps on');
    }
  }
  for (const member of members) {
    audit.demand(listed.has(member), member, 'must be in its island');
  }
}

function auditNumbers(audit: Audit, body: RigidBody): void {
  audit.finite(body, 'position x', body.x);
  audit.finite(body, 'position y', body.y);
  audit.finite(body, 'rotation', body.angle);
  const turn = body.cos * body.cos + body.sin * body.sin;
  audit.demand(Math.abs(turn - 1) <= UNIT_TOLERANCE, body, 'cosine and sine must be those of an angle');
  audit.finite(body, 'velocity x', body.vx);
  audit.finite(body, 'velocity y', body.vy);
  audit.finite(body, 'angular velocity', body.w);
  audit.finite(body, 'force x', body.fx);
  audit.finite(body, 'force y', body.fy);
  audit.finite(body, 'torque', body.appliedTorque);
  audit.finite(body, 'applied force x', body.applied?.x ?? 0);
  audit.finite(body, 'applied force y', body.applied?.y ?? 0);
  audit.finite(body, 'applied torque', body.applied?.torque ?? 0);
  audit.finite(body, 'gravity scale', body.gravityScale);
  audit.finite(body, 'motion x', body.lastDx);
  audit.finite(body, 'motion y', body.lastDy);
  audit.finite(body, 'turn', body.lastTurn);
  if (!body.massStale) {
    audit.nonNegative(body, 'mass', body.mass);
    audit.nonNegative(body, 'inertia', body.inertia);
    audit.finite(body, 'radius', body.radius);
  } else {
    audit.demand(body.fixedMass === -1 || body.fixedMass > 0, body, 'fixed mass must be > 0');
  }
}

function auditShape(audit: Audit, body: RigidBody, shape: Shape): void {
  const { handle } = shape;
  audit.demand(handle !== null && handle.data === shape, shape, 'must have a handle in the broadphase that names it');
  const isRight = body.placeStale || handle!.isStatic === body.asleep;
  audit.demand(isRight, shape, 'its handle must be static just while its body sleeps');
  if (shape.type === 'CIRCLE') {
    auditCircle(audit, shape);
  } else {
    auditPolygon(audit, shape);
  }
  if (!body.placeStale) {
    auditBounds(audit, body, shape);
  }
}

function auditBounds(audit: Audit, body: RigidBody, shape: Shape): void {
  const { numbers: n, at, handle } = shape;
  // Computed as `broadphaseBounds` does, so that not a bit may differ.
  const half = SPECULATIVE_MARGIN / 2;
  const [minX, minY, maxX, maxY] = placedBounds(body, shape);
  const isPlaced = n[at] === minX && n[at + 1] === minY && n[at + 2] === maxX && n[at + 3] === maxY;
  audit.demand(isPlaced, shape, 'bounds must be those of its placement');
  const { minX: left, minY: top, maxX: right, maxY: bottom } = handle as Partial<Bounded>;
  if (left !== undefined) {
    const fits = left === minX - half && top === minY - half && right === maxX + half && bottom === maxY + half;
    audit.demand(fits, shape, 'its handle must have its bounds');
  }
}

function auditCircle(audit: Audit, circle: Circle): void {
  audit.demand(circle.radius > 0 && circle.radius < Infinity, circle, `radius must be > 0, got ${circle.radius}`);
  audit.finite(circle, 'origin x', circle.originX);
  audit.finite(circle, 'origin y', circle.originY);
}

function auditPolygon(audit: Audit, polygon: Polygon): void {
  const { vertices, localEdges, offsets } = polygon;
  const count = vertices.length / 2;
  audit.demand(count >= 3 && localEdges.length === EDGE_STRIDE * count, polygon, 'must have as many edges as corners');
  for (let i = 0; i < count; i += 1) {
    audit.finite(polygon, `corner ${i}`, vertices[2 * i]! + vertices[2 * i + 1]!);
    audit.finite(polygon, `offset of edge ${i}`, offsets[i]!);
    const nx = localEdges[EDGE_STRIDE * i + 2]!;
    const ny = localEdges[EDGE_STRIDE * i + 3]!;
    const isUnit = Math.abs(nx * nx + ny * ny - 1) <= UNIT_TOLERANCE;
    audit.demand(isUnit, polygon, `normal of edge ${i} must be a unit vector, got ${nx}, ${ny}`);
  }
}

/** The bounds of a shape from its geometry and where its body is, computed as `place` does. */
function placedBounds({ x, y, cos, sin }: RigidBody, shape: Shape): readonly [number, number, number, number] {
  if (shape.type === 'CIRCLE') {
    const { originX, originY, radius } = shape;
    const cx = cos * originX - sin * originY;
    const cy = sin * originX + cos * originY;
    return [x + cx - radius, y + cy - radius, x + cx + radius, y + cy + radius];
  }
  const { vertices } = shape;
  let [minX, minY, maxX, maxY] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let i = 0; i < vertices.length; i += 2) {
    const px = cos * vertices[i]! - sin * vertices[i + 1]!;
    const py = sin * vertices[i]! + cos * vertices[i + 1]!;
    minX = Math.min(minX, px);
    minY = Math.min(minY, py);
    maxX = Math.max(maxX, px);
    maxY = Math.max(maxY, py);
  }
  return [x + minX, y + minY, x + maxX, y + maxY];
}
