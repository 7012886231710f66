import type { RigidBody } from '../body.js';
import type { Constraint } from '../constraint/constraint.js';
import type { Arbiter } from '../contact/arbiter.js';
import type { Shape } from '../shape/shape.js';
import type { World } from '../world.js';

type Subject = World | RigidBody | Shape | Arbiter | Constraint;

/** Throws errors that say what is wrong where. Names are looked up only then, so that checks that hold cost little. */
export class Audit {
  constructor(readonly world: World) {}

  /** @throws Error that names the object and the rule, unless it holds. */
  demand(holds: boolean, subject: Subject, rule: string): void {
    if (!holds) {
      throw new Error(`validate: ${this.nameOf(subject)}: ${rule}`);
    }
  }

  finite(subject: Subject, name: string, value: number): void {
    if (!Number.isFinite(value)) {
      throw new Error(`validate: ${this.nameOf(subject)}: ${name} must be a finite number, got ${value}`);
    }
  }

  /** Any number >= 0, `Infinity` included. */
  nonNegative(subject: Subject, name: string, value: number): void {
    if (!(value >= 0)) {
      throw new Error(`validate: ${this.nameOf(subject)}: ${name} must be a number >= 0, got ${value}`);
    }
  }

  /** Demands that no entry of a list is there twice. */
  distinct(list: readonly unknown[], subject: Subject, name: string): void {
    this.demand(new Set(list).size === list.length, subject, `${name} must have each entry once`);
  }

  private nameOf(subject: Subject): string {
    if ('rigidBodies' in subject) {
      return 'world';
    }
    if ('shapeA' in subject) {
      return `the arbiter of shapes ${subject.shapeA.id} and ${subject.shapeB.id}`;
    }
    if ('arbiters' in subject) {
      return `shape ${subject.id}`;
    }
    const isBody = 'shapes' in subject;
    const name = isBody ? 'rigidBodies' : 'constraints';
    const index = (this.world[name] as readonly Subject[]).indexOf(subject);
    const place = index < 0 ? 'elsewhere' : `world.${name}[${index}]`;
    return isBody ? place : `${place} (${subject.type})`;
  }
}
