import * as g from '../../collide/layout.js';
import { BOUNCE_THRESHOLD, MOST_BEND } from '../../config.js';
import { batchOf, recordAt, type SolverData } from '../data.js';
import * as d from '../layout.js';

// Contacts have the normals and arms with which the step began. Of two bodies that turn together at a rate w, with a distance d between
// their centres, they would find after a time t that these approach at w²·d·t. What they make of that takes from the turn, and stops a ship
// of welded blocks within seconds. So the normal of such a contact turns with the bodies; arms, as seen from it, stay what they were, and
// with them all effective masses. Then bodies that move as one neither approach there nor slide, and both get the impulse at one place.
// Refused: arms that turn under a normal that stays (what presses on a wheel would turn it, and effective masses are those of other arms);
// a point half-way between where either body has carried it, which for a large and a small body is far from the small one, and throws it
// off.

/** Keeps of a contact what `layout.ts` lists for it. */
export function keepNormal(data: SolverData, contact: number): void {
  const { turning } = data;
  const { records: r, stride, arbiters } = batchOf(data, contact);
  const at = recordAt(contact >> 1, stride);
  const other = stride === d.TWO_STRIDE ? at + d.SECOND : at;
  const k = turning.add(contact);
  const { kept } = turning;
  kept[k + d.TURNING_NX] = r[at + d.NX]!;
  kept[k + d.TURNING_NY] = r[at + d.NY]!;
  kept[k + d.TURNING_START1] = r[at + d.START1]!;
  kept[k + d.TURNING_START2] = r[other + d.START1]!;
  kept[k + d.TURNING_SURFACE_N] = r[at + d.SURFACE_N]!;
  kept[k + d.TURNING_SURFACE_T] = r[at + d.SURFACE_T]!;
  const { numbers: n, at: o } = arbiters[contact >> 1]!;
  const began = n[o + g.NX]! * n[o + g.DX]! + n[o + g.NY]! * n[o + g.DY]!;
  kept[k + d.TURNING_BEGAN] = began;
  kept[k + d.TURNING_PIVOTS] = stride === d.TWO_STRIDE ? 0 : r[at + d.PIVOT_A]! - r[at + d.PIVOT_B]! - began;
}

/** Turns these contacts with their bodies, before a sub-step of length h. */
export function turnContacts(data: SolverData, h: number): void {
  const { contacts, count } = data.turning;
  for (let i = 0; i < count; i += 1) {
    turn(data, contacts[i]!, d.TURNING_STRIDE * i, h);
  }
}

/**
 * Turns a contact. What moves as one turns as both bodies do, and as the line between their centres; two wheels that rub on each other do
 * not. Separations are found from those at the start of the step along the normal of then: the difference that the new normal would make
 * goes into them, and so does what a circle, whose pivot is its centre, would seem to sink by while it moves along. What moves as one moves
 * along arcs, in a sub-step by −w²·h/2 times the distance between the centres off the tangents: by its velocity alone, what sits on a
 * platform that rocks would creep outwards, by 2 mm a second at 2 m. What bounces does not turn. Position sweeps take the way for straight,
 * too, and would push apart what joints hold together: between bodies that have joints the arc counts there as well.
 */
function turn(data: SolverData, contact: number, k: number, h: number): void {
  const { velocity: v, motion: q, traits, substeps } = data;
  const { kept } = data.turning;
  const { records: r, bodies, stride } = batchOf(data, contact);
  const at = recordAt(contact >> 1, stride);
  const other = stride === d.TWO_STRIDE ? at + d.SECOND : at;
  const a = bodies[contact & d.EVEN]! & d.OFFSET;
  const b = bodies[contact | 1]! & d.OFFSET;
  const nx = kept[k + d.TURNING_NX]!;
  const ny = kept[k + d.TURNING_NY]!;
  // From A's centre to B's, along n and t, as the step began and now.
  const beganN = kept[k + d.TURNING_BEGAN]!;
  const beganT = r[at + d.RN_B1]! - r[at + d.RN_A1]!;
  const dx = q[b + d.DX]! - q[a + d.DX]!;
  const dy = q[b + d.DY]! - q[a + d.DY]!;
  const alongN = beganN + nx * dx + ny * dy;
  const alongT = beganT + nx * dy - ny * dx;
  const square = alongN * alongN + alongT * alongT;
  if (!(square < Infinity)) {
    return;
  }
  const size = Math.sqrt(square * (beganN * beganN + beganT * beganT));
  const revolved = size > 0 ? (beganN * alongT - beganT * alongN) / size : 0;
  const s = leastOf(v[a + d.SIN]!, v[b + d.SIN]!, revolved);
  const c = Math.sqrt(Math.max(0, 1 - s * s));
  const turnedX = c * nx - s * ny;
  const turnedY = s * nx + c * ny;
  const apart = (nx - turnedX) * dx + (ny - turnedY) * dy + (c - 1) * kept[k + d.TURNING_PIVOTS]!;
  r[at + d.NX] = turnedX;
  r[at + d.NY] = turnedY;
  const vx = v[b + d.VX]! - v[a + d.VX]!;
  const vy = v[b + d.VY]! - v[a + d.VY]!;
  const vn = turnedX * vx + turnedY * vy;
  const comes = vn + r[at + d.RN_B1]! * v[b + d.W]! - r[at + d.RN_A1]! * v[a + d.W]!;
  const revolves = square > 0 ? (alongN * (nx * vy - ny * vx) - alongT * (nx * vx + ny * vy)) / square : 0;
  const w = comes > -BOUNCE_THRESHOLD ? leastOf(v[a + d.W]!, v[b + d.W]!, revolves) : 0;
  const areHeld = (traits[a / d.BODY_STRIDE]! & traits[b / d.BODY_STRIDE]! & d.LINKED) !== 0;
  const bend = (areHeld ? 1 : substeps) * h * Math.abs(w) < MOST_BEND ? 0.5 * h * w * w : 0;
  const bendN = bend * (c * alongN + s * alongT);
  const from = areHeld ? apart + h * bendN : apart;
  r[at + d.START1] = kept[k + d.TURNING_START1]! + from;
  r[other + d.START1] = kept[k + d.TURNING_START2]! + from;
  r[at + d.SURFACE_N] = kept[k + d.TURNING_SURFACE_N]! + bendN;
  r[at + d.SURFACE_T] = kept[k + d.TURNING_SURFACE_T]! + bend * (c * alongT - s * alongN);
}

/** The one nearest to 0 of three numbers of one sign, else 0. */
function leastOf(one: number, two: number, three: number): number {
  const least = Math.min(Math.abs(one), Math.abs(two), Math.abs(three));
  return one > 0 && two > 0 && three > 0 ? least : one < 0 && two < 0 && three < 0 ? -least : 0;
}
