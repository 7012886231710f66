import { describe, expect, it } from 'vitest';
import {
  type Arbiter,
  type Constraint,
  Polygon,
  phys2D,
  type RigidBody,
  type Shape,
  type World,
} from '../../src/index.js';
import { generator } from '../scenes/mixed.js';
import { Tangle } from '../scenes/tangle.js';

// Random programs: anything may be called at any time, also from handlers. After every step the lists must be exact, all
// numbers finite, and each `begin` must have found its `end` before the next.

const PROGRAMS = 120;
const STEPS = 120;
const KINDS = ['dynamic', 'dynamic', 'static', 'kinematic'] as const;

class Program {
  readonly world: World;
  private readonly bodies: RigidBody[] = [];
  private readonly random: () => number;
  private readonly running = new Set<string>();
  private readonly ties: Tangle;
  private readonly constraints: Constraint[] = [];

  constructor(seed: number) {
    this.random = generator(seed);
    const broadphase = seed % 2 ? phys2D.createBoxTreeBroadphase() : phys2D.createSweepAndPruneBroadphase();
    this.world = phys2D.createWorld({ broadphase, substeps: 1 + (seed % 4) });
    this.ties = new Tangle(phys2D, this.world, seed, 0, 0);
    for (let i = 0; i < 6; i += 1) {
      this.addBody();
    }
  }

  step(): void {
    if (this.random() < 0.5) {
      this.change();
    }
    this.world.step(this.random() < 0.1 ? 1 / 30 : 1 / 60);
  }

  private span(from: number, to: number): number {
    return from + (to - from) * this.random();
  }

  private addBody(): void {
    const body = phys2D.createRigidBody({
      type: KINDS[Math.floor(this.span(0, 4))]!,
      position: [this.span(-3, 3), this.span(-3, 3)],
      rotation: this.span(0, 6),
      velocity: [this.span(-5, 5), this.span(-5, 5)],
      sleeping: this.random() < 0.1,
      shapes: [this.shape()],
    });
    this.bodies.push(body);
    this.ties.bodies.push(body);
    this.world.addRigidBody(body);
  }

  private addConstraint(): void {
    const constraint = this.ties.makeConstraint();
    this.constraints.push(constraint);
    this.world.addConstraint(constraint);
    constraint.addEventListener('break', () => {
      expect(constraint.world === null || constraint.isDisabled()).toBe(true);
      if (this.random() < 0.3) {
        this.change();
      }
    });
  }

  private vertices() {
    return phys2D.createRegularPolygonVertices(this.span(0.3, 1.3), this.span(0.3, 1.3), Math.floor(this.span(3, 9)));
  }

  private shape(): Shape {
    const material = phys2D.createMaterial({ elasticity: this.random() < 0.3 ? this.random() : 0 });
    const shape: Shape =
      this.random() < 0.4
        ? phys2D.createCircleShape({ radius: this.span(0.2, 0.7), origin: [this.span(-0.5, 0.5), 0], material })
        : phys2D.createPolygonShape({ vertices: this.vertices(), material });
    shape.addEventListener('begin', (arbiter) => this.hear(shape, arbiter, true));
    shape.addEventListener('end', (arbiter) => this.hear(shape, arbiter, false));
    if (this.random() < 0.1) {
      shape.addEventListener('preSolve', (arbiter) => {
        arbiter.setAcceptedState(this.random() < 0.5);
        arbiter.setPersistentState(this.random() < 0.1);
        expect(this.world.removeRigidBody(this.bodies[0]!)).toBe(false);
      });
    }
    return shape;
  }

  private hear(shape: Shape, arbiter: Arbiter, begins: boolean): void {
    if (shape === arbiter.shapeA) {
      const key = `${arbiter.shapeA.id}-${arbiter.shapeB.id}`;
      expect(this.running.has(key), `${begins ? 'begin' : 'end'} of ${key} in step ${this.world.timeStamp}`).toBe(
        !begins,
      );
      if (begins) {
        this.running.add(key);
      } else {
        this.running.delete(key);
      }
    }
    if (this.random() < 0.08) {
      this.change();
    }
  }

  private change(): void {
    const { world } = this;
    const body = this.bodies[Math.floor(this.span(0, this.bodies.length))]!;
    const [first] = body.shapes;
    const constraint = this.constraints[Math.floor(this.span(0, this.constraints.length))];
    const changes: (() => unknown)[] = [
      () => this.addConstraint(),
      () => this.addConstraint(),
      () => constraint && world.addConstraint(constraint),
      () => constraint && world.removeConstraint(constraint),
      () => constraint?.enable(),
      () => constraint?.disable(),
      () => constraint?.wake(),
      () => constraint?.sleep(),
      () => constraint?.configure({ ignoreInteractions: this.random() < 0.5, stiff: this.random() < 0.5 }),
      () => this.addBody(),
      () => this.addBody(),
      () => world.removeRigidBody(body),
      () => world.addRigidBody(body),
      () => body.setAsDynamic(),
      () => body.setAsStatic(),
      () => body.setAsKinematic(),
      () => body.addShape(this.shape()),
      () => first && body.removeShape(first),
      () => body.sleep(),
      () => body.wake(),
      () => body.setPosition([this.span(-3, 3), this.span(-3, 3)]),
      () => body.setVelocity([this.span(-5, 5), this.span(-5, 5)]),
      () => first?.setMask(this.random() < 0.5 ? 0 : 0xffffffff),
      () => first?.scale(this.span(0.5, 1.5)),
      () => first instanceof Polygon && first.setVertices(this.vertices()),
      () => world.setGravity([this.span(-2, 2), this.span(-10, 10)]),
      () => body.setSurfaceVelocity([this.span(0, 4), 0]),
      () => body.setMass(this.random() < 0.2 ? Infinity : this.span(0.1, 10)),
      () => first?.setMaterial(phys2D.createMaterial({ density: this.span(0, 3) })),
      () => this.random() < 0.05 && this.clear(),
    ];
    changes[Math.floor(this.span(0, changes.length))]!();
  }

  private clear(): void {
    this.world.clear();
    this.running.clear();
  }
}

/** Everything that the documentation says of the lists of constraints. */
function checkConstraints(world: World): void {
  const live = new Set(world.liveConstraints);
  expect(new Set(world.constraints).size).toBe(world.constraints.length);
  for (const constraint of world.constraints) {
    expect(constraint.world).toBe(world);
    expect(live.has(constraint)).toBe(constraint.isEnabled() && !constraint.sleeping);
  }
  expect(world.liveConstraints.every(({ world: own }) => own === world)).toBe(true);
  for (const body of world.rigidBodies) {
    expect(new Set(body.constraints).size).toBe(body.constraints.length);
    for (const constraint of body.constraints) {
      expect(world.constraints).toContain(constraint);
      expect(constraint.getImpulseForBody(body).every(Number.isFinite)).toBe(true);
    }
  }
}

/** Everything that the documentation says of the lists of a world. */
function checkLists(world: World): void {
  checkConstraints(world);
  const bodies = new Set(world.rigidBodies);
  const listed = new Set([...world.dynamicArbiters, ...world.staticArbiters]);
  const live = new Set([...world.liveDynamics, ...world.liveKinematics]);
  expect(listed.size).toBe(world.dynamicArbiters.length + world.staticArbiters.length);
  for (const body of bodies) {
    expect(body.world).toBe(world);
    expect(live.has(body)).toBe(!body.sleeping && !body.isStatic());
    const numbers = [...body.getPosition(), ...body.getVelocity(), body.getRotation(), body.getAngularVelocity()];
    expect(numbers.every(Number.isFinite)).toBe(true);
    for (const shape of body.shapes) {
      for (const arbiter of shape.arbiters) {
        expect([arbiter.shapeA, arbiter.shapeB]).toContain(shape);
        expect(listed.has(arbiter)).toBe(!arbiter.sleeping);
      }
    }
  }
  for (const arbiter of listed) {
    expect(bodies.has(arbiter.bodyA) && bodies.has(arbiter.bodyB)).toBe(true);
    expect(arbiter.shapeA.arbiters.includes(arbiter) && arbiter.shapeB.arbiters.includes(arbiter)).toBe(true);
    for (const contact of arbiter.contacts) {
      expect([...contact.getPosition(), contact.getPenetration()].every(Number.isFinite)).toBe(true);
    }
  }
}

describe('random programs', () => {
  it(`${PROGRAMS} of them leave every list exact after every step`, () => {
    for (let seed = 1; seed <= PROGRAMS; seed += 1) {
      const program = new Program(seed);
      for (let i = 0; i < STEPS; i += 1) {
        program.step();
        checkLists(program.world);
      }
    }
  }, 60_000);
});
