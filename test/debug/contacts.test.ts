import { describe, expect, it } from 'vitest';
import { phys2D, type World } from '../../src/index.js';
import { add, addFloor, boxBody, disc, heavy, near, plainBody, steps, weightless } from '../conformance/setting.js';
import { draw, polyline, runs, type Segment } from './recorder.js';

const PX = 1 / 60;
const RADIUS = 3 * PX;

function contacts(world: World, impulses = false): readonly Segment[] {
  return draw((debug) => {
    debug.showRigidBodies = false;
    debug.showContacts = true;
    debug.showContactImpulses = impulses;
    debug.drawWorld(world);
  });
}

/** A box of 2 × 1 m and 2 kg that lies on the floor, whose top is at y = 0.5. */
function boxOnFloor(): World {
  const world = heavy();
  addFloor(world);
  add(world, boxBody(2, 1, { mass: 2, position: [0, 0] }));
  steps(world, 30);
  return world;
}

describe('contacts', () => {
  it('are not shown unless asked for', () => {
    expect(
      draw((debug) => {
        debug.showRigidBodies = false;
        debug.drawWorld(boxOnFloor());
      }),
    ).toEqual([]);
  });

  it('of a box on the floor are two circles, joined on both sides', () => {
    const world = boxOnFloor();
    const segments = contacts(world);
    const perCircle = (segments.length - 2) / 2;
    expect(perCircle).toBe(Math.ceil(Math.PI / Math.acos(1 - 0.4 / 3)));
    const places = world.staticArbiters[0]!.contacts.map((contact) => contact.getPosition());
    expect(places).toHaveLength(2);
    for (const [i, [x, y]] of places.entries()) {
      for (const point of polyline(segments.slice(i * perCircle, (i + 1) * perCircle))) {
        near(Math.hypot(point[0] - x, point[1] - y), RADIUS, 1e-12);
      }
    }
    const [[x1, y1], [x2, y2]] = places as [[number, number], [number, number]];
    const [nx, ny] = world.staticArbiters[0]!.getNormal();
    near(Math.abs(ny), 1);
    near(segments.at(-2)!.ends, [x1 + RADIUS * nx, y1 + RADIUS * ny, x2 + RADIUS * nx, y2 + RADIUS * ny], 1e-12);
    near(segments.at(-1)!.ends, [x1 - RADIUS * nx, y1 - RADIUS * ny, x2 - RADIUS * nx, y2 - RADIUS * ny], 1e-12);
    expect(new Set(segments.map(({ color }) => String(color)))).toEqual(new Set(['0.5,0,1,0.7']));
  });

  it('of a ball is one circle; between dynamic bodies it has their colour', () => {
    const world = weightless();
    add(world, plainBody({ position: [0, 0], velocity: [1, 0] }), plainBody({ position: [0.99, 0] }));
    steps(world, 1);
    const segments = contacts(world);
    const [found] = runs(segments);
    expect(found!.color).toEqual([1, 0, 0.5, 0.7]);
    expect(segments).toHaveLength(Math.ceil(Math.PI / Math.acos(1 - 0.4 / 3)));
  });

  it('of dynamic bodies come first', () => {
    const world = heavy();
    addFloor(world);
    add(world, boxBody(1, 1, { position: [0, 0] }), boxBody(1, 1, { position: [0, -1] }));
    steps(world, 30);
    expect(runs(contacts(world)).map(({ color }) => color)).toEqual([
      [1, 0, 0.5, 0.7],
      [0.5, 0, 1, 0.7],
    ]);
  });

  it('have impulses along normal and tangent, in px per N·s', () => {
    const world = heavy();
    addFloor(world);
    add(world, boxBody(2, 1, { mass: 2, position: [0, 0], velocity: [3, 0] }));
    steps(world, 3);
    const [arbiter] = world.staticArbiters;
    const [nx, ny] = arbiter!.getNormal();
    const [, first, second, third, fourth] = runs(contacts(world, true));
    expect([first, second, third, fourth].map((run) => run!.color)).toEqual([
      [1, 0, 0, 1],
      [0, 0, 1, 1],
      [1, 0, 0, 1],
      [0, 0, 1, 1],
    ]);
    for (const [contact, normal, friction] of [
      [arbiter!.contacts[0]!, first!, second!],
      [arbiter!.contacts[1]!, third!, fourth!],
    ] as const) {
      const [x, y] = contact.getPosition();
      const push = 30 * PX * contact.getNormalImpulse();
      const rub = 30 * PX * contact.getTangentImpulse();
      near(normal.segments[0]!.ends, [x, y, x + push * nx, y + push * ny], 1e-12);
      near(friction.segments[0]!.ends, [x, y, x - rub * ny, y + rub * nx], 1e-12);
    }
    expect(arbiter!.contacts.some((contact) => contact.getNormalImpulse() > 0)).toBe(true);
    expect(arbiter!.contacts.some((contact) => contact.getTangentImpulse() !== 0)).toBe(true);
  });

  it('that are over, and those of sensors, are nothing', () => {
    const world = weightless();
    const ball = plainBody();
    add(world, ball, phys2D.createRigidBody({ type: 'static', shapes: [disc(2, { sensor: true })] }));
    steps(world, 2);
    expect(world.staticArbiters.some((arbiter) => arbiter.active)).toBe(true);
    expect(contacts(world)).toEqual([]);
    const other = boxOnFloor();
    other.rigidBodies[1]!.setPosition([0, -10]);
    steps(other, 1);
    expect(other.staticArbiters).toHaveLength(1);
    expect(contacts(other)).toEqual([]);
  });
});
