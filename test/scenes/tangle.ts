import type { Constraint, CustomConstraintParams, Physics2DDevice, RigidBody, Vec2, World } from '../../src/index.js';
import { generator } from './mixed.js';

const TYPES = ['dynamic', 'dynamic', 'dynamic', 'static', 'kinematic'] as const;
const RATIOS = [1, -1, 2, 0.5, -0.3, 10];

/**
 * Bodies of all types, some of infinite mass or inertia, with constraints of all kinds and random options between them, whether or
 * not they can be met.
 */
export class Tangle {
  readonly bodies: RigidBody[] = [];
  readonly constraints: Constraint[] = [];
  private readonly random: () => number;

  constructor(
    private readonly phys2D: Physics2DDevice,
    readonly world: World,
    seed: number,
    bodies: number,
    constraints: number,
  ) {
    this.random = generator(seed);
    for (let i = 0; i < bodies; i += 1) {
      this.addBody();
    }
    for (let i = 0; i < constraints; i += 1) {
      const constraint = this.makeConstraint();
      world.addConstraint(constraint);
      this.constraints.push(constraint);
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
    const { phys2D } = this;
    const vertices = phys2D.createBoxVertices(this.span(0.2, 1.5), this.span(0.2, 1.5));
    const body = phys2D.createRigidBody({
      type: this.pick(TYPES),
      position: [this.span(-8, 8), this.span(-8, 8)],
      rotation: this.span(-3, 3),
      velocity: [this.span(-3, 3), this.span(-3, 3)],
      angularVelocity: this.span(-3, 3),
      shapes: [
        this.chance(0.5)
          ? phys2D.createCircleShape({ radius: this.span(0.1, 0.8) })
          : phys2D.createPolygonShape({ vertices }),
      ],
      mass: this.chance(0.15) ? Infinity : this.chance(0.2) ? this.span(0.1, 50) : undefined,
      inertia: this.chance(0.15) ? Infinity : this.chance(0.2) ? this.span(0.05, 50) : undefined,
      sleeping: this.chance(0.1),
    });
    if (this.chance(0.95)) {
      this.world.addRigidBody(body);
    }
    this.bodies.push(body);
  }

  private anchor(): Vec2 {
    const far = this.chance(0.2) ? 5 : 1;
    return [this.span(-far, far), this.span(-far, far)];
  }

  /** A constraint of some kind between some of the bodies; not added. */
  makeConstraint(): Constraint {
    const { phys2D } = this;
    const [bodyA, bodyB, bodyD] = [this.pick(this.bodies), this.pick(this.bodies), this.pick(this.bodies)];
    const common = {
      bodyA,
      bodyB,
      stiff: this.chance(0.6),
      frequency: this.span(0.2, 30),
      damping: this.span(0, 2),
      sleeping: this.chance(0.1),
      disabled: this.chance(0.1),
      maxForce: this.chance(0.7) ? Infinity : this.span(0, 500),
      maxError: this.chance(0.7) ? Infinity : this.span(0, 3),
      breakUnderForce: this.chance(0.2),
      breakUnderError: this.chance(0.2),
      removeOnBreak: this.chance(0.5),
      ignoreInteractions: this.chance(0.5),
    };
    const anchored = { ...common, anchorA: this.anchor(), anchorB: this.anchor() };
    const lower = this.span(-3, 3);
    const upper = this.chance(0.3) ? lower : this.chance(0.2) ? Infinity : lower + this.span(0, 3);
    const bounds = { lowerBound: upper > lower && this.chance(0.3) ? -Infinity : lower, upperBound: upper };
    const ratio = this.pick(RATIOS);
    const kinds: (() => Constraint)[] = [
      () => phys2D.createPointConstraint(anchored),
      () => phys2D.createWeldConstraint({ ...anchored, phase: this.span(-4, 4) }),
      () => {
        const least = Math.abs(lower);
        const most = upper === lower ? least : Math.max(least, upper);
        return phys2D.createDistanceConstraint({ ...anchored, lowerBound: least, upperBound: most });
      },
      () => phys2D.createLineConstraint({ ...anchored, ...bounds, axis: [this.span(-1, 1), this.span(0.1, 1)] }),
      () => phys2D.createAngleConstraint({ ...common, ...bounds, ratio }),
      () => phys2D.createMotorConstraint({ ...common, ratio, rate: this.span(-10, 10) }),
      () => {
        const bodyC = this.chance(0.5) ? bodyB : this.pick(this.bodies);
        const anchors = { anchorC: this.anchor(), anchorD: this.anchor() };
        return phys2D.createPulleyConstraint({ ...anchored, ...bounds, ...anchors, bodyC, bodyD, ratio });
      },
      () => phys2D.createCustomConstraint({ ...common, ...this.custom([bodyA, bodyB, bodyD]) }),
    ];
    return this.pick(kinds)();
  }

  /** A linear form of the placements of one to three bodies. */
  private custom(choice: RigidBody[]): CustomConstraintParams {
    const bodies = choice.slice(0, 1 + Math.floor(3 * this.random()));
    const dimension = 1 + Math.floor(3 * this.random());
    const width = 3 * bodies.length;
    const row = Array.from({ length: dimension * width }, () => this.span(-1, 1));
    const offset = this.span(-1, 1);
    const position: CustomConstraintParams['position'] = (data, index) => {
      for (let d = 0; d < dimension; d += 1) {
        data[index + d] = bodies.reduce((sum, body, k) => {
          const [x, y] = body.getPosition();
          const at = d * width + 3 * k;
          return sum + row[at]! * x + row[at + 1]! * y + row[at + 2]! * body.getRotation();
        }, offset);
      }
    };
    const jacobian: CustomConstraintParams['jacobian'] = (data, index) => {
      row.forEach((value, i) => {
        data[index + i] = value;
      });
    };
    return this.chance(0.7) ? { bodies, dimension, jacobian, position } : { bodies, dimension, jacobian };
  }
}
