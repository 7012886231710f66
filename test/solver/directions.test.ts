import { expect, it } from 'vitest';
import { phys2D, type RigidBody, type RigidBodyParams, type Shape, type Vec2, type World } from '../../src/index.js';

// No direction is preferred: a world that is turned by a quarter, gravity and all, does the same, turned by a quarter.

const DT = 1 / 60;

class Turned {
  readonly world: World;

  /** @param quarters how often it is turned by 90°. */
  constructor(readonly quarters: number) {
    this.world = phys2D.createWorld({ gravity: this.turn([0, 10]) });
  }

  /** A vector as it is in this world. */
  turn([x, y]: Vec2, quarters = this.quarters): Vec2 {
    return quarters === 0 ? [x, y] : this.turn([-y, x], quarters - 1);
  }

  box(width: number, height: number, elasticity = 0): Shape {
    const vertices = phys2D.createBoxVertices(width, height).map(([x, y]) => this.turn([x!, y!]));
    return phys2D.createPolygonShape({ vertices, material: phys2D.createMaterial({ elasticity }) });
  }

  disc(radius: number, elasticity = 0): Shape {
    return phys2D.createCircleShape({ radius, material: phys2D.createMaterial({ elasticity }) });
  }

  add(shape: Shape, position: Vec2, velocity: Vec2 = [0, 0], params: RigidBodyParams = {}): RigidBody {
    const places = { position: this.turn(position), velocity: this.turn(velocity) };
    const body = phys2D.createRigidBody({ shapes: [shape], ...places, ...params });
    this.world.addRigidBody(body);
    return body;
  }

  floor(x: number): RigidBody {
    return this.add(this.box(8, 1), [x, 0.5], [0, 0], { type: 'static' });
  }
}

const scenes: Record<string, (w: Turned) => void> = {
  'things that slide, roll, bounce and stand': (w) => {
    w.floor(0);
    w.add(w.box(0.5, 0.5), [-3, -0.25], [4, 0]);
    w.add(w.disc(0.25), [0, -0.25], [2, 0]);
    w.add(w.disc(0.25, 0.8), [2, -1], [0.5, 3]);
    w.add(w.box(1, 0.5), [3, -0.25]);
    w.add(w.box(0.5, 0.5), [3.1, -0.75]);
  },
  'fast things that land': (w) => {
    for (const [i, [vx, vy]] of [
      [3, 40],
      [30, 9],
      [-20, 60],
    ].entries()) {
      w.floor(20 * i);
      w.add(w.disc(0.2), [20 * i, -1.3], [vx!, vy!]);
      w.add(w.box(0.4, 0.2), [20 * i + 1, -1.7], [vx!, vy!]);
      w.add(w.box(0.4, 0.2, 0.5), [20 * i - 1, -1.9], [vx!, vy!], { angularVelocity: 20 });
    }
  },
  'what is pushed by forces': (w) => {
    w.floor(0);
    w.add(w.disc(0.3), [0, -0.6]).setForce(w.turn([300, 200]));
    w.add(w.box(0.3, 0.3), [-2, -2]).setForce(w.turn([0, 900]));
    w.add(w.box(1, 0.2), [2, -2]).setTorque(30);
  },
  'kinematic things that push and strike': (w) => {
    w.floor(0);
    w.add(w.box(0.2, 1), [-3, -0.6], [4, 0], { type: 'kinematic' });
    w.add(w.box(0.4, 0.4), [-2, -0.2]);
    w.add(w.box(2, 0.1), [2, -2], [0, 0], { type: 'kinematic', angularVelocity: 12 });
    w.add(w.disc(0.1), [2.7, -2.4]);
    w.floor(10).setSurfaceVelocity([3, 0]);
    w.add(w.box(0.5, 0.5), [10, -0.25]);
  },
  'bullets that meet, and cross what stands there': (w) => {
    w.add(w.disc(0.1, 0.5), [-3, 0], [150, 2], { bullet: true });
    w.add(w.disc(0.1, 0.5), [3, 0.1], [-150, 3], { bullet: true });
    w.add(w.disc(0.1), [0, 5], [20, 200], { bullet: true });
    w.add(w.box(3, 0.05), [0, 8], [0, 0], { type: 'static' });
  },
  'things on joints': (w) => {
    const hook = w.floor(0);
    const at = (x: number, y = 0): Vec2 => w.turn([x, y]);
    const hang = (x: number): RigidBody => w.add(w.box(0.8, 0.3), [x, 4], [1, 0], { angularVelocity: 1 });
    const [a, b, c, d, e] = [-8, -4, 0, 4, 8].map(hang);
    for (const constraint of [
      phys2D.createPointConstraint({ bodyA: hook, bodyB: a!, anchorA: at(-8, 1), anchorB: at(0, -2.5) }),
      phys2D.createWeldConstraint({ bodyA: hook, bodyB: b!, anchorA: at(-4, 3.5), stiff: false }),
      phys2D.createDistanceConstraint({ bodyA: hook, bodyB: c!, anchorA: at(1), anchorB: at(0.4), upperBound: 4 }),
      phys2D.createLineConstraint({ bodyA: hook, bodyB: d!, anchorA: at(4, 3.5), axis: at(1, 1), upperBound: 2 }),
      phys2D.createAngleConstraint({ bodyA: hook, bodyB: d!, lowerBound: -0.2, upperBound: 0.2 }),
      phys2D.createWeldConstraint({ bodyA: hook, bodyB: e!, anchorA: at(8, 3.5) }),
    ]) {
      w.world.addConstraint(constraint);
    }
  },
};

it.each(Object.entries(scenes))('%s', (_, build) => {
  const worlds = [0, 1, 2, 3].map((quarters) => {
    const turned = new Turned(quarters);
    build(turned);
    return turned;
  });
  for (let i = 0; i < 40; i += 1) {
    for (const { world } of worlds) {
      world.step(DT);
    }
    worlds[0]!.world.rigidBodies.forEach((body, k) => {
      for (const { world, quarters } of worlds.slice(1)) {
        const twin = world.rigidBodies[k]!;
        const told = `body ${k}, turned by ${quarters} quarters, in step ${i}`;
        const [x, y] = worlds[quarters]!.turn(body.getPosition());
        expect(twin.getPosition()[0], told).toBeCloseTo(x, 6);
        expect(twin.getPosition()[1], told).toBeCloseTo(y, 6);
        expect(twin.getRotation(), told).toBeCloseTo(body.getRotation(), 6);
      }
    });
  }
});
