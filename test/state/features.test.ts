import { describe, expect, it } from 'vitest';
import type { Arbiter, Constraint, RigidBody, RigidBodyParams, Shape, World } from '../../src/index.js';
import { generator } from '../scenes/mixed.js';
import { phys2D } from './built.js';

// What changes the structure of a world, each by itself: after a restore the same happens again to the bit, and the same is told.

const MOMENTS = [0, 1, 37, 88, 121, 160, 215];
const STEPS = 300;
const NOTED = ['begin', 'progress', 'end', 'hit'] as const;

/** What was told of shapes, bodies and constraints in the present run. */
let told: string[] = [];

function note(shape: Shape, name: string): Shape {
  shape.userData = name;
  for (const event of NOTED) {
    shape.addEventListener(event, (_: Arbiter, other: Shape) => void told.push(`${event} ${name} ${other.userData}`));
  }
  return shape;
}

function box(name: string, width = 1, height = 1, sensor = false): Shape {
  return note(phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, height), sensor }), name);
}

function disc(name: string, radius = 0.4, sensor = false): Shape {
  return note(phys2D.createCircleShape({ radius, sensor }), name);
}

function add(world: World, shape: Shape, params: RigidBodyParams): RigidBody {
  const body = phys2D.createRigidBody({ shapes: [shape], ...params });
  for (const event of ['wake', 'sleep'] as const) {
    body.addEventListener(event, () => void told.push(`${event} ${shape.userData}`));
  }
  world.addRigidBody(body);
  return body;
}

function tie<T extends Constraint>(world: World, constraint: T, name: string): T {
  constraint.addEventListener('break', () => void told.push(`break ${name}`));
  world.addConstraint(constraint);
  return constraint;
}

/** Six boxes on a floor, and a disc beside them. */
function heap(world: World): RigidBody[] {
  add(world, box('floor', 30, 1), { type: 'static', position: [0, 0.5] });
  const boxes = Array.from({ length: 6 }, (_, i) =>
    add(world, box(`box ${i}`), { position: [0.52 * (i % 3) - 0.5, -0.6 - 1.05 * i] }),
  );
  return [...boxes, add(world, disc('ball'), { position: [-6, -2], velocity: [4, 0] })];
}

type Act = (stamp: number) => void;

/** What happens before each step hangs on the number of the step alone. */
const FEATURES: Record<string, [happens: RegExp, build: (world: World) => Act]> = {
  'bodies that come and go': [
    /^end guest/,
    (world) => {
      heap(world);
      const guest = phys2D.createRigidBody({ shapes: [disc('guest')] });
      return (stamp) => {
        if (stamp % 40 === 20) {
          // Outside the world it is no part of a snapshot.
          guest.setPosition([0.3, -9]);
          guest.setRotation(0);
          guest.setAngularVelocity(0);
          guest.setVelocity([0, 12]);
          world.addRigidBody(guest);
        } else if (stamp % 40 === 0) {
          world.removeRigidBody(guest);
          add(world, box(`made ${stamp}`, 0.5, 0.5), { position: [1, -8] });
        }
        if (world.rigidBodies.length > 14) {
          world.removeRigidBody(world.rigidBodies[3]!);
        }
      };
    },
  ],
  'changes of type': [
    /^wake box 0/,
    (world) => {
      const [first, second] = heap(world);
      return (stamp) => {
        const change = { 20: 'setAsStatic', 50: 'setAsKinematic', 80: 'setAsDynamic' } as const;
        const name = change[(stamp % 90) as keyof typeof change];
        if (name !== undefined) {
          first![name]();
          second![stamp % 180 < 90 ? 'setAsDynamic' : 'setAsKinematic']();
        }
      };
    },
  ],
  'shapes that come, go and change': [
    /^begin fin/,
    (world) => {
      const bodies = heap(world);
      const fin = disc('fin', 0.3);
      fin.translate([0.6, 0]);
      return (stamp) => {
        const body = bodies[stamp % 6]!;
        if (stamp % 50 === 10) {
          body.addShape(fin);
        } else if (stamp % 50 === 35) {
          fin.body?.removeShape(fin);
        } else if (stamp % 50 === 45) {
          body.shapes[0]!.scale(stamp % 100 === 45 ? 0.8 : 1.25);
          body.shapes[0]!.setMaterial(phys2D.createMaterial({ elasticity: 0.5 }));
        }
      };
    },
  ],
  sensors: [
    /^end eye/,
    (world) => {
      const bodies = heap(world);
      add(world, box('zone', 4, 2, true), { type: 'static', position: [0, -1] });
      add(world, disc('eye', 1, true), { type: 'kinematic', position: [-3, -3], velocity: [0.5, 0] });
      return (stamp) => {
        if (stamp % 60 === 30) {
          bodies[6]!.setPosition([stamp % 120 === 30 ? 0 : -6, -3]);
        }
      };
    },
  ],
  'joints that break': [
    /^break joint/,
    (world) => {
      const anchor = add(world, box('anchor'), { type: 'static', position: [0, -8] });
      let last = anchor;
      for (let i = 0; i < 10; i += 1) {
        const link = add(world, box(`link ${i}`, 0.8, 0.2), { position: [0.9 + i, -8] });
        const anchors = { anchorA: [0.5, 0], anchorB: [-0.5, 0] } as const;
        const strength = { breakUnderForce: true, maxForce: 16 - i, removeOnBreak: i % 2 === 0 };
        tie(world, phys2D.createPointConstraint({ bodyA: last, bodyB: link, ...anchors, ...strength }), `joint ${i}`);
        last = link;
      }
      return (stamp) => {
        if (stamp % 100 === 99) {
          world.constraints.find((constraint) => !constraint.isEnabled())?.enable();
        }
      };
    },
  ],
  'sleep and waking': [
    /^sleep box 5/,
    (world) => {
      const bodies = heap(world);
      return (stamp) => {
        if (stamp % 150 === 140) {
          bodies[6]!.setPosition([-4, -0.5]);
          bodies[6]!.setVelocity([12, 0]);
        }
      };
    },
  ],
  'a kinematic drum': [
    /^end wall/,
    (world) => {
      const walls = Array.from({ length: 12 }, (_, i) => {
        const wall = box(`wall ${i}`, 0.3, 2);
        wall.translate([3, 0]);
        wall.rotate((Math.PI * i) / 6);
        return wall;
      });
      const drum = add(world, walls[0]!, { type: 'kinematic', angularVelocity: 2 });
      walls.slice(1).forEach((wall) => {
        drum.addShape(wall);
      });
      for (let i = 0; i < 20; i += 1) {
        add(world, box(`box ${i}`, 0.4, 0.4), { position: [0.5 * (i % 5) - 1, 0.5 * Math.floor(i / 5) - 1] });
      }
      return (stamp) => {
        if (stamp % 80 === 40) {
          drum.setAngularVelocity(stamp % 160 === 40 ? -2 : 2);
        }
      };
    },
  ],
  'continuous collision': [
    /^hit bullet/,
    (world) => {
      for (const [i, [x, y, width, height]] of [
        [0, 3, 12, 0.05],
        [0, -3, 12, 0.05],
        [6, 0, 0.05, 6],
        [-6, 0, 0.05, 6],
      ].entries()) {
        add(world, box(`wall ${i}`, width, height), { type: 'static', position: [x!, y!] });
      }
      const random = generator(5);
      const bouncy = phys2D.createMaterial({ elasticity: 1 });
      for (let i = 0; i < 16; i += 1) {
        const shape = i % 2 === 0 ? disc(`bullet ${i}`, 0.1) : box(`sliver ${i}`, 0.6, 0.04);
        shape.setMaterial(bouncy);
        const velocity = [160 * random() - 80, 160 * random() - 80] as const;
        add(world, shape, { position: [10 * random() - 5, 5 * random() - 2.5], velocity, bullet: i % 4 < 2 });
      }
      return () => {};
    },
  ],
  'collisions that are refused': [
    /^begin box 1 platform/,
    (world) => {
      const bodies = heap(world);
      const platform = add(world, box('platform', 6, 0.3), { type: 'static', position: [0, -9] });
      platform.shapes[0]!.addEventListener('preSolve', (arbiter, other) => {
        arbiter.setAcceptedState(other.userData !== 'ball');
        arbiter.setPersistentState(other.userData === 'box 1');
      });
      return (stamp) => {
        if (stamp % 70 === 35) {
          bodies[6]!.setPosition([-1, -10]);
          bodies[1]!.setPosition([1, -10]);
        }
      };
    },
  ],
};

const BROADPHASES = {
  'box tree': () => phys2D.createBoxTreeBroadphase(),
  'sweep and prune': () => phys2D.createSweepAndPruneBroadphase(),
};

describe.each(Object.entries(BROADPHASES))('%s', (_, broadphase) => {
  it.each(Object.entries(FEATURES))(
    `%s: ${STEPS} steps again from ${MOMENTS.length} moments`,
    (_name, [happens, build]) => {
      const world = phys2D.createWorld({ broadphase: broadphase() });
      const act = build(world);
      const advance = (): [hash: string, told: string[]] => {
        told = [];
        act(world.timeStamp);
        world.step(1 / 60);
        return [world.hash(), told];
      };
      const snapshots = new Map<number, ArrayBuffer>();
      const first = Array.from({ length: Math.max(...MOMENTS) + STEPS }, (_element, i) => {
        if (MOMENTS.includes(i)) {
          snapshots.set(i, world.snapshot());
        }
        return advance();
      });
      expect(first.flatMap(([, events]) => events).filter((event) => happens.test(event))).not.toEqual([]);
      for (const [moment, snapshot] of [...snapshots].reverse()) {
        world.restore(snapshot);
        for (let i = moment; i < moment + STEPS; i += 1) {
          expect(advance(), `step ${i} of the run from ${moment}`).toEqual(first[i]);
        }
      }
    },
  );
});
