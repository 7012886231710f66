// Scenes of casts: a field of bodies that lie apart from each other, and ways for rays and boxes through it. Each engine prepares a
// cast with the best call it has for the nearest hit with its normal: what that returns casts, and returns the factor of the hit, from
// 0 to 1, or −1. Nothing moves in the worlds, and nothing sleeps.
import { DT, generator } from '../dist/bench/scenes.js';
import { MISS } from './peer.mjs';

const BODIES = 2000;
/** m. Side of the square field. */
const SIDE = 200;
/** m. Bodies are this large, measured from their middle, and this far apart from each other and from where a cast starts. */
const SMALLEST = 0.1;
const LARGEST = 2;
const GAP = 0.1;
/** m. Side of the box that is cast. */
const BOX_SIDE = 0.5;
/** A few steps, so that every engine has its trees in order. */
const SETTLE = 10;

export const rays = {
  title: '10,000 nearest hits of rays among 2,000 bodies',
  figure: 'hits',
  warmUp: 10,
  steps: 40,
  steady: true,
  /** All engines must hit the same. */
  agrees: true,
  start: (device) => castAll(device, 10_000, 40, 0, ({ ray }) => ray),
};

export const casts = {
  title: '2,000 nearest hits of a box among 2,000 bodies',
  figure: 'hits',
  warmUp: 20,
  steps: 80,
  steady: true,
  start: (device) => castAll(device, 2000, 10, BOX_SIDE, ({ box }) => box?.(BOX_SIDE)),
};

/** @returns what does all casts, or `null` if the engine has no such cast. */
function castAll(device, count, length, radius, kindOf) {
  const world = device.createWorld({ gravity: [0, 0], allowSleeping: false });
  const wayThrough = buildField(device, world);
  for (let i = 0; i < SETTLE; i += 1) {
    world.step(DT);
  }
  const prepare = kindOf(device.isPeer ? (world.caster?.() ?? {}) : phys2dCaster(device, world));
  if (prepare === undefined) {
    return null;
  }
  const prepared = Array.from({ length: count }, () => prepare(wayThrough(radius, length)));
  let hits = 0;
  let factors = 0;
  const act = () => {
    hits = 0;
    factors = 0;
    for (const cast of prepared) {
      const factor = cast();
      if (factor !== MISS) {
        hits += 1;
        factors += factor;
      }
    }
  };
  return { world, act, quality: () => hits, factors: () => factors };
}

function phys2dCaster(device, world) {
  return {
    ray({ x, y, dx, dy }) {
      const ray = { origin: [x, y], direction: [dx, dy], maxFactor: 1 };
      return () => world.rayCast(ray)?.factor ?? MISS;
    },
    box(size) {
      const box = device.createPolygonShape({ vertices: device.createBoxVertices(size, size) });
      const caster = device.createRigidBody({ shapes: [box] });
      return ({ x, y, angle, dx, dy }) => {
        const start = { position: [x, y], velocity: [dx, dy] };
        return () => {
          caster.setPosition(start.position);
          caster.setRotation(angle);
          caster.setVelocity(start.velocity);
          return world.convexCast(box, 1)?.factor ?? MISS;
        };
      };
    },
  };
}

/**
 * A third of the bodies each are circles, boxes, and irregular polygons of 3 to 8 corners; every other one is static.
 *
 * @returns what makes ways that start outside all of them, in any direction; (dx, dy) is the whole way, `angle` the turn of a box.
 */
function buildField(device, world) {
  const random = generator(12);
  const between = (from, to) => from + (to - from) * random();
  const taken = [];
  const place = (radius) => {
    for (;;) {
      const at = { x: between(0, SIDE), y: between(0, SIDE), angle: between(-3, 3) };
      if (isFree(taken, at.x, at.y, radius)) {
        return at;
      }
    }
  };
  for (let i = 0; i < BODIES; i += 1) {
    const radius = SMALLEST * (LARGEST / SMALLEST) ** random();
    const { x, y, angle } = place(radius);
    const shapes = [shapeMakers[i % 3](device, radius, between)];
    const type = i % 2 === 0 ? 'static' : 'dynamic';
    world.addRigidBody(device.createRigidBody({ type, position: [x, y], rotation: angle, shapes }));
    taken.push(x, y, radius);
  }
  return (radius, length) => {
    const direction = between(-Math.PI, Math.PI);
    return { ...place(radius), dx: length * Math.cos(direction), dy: length * Math.sin(direction) };
  };
}

function isFree(taken, x, y, radius) {
  for (let i = 0; i < taken.length; i += 3) {
    if ((taken[i] - x) ** 2 + (taken[i + 1] - y) ** 2 < (taken[i + 2] + radius + GAP) ** 2) {
      return false;
    }
  }
  return true;
}

const shapeMakers = [circle, box, polygon];

function circle(device, radius) {
  return device.createCircleShape({ radius });
}

function box(device, radius, between) {
  const slant = between(0.25, Math.PI / 2 - 0.25);
  const vertices = device.createBoxVertices(2 * radius * Math.cos(slant), 2 * radius * Math.sin(slant));
  return device.createPolygonShape({ vertices });
}

function polygon(device, radius, between) {
  const count = Math.floor(between(3, 9));
  const corner = (_, i) => {
    const angle = ((i + between(0, 0.4)) * 2 * Math.PI) / count;
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  };
  return device.createPolygonShape({ vertices: Array.from({ length: count }, corner) });
}
