import { describe, expect, it } from 'vitest';
import { phys2D, type RigidBody, type World } from '../../src/index.js';
import { box, disc, staticBody, weightless } from '../conformance/setting.js';

// A rod of 4 m that hangs on a hinge at the origin and turns against a wall, without gravity.

const SPEED = 5;

function setUp(elasticity: number, friction: number): { world: World; rod: RigidBody; hinge: RigidBody } {
  const world = weightless();
  const material = phys2D.createMaterial({ elasticity, staticFriction: friction, dynamicFriction: friction });
  const rod = phys2D.createRigidBody({
    position: [2, 0],
    velocity: [0, 2 * SPEED],
    angularVelocity: SPEED,
    linearDrag: 0,
    angularDrag: 0,
    shapes: [box(4, 0.2, { material })],
  });
  world.addRigidBody(rod);
  world.addRigidBody(staticBody({ position: [-1.2, 4], shapes: [box(2, 4, { material })] }));
  const hinge = staticBody({ position: [0.5, 0] });
  world.addConstraint(phys2D.createPointConstraint({ bodyA: hinge, bodyB: rod, anchorA: [-0.5, 0], anchorB: [-2, 0] }));
  return { world, rod, hinge };
}

describe('what hangs on a hinge and strikes a wall', () => {
  it.each([24, 30, 48, 60, 120])('turns back as fast as its elasticity says, at %d steps a second', (rate) => {
    for (const elasticity of [0.5, 1]) {
      const { world, rod } = setUp(elasticity, 0);
      let hits = 0;
      let gap = 0;
      world.addEventListener('hit', () => {
        hits += 1;
        if (hits === 1) {
          // Before, as a free rod that the hinge then took back, −9.9 and −4.5 rad/s for a step, and a quarter of the energy was lost.
          expect(rod.getAngularVelocity()).toBeCloseTo(-elasticity * SPEED, 1);
        }
      });
      for (let i = 0; i < rate; i += 1) {
        world.step(1 / rate);
        const [x, y] = rod.transformLocalPointToWorld([-2, 0]);
        gap = Math.max(gap, Math.hypot(x, y));
      }
      console.log(
        `rod of elasticity ${elasticity} at ${rate} steps a second: ${hits} hits, hinge opened by ${(1000 * gap).toFixed(2)} mm`,
      );
      expect(hits).toBeGreaterThan(0);
      expect(gap).toBeLessThan(0.02);
    }
  });

  it('also where it falls flat against two at once', () => {
    for (let rate = 20; rate <= 80; rate += 1) {
      for (const elasticity of [0.5, 1]) {
        const { world, rod } = setUp(elasticity, 0);
        const material = phys2D.createMaterial({ elasticity, staticFriction: 0, dynamicFriction: 0 });
        rod.setVelocity([0, 8]);
        rod.setAngularVelocity(4);
        rod.bullet = true;
        // Before it comes to the wall.
        for (const y of [1.5, 3.5]) {
          world.addRigidBody(staticBody({ position: [-1.1, y], shapes: [box(2, 1, { material })] }));
        }
        for (let i = 0; i < rate && rod.getAngularVelocity() > 3.6; i += 1) {
          world.step(1 / rate);
        }
        // Before, at some rates a quarter of that: each impact took what it has about the hinge from the origin once more.
        expect(rod.getAngularVelocity(), `elasticity ${elasticity}, ${rate} steps a second`).toBeCloseTo(
          -4 * elasticity,
          0,
        );
      }
    }
  });

  it('tells what the hinge gave: with what the contact gave all that changed the momentum', () => {
    const { world, rod, hinge } = setUp(1, 0.5);
    const mass = rod.computeMassFromShapes();
    let struck = 0;
    for (let i = 0; i < 30; i += 1) {
      const before = rod.getVelocity();
      world.step(1 / 30);
      const after = rod.getVelocity();
      const [held] = world.constraints;
      const ofHinge = held!.getImpulseForBody(rod);
      const opposite = held!.getImpulseForBody(hinge);
      const ofContacts = world.staticArbiters.map((arbiter) => arbiter.getImpulseForBody(rod));
      struck += ofContacts.some(([x]) => x !== 0) ? 1 : 0;
      for (const k of [0, 1] as const) {
        const given = ofContacts.reduce((sum, impulse) => sum + impulse[k], ofHinge[k]);
        // In the step in which it is struck, what turns it is told as that of the whole step.
        expect(Math.abs(given - mass * (after[k] - before[k]))).toBeLessThan((mass * 2 * SPEED * SPEED) / 30);
        expect(opposite[k]).toBeCloseTo(-ofHinge[k], 12);
      }
      // About its own origin, 0.5 m beside the hinge.
      expect(opposite[2]).toBeCloseTo(0.5 * ofHinge[1], 12);
    }
    expect(struck).toBeGreaterThan(0);
  });
});

describe('a rod on an axle that falls flat against a wall', () => {
  it.each([30, 60, 120, 240])('turns back as fast as its elasticity says, at %d steps a second', (rate) => {
    for (const elasticity of [0, 0.5, 1]) {
      for (const y of [0.9, 0.7, 0.5]) {
        const world = weightless();
        const material = phys2D.createMaterial({ elasticity, staticFriction: 0, dynamicFriction: 0 });
        const params = { angularVelocity: 8, angularDrag: 0, shapes: [box(2, 0.1, { material })] };
        const rod = phys2D.createRigidBody(params);
        world.addRigidBody(rod);
        world.addConstraint(phys2D.createPointConstraint({ bodyA: staticBody(), bodyB: rod }));
        world.addRigidBody(staticBody({ position: [-0.55, y], shapes: [box(1, 0.5, { material })] }));
        for (let i = 0; i < 0.3 * rate; i += 1) {
          world.step(1 / rate);
        }
        // Before, up to −19.8: both its points were to leave as fast as those of a free rod, of which one throws off the other.
        expect(rod.getAngularVelocity(), `elasticity ${elasticity}, ${y} m`).toBeCloseTo(-8 * elasticity, 1);
      }
    }
  });
});

describe('bullets that are joined to others', () => {
  const PAIRS = 4;

  /** Of the momentum with which a pair flies into three that rest what is left after a second. */
  function left(rate: number, gap: number, isWelded: boolean): number {
    const world = weightless();
    const material = phys2D.createMaterial({ elasticity: 0.5 });
    const bodies: RigidBody[] = [];
    const addBody = (x: number, speed: number) => {
      const params = { position: [x, 0] as const, velocity: [speed, 0] as const, linearDrag: 0, angularDrag: 0 };
      const body = phys2D.createRigidBody({ ...params, bullet: true, shapes: [box(1, 0.8, { material })] });
      world.addRigidBody(body);
      bodies.push(body);
      return body;
    };
    for (let i = 0; i < PAIRS; i += 1) {
      const x = i === 0 ? -4 : i * (2.01 + gap);
      const [bodyA, bodyB] = [addBody(x, i === 0 ? 20 : 0), addBody(x + 1.01, i === 0 ? 20 : 0)];
      const params = { bodyA, bodyB, anchorA: [0.505, 0], anchorB: [-0.505, 0], ignoreInteractions: true };
      world.addConstraint(isWelded ? phys2D.createWeldConstraint(params) : phys2D.createPointConstraint(params));
    }
    for (let i = 0; i < rate; i += 1) {
      world.step(1 / rate);
    }
    return bodies.reduce((sum, body) => sum + body.getVelocity()[0], 0) / 40;
  }

  it.each([30, 60, 120])('keep their momentum when they are struck, at %d steps a second', (rate) => {
    for (const gap of [0.005, 0.05, 0.2]) {
      for (const isWelded of [false, true]) {
        // Before, down to 0.79.
        expect(left(rate, gap, isWelded), `gap ${gap}, welded ${isWelded}`).toBeCloseTo(1, 3);
      }
    }
  });

  it('hang in a row and are struck by one: on ropes as without', () => {
    for (const isHung of [false, true]) {
      const world = weightless();
      const material = phys2D.createMaterial({ elasticity: 0.8, staticFriction: 0, dynamicFriction: 0 });
      const bodies = [-1.2, 0, 0.605, 1.21, 1.815].map((x, i) => {
        const params = { position: [x, 0] as const, velocity: [i === 0 ? 12 : 0, 0] as const, linearDrag: 0 };
        const body = phys2D.createRigidBody({ ...params, bullet: true, shapes: [disc(0.3, { material })] });
        world.addRigidBody(body);
        if (isHung && i > 0) {
          const bodyA = staticBody({ position: [x, -4] });
          world.addConstraint(phys2D.createDistanceConstraint({ bodyA, bodyB: body, lowerBound: 0, upperBound: 4 }));
        }
        return body;
      });
      for (let i = 0; i < 10; i += 1) {
        world.step(1 / 60);
      }
      const momentum = bodies.reduce((sum, body) => sum + body.getVelocity()[0], 0) / 12;
      // Before, 0.44 on ropes.
      expect(momentum).toBeGreaterThan(0.97);
      expect(momentum).toBeLessThan(1.01);
    }
  });
});
