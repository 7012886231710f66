import { expect } from 'vitest';
import type {
  Arbiter,
  Constraint,
  Hit,
  Physics2DDevice,
  RigidBody,
  Shape,
  ShapeHandler,
  World,
} from '../../src/index.js';
import { generator } from '../scenes/mixed.js';
import { Tangle } from '../scenes/tangle.js';

/** One operation of a random program: which one, on what, when, and a seed for the numbers it needs. */
export interface Operation {
  readonly op: number;
  readonly who: number;
  /** Wait until a handler runs, and do it there. */
  readonly later: boolean;
  readonly seed: number;
}

const KINDS = ['dynamic', 'dynamic', 'dynamic', 'static', 'kinematic'] as const;
const GROUPS = [1, 1, 2, 3, 4];
const MASKS = [0xffffffff, 0xffffffff, 1, 2, 6, 0];
/** Ranks of the events in one delivery. */
const ORDER = ['wake', 'begin', 'hit', 'progress', 'end', 'sleep', 'break'];

/**
 * Runs operations on a world, from outside and from handlers, and checks what may be checked at any time: each `begin` finds its `end`
 * before the next, events come in order, and the world is consistent.
 */
export class Program {
  readonly world: World;
  private readonly bodies: RigidBody[] = [];
  private readonly constraints: Constraint[] = [];
  private readonly extra: (() => boolean)[] = [];
  private readonly ties: Tangle;
  /** Interactions that began and have not ended, as heard on shape A and on shape B. */
  private readonly running = { a: new Map<string, Arbiter>(), b: new Map<string, Arbiter>() };
  /** What was heard in the present delivery: pair and side → type. */
  private heard = new Map<string, string>();
  private delivery: number[][] = [];
  private delivering = false;
  private waiting: Operation[] = [];
  private random = generator(0);

  constructor(
    private readonly phys2D: Physics2DDevice,
    private readonly validate: (world: World) => void,
    seed: number,
  ) {
    this.random = generator(seed);
    const broadphase = seed % 2 ? phys2D.createBoxTreeBroadphase() : phys2D.createSweepAndPruneBroadphase();
    this.world = phys2D.createWorld({ broadphase, substeps: 1 + (seed % 4) });
    this.ties = new Tangle(phys2D, this.world, seed, 0, 0);
    for (let i = 0; i < 6; i += 1) {
      this.addBody();
    }
  }

  run(operations: readonly Operation[]): void {
    for (const operation of operations) {
      if (operation.later) {
        this.waiting.push(operation);
      } else {
        this.apply(operation);
      }
    }
    this.waiting = [];
    this.step(1 / 60);
    this.step(1 / 60);
    this.checkRunning();
  }

  /** How many operations there are, beside steps. */
  get count(): number {
    return this.operations(0).length;
  }

  private apply({ op, who, seed }: Operation): void {
    this.random = generator(seed);
    const list = this.operations(who);
    if (op >= list.length) {
      this.step(this.chance(0.1) ? 1 / 30 : 1 / 60);
    } else {
      list[op]!();
    }
  }

  private step(dt: number, isLast = true): void {
    const count = this.world.timeStamp;
    this.delivery = [];
    this.heard = new Map();
    this.delivering = true;
    this.world.step(dt);
    this.delivering = false;
    expect(this.world.timeStamp).toBe(count + 1);
    this.checkOrder();
    if (isLast) {
      this.validate(this.world);
    }
  }

  private span(from: number, to: number): number {
    return from + (to - from) * this.random();
  }

  private chance(share: number): boolean {
    return this.random() < share;
  }

  private pick<T>(list: readonly T[]): T {
    return list[Math.floor(this.random() * list.length)]!;
  }

  private addBody(): void {
    const body = this.phys2D.createRigidBody({
      type: this.pick(KINDS),
      position: [this.span(-2, 2), this.span(-2, 2)],
      rotation: this.span(0, 6),
      velocity: this.chance(0.5) ? [0, 0] : [this.span(-5, 5), this.span(-5, 5)],
      sleeping: this.chance(0.1),
      shapes: this.chance(0.3) ? [this.shape(), this.shape()] : [this.shape()],
    });
    for (const type of ['wake', 'sleep'] as const) {
      body.addEventListener(type, () => {
        this.note(type, body.shapes[0]?.id ?? -1, -1);
        this.react();
      });
    }
    this.bodies.push(body);
    this.ties.bodies.push(body);
    this.world.addRigidBody(body);
  }

  private addConstraint(): void {
    const constraint = this.ties.makeConstraint();
    this.constraints.push(constraint);
    this.world.addConstraint(constraint);
    for (const type of ['wake', 'sleep', 'break'] as const) {
      constraint.addEventListener(type, () => this.react());
    }
  }

  private vertices() {
    const sides = Math.floor(this.span(3, 9));
    return this.phys2D.createRegularPolygonVertices(this.span(0.3, 1.3), this.span(0.3, 1.3), sides);
  }

  private shape(): Shape {
    const { phys2D } = this;
    const common = {
      material: phys2D.createMaterial({ elasticity: this.chance(0.3) ? this.random() : 0 }),
      sensor: this.chance(0.25),
      group: this.pick(GROUPS),
    };
    const origin = [this.span(-0.5, 0.5), 0] as const;
    const shape: Shape = this.chance(0.4)
      ? phys2D.createCircleShape({ radius: this.span(0.2, 0.7), origin, ...common })
      : phys2D.createPolygonShape({ vertices: this.vertices(), ...common });
    for (const type of ['begin', 'progress', 'end'] as const) {
      shape.addEventListener(type, (arbiter, other) => this.hear(type, shape, other, arbiter));
    }
    shape.addEventListener('hit', (arbiter, other, hit) => this.hearHit(shape, other, arbiter, hit), undefined, 0.5);
    return shape;
  }

  private hear(type: 'begin' | 'progress' | 'end', own: Shape, other: Shape, arbiter: Arbiter): void {
    const key = this.keyOf(own, other, arbiter);
    const side = own === arbiter.shapeA ? 'a' : 'b';
    const running = this.running[side];
    const before = this.heard.get(key + side);
    expect(running.has(key), `${type} of ${key} in step ${this.world.timeStamp}`).toBe(type !== 'begin');
    expect(before === undefined || (before === 'end' && type === 'begin'), `${before}, then ${type}`).toBe(true);
    this.heard.set(key + side, type);
    if (type === 'end') {
      running.delete(key);
    } else {
      running.set(key, arbiter);
    }
    this.note(type, arbiter.shapeA.id, arbiter.shapeB.id, side === 'a' ? 0 : 1);
    this.react();
  }

  private hearHit(own: Shape, other: Shape, arbiter: Arbiter, hit: Hit): void {
    const key = this.keyOf(own, other, arbiter);
    const side = own === arbiter.shapeA ? 'a' : 'b';
    expect(this.heard.get(key + side)).toBe('begin');
    expect(arbiter.sensor).toBe(false);
    expect(hit.approachSpeed).toBeGreaterThanOrEqual(0.5);
    expect(hit.impulse).toBeGreaterThanOrEqual(0);
    expect([...hit.getPosition(), ...hit.getNormal(), hit.approachSpeed, hit.impulse].every(Number.isFinite)).toBe(
      true,
    );
    expect(Math.hypot(...hit.getNormal())).toBeCloseTo(1, 9);
    this.note('hit', arbiter.shapeA.id, arbiter.shapeB.id, side === 'a' ? 0 : 1);
    this.react();
  }

  private keyOf(own: Shape, other: Shape, { shapeA, shapeB }: Arbiter): string {
    expect(shapeA.id).toBeLessThan(shapeB.id);
    expect(new Set([shapeA, shapeB, own, other]).size).toBe(2);
    expect(own).not.toBe(other);
    return `${shapeA.id}-${shapeB.id}`;
  }

  private note(type: string, ...ids: number[]): void {
    this.delivery.push([ORDER.indexOf(type), ...ids]);
  }

  /** A handler does one of the operations that wait for one. */
  private react(): void {
    const operation = this.waiting.shift();
    if (operation !== undefined && operation.op < this.operations(0).length) {
      this.apply(operation);
    }
  }

  /** At most three runs in order: what was caused before the step, what happened in it, and what the solver found. */
  private checkOrder(): void {
    let falls = 0;
    this.delivery.forEach((event, i) => {
      const last = this.delivery[i - 1] ?? [];
      const differing = event.findIndex((value, k) => value !== last[k]);
      falls += i > 0 && event[differing]! < last[differing]! ? 1 : 0;
    });
    expect(falls).toBeLessThanOrEqual(2);
  }

  /** With no operation left, what began and did not end is just what touches. */
  private checkRunning(): void {
    const touching = new Set(
      this.world.rigidBodies.flatMap(({ shapes }) =>
        shapes.flatMap(({ arbiters }) => arbiters.filter(({ active, sleeping }) => active || sleeping)),
      ),
    );
    for (const { size } of [this.running.a, this.running.b]) {
      expect(size).toBe(touching.size);
    }
    for (const [, arbiter] of this.running.a) {
      expect(touching).toContain(arbiter);
    }
  }

  private preSolve(): ShapeHandler {
    const seed = Math.floor(this.span(0, 1e9));
    const { world, bodies } = this;
    return (arbiter) => {
      const random = generator(seed + world.timeStamp);
      arbiter.setAcceptedState(random() < 0.5);
      arbiter.setPersistentState(random() < 0.2);
      expect(world.removeRigidBody(bodies[0]!)).toBe(false);
      expect(arbiter.sensor).toBe(false);
      expect(arbiter.getImpulseForBody(arbiter.bodyA).every(Number.isFinite)).toBe(true);
      if (random() < 0.3) {
        this.meddle(arbiter, random);
      }
    };
  }

  /** What a `preSolve` handler had better leave alone, but may call. */
  private meddle({ bodyA, bodyB, shapeA }: Arbiter, random: () => number): void {
    const body = random() < 0.5 ? bodyA : bodyB;
    const calls: (() => unknown)[] = [
      () => body.sleep(),
      () => body.wake(),
      () => body.setVelocity([random(), random()]),
      () => body.applyImpulse([random(), random()]),
      () => body.setMass(1 + random()),
      () => body.setAsStatic(),
      () => shapeA.setMask(MASKS[Math.floor(random() * MASKS.length)]!),
      () => shapeA.setGroup(GROUPS[Math.floor(random() * GROUPS.length)]!),
      () => shapeA.setMaterial(this.phys2D.createMaterial({ density: random() })),
      () => shapeA.addEventListener('preSolve', () => this.waiting.length),
      () => this.extra[0]?.(),
      () => this.constraints[0]?.wake(),
      () => this.constraints[0]?.sleep(),
      () => this.clear(),
    ];
    const dynamic = body.isDynamic();
    calls[Math.floor(random() * calls.length)]!();
    expect([body.isDynamic(), body.world]).toEqual([dynamic, this.world]);
  }

  private addExtra(shape: Shape): void {
    const type = this.pick(['begin', 'progress', 'preSolve', 'preSolve'] as const);
    const handler = type === 'preSolve' ? this.preSolve() : () => this.react();
    const mask = this.chance(0.5) ? this.pick(MASKS) : undefined;
    expect(shape.addEventListener(type, handler, mask, this.chance(0.5))).toBe(true);
    expect(shape.addEventListener(type, handler, mask)).toBe(false);
    this.extra.push(() => shape.removeEventListener(type, handler, mask));
  }

  /** Long enough without a push for what lies still to fall asleep. Not from a handler, where no step may be made. */
  private rest(): void {
    if (this.delivering) {
      return;
    }
    this.world.setGravity([0, 0]);
    for (const body of this.bodies.filter(() => this.chance(0.7))) {
      body.setVelocity([0, 0]);
      body.setAngularVelocity(0);
    }
    for (let i = 0; i < 65; i += 1) {
      this.step(1 / 60, i === 64);
    }
  }

  private clear(): void {
    this.world.clear();
    if (this.world.rigidBodies.length > 0) {
      return;
    }
    this.running.a.clear();
    this.running.b.clear();
  }

  private operations(who: number): (() => unknown)[] {
    const { world, constraints } = this;
    const body = this.bodies[who % this.bodies.length]!;
    const [first] = body.shapes;
    const constraint = constraints[who % constraints.length];
    const arbiter = first?.arbiters[0];
    return [
      () => this.addBody(),
      () => this.addBody(),
      () => world.removeRigidBody(body),
      () => world.removeRigidBody(body),
      () => world.addRigidBody(body),
      () => body.setAsDynamic(),
      () => body.setAsStatic(),
      () => body.setAsKinematic(),
      () => body.addShape(this.shape()),
      () => first && body.removeShape(first),
      () => body.sleep(),
      () => body.sleep(),
      () => body.wake(),
      () => body.setPosition([this.span(-2, 2), this.span(-2, 2)]),
      () => body.setVelocity([this.span(-5, 5), this.span(-5, 5)]),
      () => body.setVelocity([0, 0]),
      () => body.setMass(this.chance(0.2) ? Infinity : this.span(0.1, 10)),
      () => body.setSurfaceVelocity([this.span(0, 4), 0]),
      () => first?.setMask(this.pick(MASKS)),
      () => first?.setGroup(this.pick(GROUPS)),
      () => first?.scale(this.span(0.5, 1.5)),
      () => first?.type === 'POLYGON' && first.setVertices(this.vertices()),
      () => first?.setMaterial(this.phys2D.createMaterial({ density: this.span(0, 3) })),
      () => first && this.addExtra(first),
      () => first && this.addExtra(first),
      () => this.extra[who % this.extra.length]?.(),
      () => arbiter?.setElasticity(this.random()),
      () => arbiter?.setPersistentState(this.chance(0.5)),
      () => this.addConstraint(),
      () => constraint && world.addConstraint(constraint),
      () => constraint && world.removeConstraint(constraint),
      () => constraint && (constraint.isEnabled() ? constraint.disable() : constraint.enable()),
      () => constraint && (constraint.sleeping ? constraint.wake() : constraint.sleep()),
      () => constraint?.configure({ ignoreInteractions: this.chance(0.5), stiff: this.chance(0.5) }),
      () => world.setGravity([this.span(-2, 2), this.span(-10, 10)]),
      () => {
        world.allowSleeping = this.chance(0.8);
      },
      () => this.chance(0.2) && this.clear(),
      () => this.rest(),
    ];
  }
}

/** How many numbers stand for an operation; those above stand for a step. */
export const OPERATIONS = 38;
