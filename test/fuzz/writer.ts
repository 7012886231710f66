import { Values } from './values.js';

/** A statement; with `inner` ones, one that contains a function made of them. */
export interface Statement {
  readonly head: string;
  readonly inner: readonly string[];
  readonly tail: string;
}

export function textOf({ head, inner, tail }: Statement): string {
  return inner.length === 0 ? head + tail : `${head}\n    ${inner.join('\n    ')}\n  ${tail}`;
}

type Write = () => string;

/**
 * Writes random programs over the whole public API. Objects are named `w[0]` (worlds), `b` (bodies), `s` (shapes), `m` (materials), `c`
 * (constraints), `h` (handlers) and `p` (broadphases); those of a statement that was taken out are missing, and what is asked of them is left
 * out.
 */
export class Writer {
  private readonly v: Values;
  private readonly counts = { w: 0, b: 0, s: 0, m: 0, c: 0, h: 0 };

  constructor(seed: number) {
    this.v = new Values(seed);
  }

  write(length: number): Statement[] {
    const statements: Statement[] = [];
    const add = (text: string): unknown => statements.push({ head: text, inner: [], tail: '' });
    add(this.makeWorld());
    add(this.makeMaterial());
    for (let i = this.v.below(8); i >= 0; i -= 1) {
      this.addWhole(add);
    }
    while (statements.length < length) {
      if (this.v.chance(0.3)) {
        add(this.step());
      } else if (this.v.chance(0.06)) {
        this.addWhole(add);
      } else if (this.v.chance(0.08)) {
        add(this.makeConstraint());
        add(`if (c[${this.counts.c - 1}]) ${this.w()}?.addConstraint(c[${this.counts.c - 1}]);`);
      } else if (this.v.chance(0.1)) {
        statements.push(this.makeHandler());
        add(this.listen(`h[${this.counts.h - 1}]`));
      } else {
        add(this.any());
      }
    }
    return statements;
  }

  /** A body with a shape, in a world: at random these would seldom meet. */
  private addWhole(add: (text: string) => unknown): void {
    add(this.makeShape());
    add(this.makeBody(`s[${this.counts.s - 1}]`));
    add(`${this.w()}?.addRigidBody(b[${this.counts.b - 1}]);`);
  }

  private of(kind: keyof Writer['counts']): string {
    return `${kind}[${this.v.below(Math.max(1, this.counts[kind]))}]`;
  }

  private w = (): string => this.of('w');
  private b = (): string => this.of('b');
  private s = (): string => this.of('s');
  private c = (): string => this.of('c');

  private next(kind: keyof Writer['counts']): string {
    this.counts[kind] += 1;
    return `${kind}[${this.counts[kind] - 1}]`;
  }

  /** Options, each with a share of the chance to be given. */
  private options(share: number, given: Record<string, string | number>, always = ''): string {
    const parts = Object.entries(given)
      .filter(() => this.v.chance(share))
      .map(([name, value]) => `${name}: ${value}`);
    return `{ ${[always, ...parts].filter((part) => part !== '').join(', ')} }`;
  }

  private step(): string {
    return `step(${this.w()}, ${this.v.time()});`;
  }

  private makeWorld(): string {
    const { v } = this;
    const broadphase = `phys2D.${v.pick(['createBoxTreeBroadphase', 'createSweepAndPruneBroadphase'])}()`;
    const options = this.options(0.3, {
      broadphase,
      gravity: v.pair('speed'),
      substeps: 1 + v.below(6),
      velocityIterations: 1 + v.below(12),
      positionIterations: 1 + v.below(12),
      allowSleeping: v.flag(0.8),
    });
    return `${this.next('w')} = phys2D.createWorld(${options});`;
  }

  private makeMaterial(): string {
    const { v } = this;
    const options = this.options(0.6, {
      elasticity: v.elasticity(),
      staticFriction: v.share(),
      dynamicFriction: v.share(),
      rollingFriction: v.share(),
      density: v.chance(0.9) ? v.span(0.1, 3) : v.pick([0, 1e-6, 1e6]),
    });
    return `${this.next('m')} = phys2D.createMaterial(${options});`;
  }

  private makeShape(): string {
    const { v } = this;
    if (this.counts.s > 0 && v.chance(0.1)) {
      const from = this.s();
      return `${this.next('s')} = ${from}?.clone();`;
    }
    const common = {
      material: v.chance(0.2) ? 'phys2D.getDefaultMaterial()' : this.of('m'),
      sensor: v.flag(0.2),
      group: v.group(),
      mask: v.mask(),
      origin: v.pair('share'),
    };
    return v.chance(0.4)
      ? `${this.next('s')} = phys2D.createCircleShape(${this.options(0.25, common, `radius: ${v.size()}`)});`
      : `${this.next('s')} = phys2D.createPolygonShape(${this.options(0.25, common, `vertices: ${v.vertices()}`)});`;
  }

  private makeBody(shape: string): string {
    const { v } = this;
    const type = v.pick(['dynamic', 'dynamic', 'dynamic', 'static', 'kinematic']);
    const options = this.options(
      0.2,
      {
        rotation: v.angle(),
        velocity: v.pair('speed'),
        angularVelocity: v.speed(),
        mass: v.mass(),
        inertia: v.mass(),
        force: v.pair('force'),
        torque: v.force(),
        linearDrag: v.share(),
        angularDrag: v.share(),
        gravityScale: v.chance(0.8) ? '1' : v.force(),
        surfaceVelocity: v.pair('speed'),
        sleeping: v.flag(),
        allowSleeping: v.chance(0.8) ? 'true' : v.flag(),
        bullet: v.flag(),
      },
      `type: '${type}', position: ${v.pair('place')}, shapes: all(${shape}${v.chance(0.2) ? `, ${this.s()}` : ''})`,
    );
    return `${this.next('b')} = phys2D.createRigidBody(${options});`;
  }

  private makeConstraint(): string {
    const { v } = this;
    const [bodyA, bodyB, bodyC, bodyD] = [this.b(), this.b(), this.b(), this.b()];
    const common = {
      ...this.config(),
      sleeping: v.flag(0.3),
      disabled: v.flag(0.3),
      anchorA: v.pair('share'),
      anchorB: v.pair('share'),
      anchorC: v.pair('share'),
      anchorD: v.pair('share'),
    };
    const two = `bodyA: ${bodyA}, bodyB: ${bodyB}`;
    const axis = `[${v.span(-1, 1)}, ${v.span(0.1, 1)}]`;
    const make = (kind: string, own: string): string => {
      const call = `${this.next('c')} = phys2D.create${kind}Constraint(${this.options(0.3, common, own)});`;
      return `if (all(${bodyA}, ${bodyB}, ${bodyC}, ${bodyD}).length === 4) ${call}`;
    };
    return v.pick<Write>([
      () => make('Point', two),
      () => make('Weld', `${two}, phase: ${v.angle()}`),
      () => make('Angle', `${two}, ${v.bounds(-9)}, ratio: ${v.ratio()}`),
      () => make('Distance', `${two}, ${v.bounds(0)}`),
      () => make('Line', `${two}, axis: ${axis}, ${v.bounds(-9)}`),
      () => make('Motor', `${two}, rate: ${v.speed()}, ratio: ${v.ratio()}`),
      () => make('Pulley', `${two}, bodyC: ${bodyC}, bodyD: ${bodyD}, ${v.bounds(-9)}, ratio: ${v.ratio()}`),
      () => make('Custom', this.custom([bodyA, bodyB, bodyC].slice(0, 1 + v.below(3)))),
    ])();
  }

  private config(): Record<string, string | number> {
    const { v } = this;
    return {
      stiff: v.flag(),
      frequency: v.chance(0.9) ? v.span(0.2, 30) : v.pick([1e-3, 1e3]),
      damping: v.share(),
      maxForce: v.limit(),
      maxError: v.limit(),
      removeOnBreak: v.flag(),
      breakUnderForce: v.flag(0.3),
      breakUnderError: v.flag(0.3),
      ignoreInteractions: v.flag(),
    };
  }

  /** Linear in the placements of its bodies; callbacks may query, fail, or write what is no number. */
  private custom(bodies: readonly string[]): string {
    const { v } = this;
    const dimension = 1 + v.below(3);
    const row = Array.from({ length: 3 * dimension * bodies.length }, () => v.span(-1, 1));
    const errors = Array.from({ length: dimension }, () => v.span(-1, 1));
    const write = (values: readonly number[]): string =>
      values.map((value, i) => `data[i + ${i}] = ${value};`).join(' ');
    const trouble = (): string =>
      v.chance(0.1) ? ` ${v.pick(['data[i] = NaN;', 'stop();', `${this.query()}`, 'data[i] = 1e30;'])}` : '';
    const body = bodies[0]!;
    const callbacks = [
      `jacobian: (data, i) => { ${write(row)}${trouble()} }`,
      v.chance(0.7) && `position: (data, i) => { ${write(errors)} data[i] += ${body}.getPosition()[0];${trouble()} }`,
      v.chance(0.2) && `positionConstants: () => { ${v.chance(0.1) ? 'stop();' : this.query()} }`,
      v.chance(0.2) && `velocityClamp: (data, i) => { data[i] = Math.max(data[i], 0);${trouble()} }`,
      v.chance(0.2) && `positionClamp: (data, i) => { data[i] = Math.min(data[i], ${v.span(0, 1)});${trouble()} }`,
    ];
    return `dimension: ${dimension}, bodies: [${bodies}], ${callbacks.filter((text) => text !== false).join(', ')}`;
  }

  private makeHandler(): Statement {
    const inner = Array.from({ length: 1 + this.v.below(4) }, () => {
      const arbiter = this.v.pick(ARBITER_CALLS);
      return this.v.chance(0.2)
        ? `arbiter?.${arbiter(this.v)};`
        : this.v.chance(0.1)
          ? this.v.pick(['stop();', 'look(arbiter);', 'look(hit);', this.step()])
          : this.any();
    });
    const times = this.v.pick([1, 3, 10]);
    return { head: `${this.next('h')} = few(${times}, (arbiter, other, hit) => {`, inner, tail: '});' };
  }

  private listen(handler: string): string {
    const { v } = this;
    const call = v.chance(0.85) ? 'addEventListener' : 'removeEventListener';
    const isShape = v.chance(0.7);
    const owner = isShape ? this.s() : v.chance(0.5) ? this.b() : this.c();
    if (isShape) {
      const type = v.pick(['begin', 'progress', 'end', 'preSolve', 'preSolve', 'hit'] as const);
      const mask = v.chance(0.7) ? 'undefined' : v.mask();
      const option = v.chance(0.7) ? '' : type === 'hit' ? `, ${v.span(0, 2)}` : `, ${v.flag()}`;
      return `if (${handler}) ${owner}?.${call}('${type}', ${handler}, ${mask}${call === 'addEventListener' ? option : ''});`;
    }
    const type = v.pick(owner.startsWith('b') ? ['wake', 'sleep'] : ['wake', 'sleep', 'break']);
    return `if (${handler}) ${owner}?.${call}('${type}', ${handler});`;
  }

  private query(): string {
    const { v } = this;
    const w = this.w();
    const shape = this.s();
    const ray = `{ origin: ${v.pair('place')}, direction: [${v.span(-1, 1)}, ${v.span(0.1, 1)}], maxFactor: ${v.limit()} }`;
    const accept = v.chance(0.5) ? '' : `, () => ${v.flag()}`;
    const [a, b] = [this.s(), this.s()];
    return v.pick<Write>([
      () => `${w}?.shapePointQuery(${v.pair('place')}, []);`,
      () => `${w}?.bodyPointQuery(${v.pair('place')}, []);`,
      () => `${w}?.shapeCircleQuery(${v.pair('place')}, ${v.size()}, []);`,
      () => `${w}?.bodyCircleQuery(${v.pair('place')}, ${v.size()}, []);`,
      () => `${w}?.shapeRectangleQuery([${v.place()}, ${v.place()}, ${v.place()}, ${v.place()}], []);`,
      () => `${w}?.bodyRectangleQuery([${v.place()}, ${v.place()}, ${v.place()}, ${v.place()}], []);`,
      () => `if (${shape}?.body) ${w}?.shapeQuery(${shape}, []);`,
      () => `${w}?.rayCast(${ray}, ${v.flag()}${accept});`,
      () => `${w}?.rayCastAll(${ray}, ${v.flag()}, []);`,
      () => `if (${shape}?.body) ${w}?.convexCast(${shape}, ${v.time()}${accept});`,
      () => `if (${a}?.body) utils.containsPoint(${a}, ${v.pair('place')});`,
      () => `if (${a}?.body && ${b}?.body && ${a} !== ${b}) utils.signedDistance(${a}, ${b}, [], [], []);`,
      () => `if (${a}?.body && ${b}?.body && ${a} !== ${b}) utils.intersects(${a}, ${b});`,
      () => `if (${a}?.body && ${b}?.body && ${a} !== ${b}) utils.sweepTest(${a}, ${b}, ${v.time()}, [], []);`,
      () => `if (${a}?.body) utils.rayTest(${a}, ${ray}, [], ${v.flag()});`,
    ])();
  }

  /** Any call but a step. */
  private any(): string {
    const { v } = this;
    return v.pick<Write>([
      () =>
        v.chance(0.1) && this.counts.w < 3 ? this.makeWorld() : v.chance(0.3) ? this.makeMaterial() : this.makeShape(),
      () => this.makeBody(this.s()),
      () => this.makeConstraint(),
      () => this.listen(this.of('h')),
      () => this.ofWorld(),
      () => this.ofWorld(),
      () => this.ofWorld(),
      () => `${this.b()}?.${v.pick(BODY_CALLS)(v)};`,
      () => `${this.b()}?.${v.pick(BODY_CALLS)(v)};`,
      () => `${this.b()}?.${v.pick(BODY_CALLS)(v)};`,
      () => this.ofBodyAndShape(),
      () => `${this.s()}?.${v.pick(SHAPE_CALLS)(v)};`,
      () => `${this.s()}?.${v.pick(SHAPE_CALLS)(v)};`,
      () => `${this.c()}?.${v.pick(CONSTRAINT_CALLS)(v)};`,
      () => `${this.c()}?.configure(${this.options(0.3, this.config())});`,
      () => `bind(${this.c()}, ${v.span(-3, 3)}, ${v.span(-3, 3)});`,
      () => `${this.s()}?.arbiters[${v.below(3)}]?.${v.pick(ARBITER_CALLS)(v)};`,
      () =>
        `look(${v.pick<Write>([this.w, this.b, this.s, this.c, () => this.of('m'), () => `${this.s()}?.arbiters[0]`])()});`,
      () => this.query(),
    ])();
  }

  private ofWorld(): string {
    const { v } = this;
    const w = this.w();
    const [b, c] = [this.b(), this.c()];
    return v.pick<Write>([
      () => `if (${b}) ${w}?.addRigidBody(${b});`,
      () => `if (${b}) ${w}?.addRigidBody(${b});`,
      () => `if (${b} && ${w}) ${w}.removeRigidBody(${b});`,
      () => `if (${b}) ${b}.world?.removeRigidBody(${b});`,
      () => `move(${b}, ${w});`,
      () => `save(${w});`,
      () => `if (${c}) ${w}?.addConstraint(${c});`,
      () => `if (${c}) ${w}?.addConstraint(${c});`,
      () => `if (${c}) ${w}?.addConstraint(${c});`,
      () => `if (${c}) ${c}.world?.removeConstraint(${c});`,
      () => (v.chance(0.1) ? `${w}?.clear();` : `step(${w}, ${v.time()});`),
      () => `${w}?.setGravity(${v.pair('speed')});`,
      () => `if (${w}) ${w}.allowSleeping = ${v.flag(0.8)};`,
      () => `if (${w}) ${w}.${v.pick(['substeps', 'velocityIterations', 'positionIterations'])} = ${1 + v.below(10)};`,
      () => `if (${w}) ${w}.clock = ${v.pick(['null', '() => performance.now()'])};`,
      () => `for (let i = 0; i < ${v.pick([5, 70])}; i += 1) step(${w}, 1 / 60);`,
    ])();
  }

  private ofBodyAndShape(): string {
    const { v } = this;
    const [b, s] = [this.b(), this.s()];
    return v.pick<Write>([
      () => `if (${s}) ${b}?.addShape(${s});`,
      () => `if (${s}) ${b}?.removeShape(${s});`,
      () => `if (${s}) ${s}.body?.removeShape(${s});`,
      () => `if (${this.of('m')}) ${s}?.setMaterial(${this.of('m')} ?? phys2D.getDefaultMaterial());`,
    ])();
  }
}

type Calls = readonly ((v: Values) => string)[];

const BODY_CALLS: Calls = [
  () => 'setAsDynamic()',
  () => 'setAsKinematic()',
  () => 'setAsStatic()',
  (v) => `setPosition(${v.pair('place')})`,
  (v) => `setRotation(${v.angle()})`,
  (v) => `setVelocity(${v.pair('speed')})`,
  () => 'setVelocity([0, 0])',
  (v) => `setAngularVelocity(${v.speed()})`,
  (v) => `setVelocityFromPosition(${v.pair('place')}, ${v.angle()}, 1 / 60)`,
  (v) => `applyImpulse(${v.pair('force')})`,
  (v) => `applyImpulse(${v.pair('force')}, ${v.pair('place')})`,
  (v) => `integrate(${v.chance(0.5) ? '' : '-'}${v.time()})`,
  (v) => `setForce(${v.pair('force')})`,
  (v) => `setTorque(${v.force()})`,
  (v) => `applyForce(${v.pair('force')})`,
  (v) => `applyForce(${v.pair('force')}, ${v.pair('place')})`,
  (v) => `applyTorque(${v.force()})`,
  (v) => `applyAngularImpulse(${v.force()})`,
  (v) => `setLinearDrag(${v.share()})`,
  (v) => `setAngularDrag(${v.share()})`,
  (v) => `setGravityScale(${v.share()})`,
  (v) => `setSurfaceVelocity(${v.pair('speed')})`,
  (v) => `setMass(${v.mass()})`,
  (v) => `setInertia(${v.mass()})`,
  () => 'setMassFromShapes()',
  () => 'setInertiaFromShapes()',
  () => 'alignWithOrigin()',
  () => 'wake()',
  () => 'sleep()',
  () => 'sleep()',
];

const SHAPE_CALLS: Calls = [
  (v) => `setGroup(${v.group()})`,
  (v) => `setMask(${v.mask()})`,
  (v) => `scale(${v.span(0.5, 1.5)})`,
  (v) => `scale(${v.span(0.5, 1.5)}, ${v.span(0.5, 1.5)})`,
  (v) => `translate(${v.pair('share')})`,
  (v) => `rotate(${v.angle()})`,
  (v) => `transform([${v.span(0.5, 1.5)}, ${v.span(-0.4, 0.4)}, ${v.span(-0.4, 0.4)}, ${v.span(0.5, 1.5)}, 0, 0])`,
  (v) => `setRadius?.(${v.size()})`,
  (v) => `setOrigin?.(${v.pair('share')})`,
  (v) => `setVertices?.(${v.vertices()})`,
];

const CONSTRAINT_CALLS: Calls = [
  () => 'enable()',
  () => 'disable()',
  () => 'wake()',
  () => 'sleep()',
  (v) => `setAnchorA?.(${v.pair('share')})`,
  (v) => `setAnchorB?.(${v.pair('share')})`,
  (v) => `setAnchorC?.(${v.pair('share')})`,
  (v) => `setAnchorD?.(${v.pair('share')})`,
  (v) => `setPhase?.(${v.angle()})`,
  (v) => `setRate?.(${v.speed()})`,
  (v) => `setRatio?.(${v.ratio()})`,
  (v) => `setAxis?.([${v.span(-1, 1)}, ${v.span(0.1, 1)}])`,
];

const ARBITER_CALLS: Calls = [
  (v) => `setElasticity(${v.elasticity()})`,
  (v) => `setStaticFriction(${v.share()})`,
  (v) => `setDynamicFriction(${v.share()})`,
  (v) => `setRollingFriction(${v.share()})`,
  () => 'setElasticityFromShapes()',
  () => 'setStaticFrictionFromShapes()',
  () => 'setDynamicFrictionFromShapes()',
  () => 'setRollingFrictionFromShapes()',
  (v) => `setAcceptedState(${v.flag()})`,
  (v) => `setPersistentState(${v.flag()})`,
];
