import type { Arbiter } from '../contact/arbiter.js';
import type { Contact } from '../contact/contact.js';
import { addCircle } from './curves.js';
import type { Physics2DDebugDraw } from './draw.js';
import type { Color } from './settings.js';

/** Scratch. */
const normal = /* @__PURE__ */ new Float64Array(2);
const point = /* @__PURE__ */ new Float64Array(2);
const other = /* @__PURE__ */ new Float64Array(2);

/** Adds the active contacts. A sensor has none, nor has a pair that does not touch any more. */
export function addContacts(debug: Physics2DDebugDraw, arbiters: readonly Arbiter[], color: Color): void {
  for (const arbiter of arbiters) {
    arbiter.getNormal(normal);
    debug.lines.setColor(color);
    addCapsule(debug, arbiter.contacts);
    if (debug.showContactImpulses) {
      addImpulses(debug, arbiter.contacts);
    }
  }
}

/** Adds a circle at each contact; two circles are joined along both sides. */
function addCapsule(debug: Physics2DDebugDraw, contacts: readonly Contact[]): void {
  const radius = debug.contactRadius * debug.screenToPhysics2D;
  let count = 0;
  for (const contact of contacts) {
    if (contact.active) {
      other.set(point);
      contact.getPosition(point);
      addCircle(debug, point[0]!, point[1]!, radius);
      count += 1;
    }
  }
  if (count === 2) {
    const nx = radius * normal[0]!;
    const ny = radius * normal[1]!;
    debug.lines.add(other[0]! + nx, other[1]! + ny, point[0]! + nx, point[1]! + ny);
    debug.lines.add(other[0]! - nx, other[1]! - ny, point[0]! - nx, point[1]! - ny);
  }
}

/** Adds the impulse that each contact gave to body B in the latest step. */
function addImpulses(debug: Physics2DDebugDraw, contacts: readonly Contact[]): void {
  const scale = debug.contactImpulseScale * debug.screenToPhysics2D;
  const nx = scale * normal[0]!;
  const ny = scale * normal[1]!;
  for (const contact of contacts) {
    if (contact.active) {
      contact.getPosition(point);
      const push = contact.getNormalImpulse();
      const rub = contact.getTangentImpulse();
      debug.lines.setColor(debug.normalImpulseColor);
      debug.lines.add(point[0]!, point[1]!, point[0]! + push * nx, point[1]! + push * ny);
      debug.lines.setColor(debug.frictionImpulseColor);
      debug.lines.add(point[0]!, point[1]!, point[0]! - rub * ny, point[1]! + rub * nx);
    }
  }
}
