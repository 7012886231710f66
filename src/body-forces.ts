import { Applied } from './body-applied.js';
import { DYNAMIC } from './body-kind.js';
import { BodyState } from './body-state.js';
import { type NumberSink, type Vec2, type Vec2Like, vec2 } from './math/vectors.js';
import { finite, leadsTo, vector } from './validate.js';

/** What pushes a body: forces that last, forces for one step, impulses, its share of gravity. {@link RigidBody} is its public face. */
export abstract class BodyForces extends BodyState {
  /** The force that `setForce` set, N: without gravity, contacts and constraints. */
  getForce(): Vec2;
  getForce<T extends NumberSink>(dst: T): T;
  getForce<T extends NumberSink>(dst?: T): T | Vec2 {
    return vec2(this.fx, this.fy, 'RigidBody.getForce', dst);
  }

  /** Sets the force, N, that acts in every step until changed. Wakes the body if changed. */
  setForce(force: Vec2Like): void {
    vector('RigidBody.setForce', 'force', force, 2);
    if (force[0] !== this.fx || force[1] !== this.fy) {
      this.fx = force[0]!;
      this.fy = force[1]!;
      this.rouse();
    }
  }

  /** The torque that `setTorque` set, N·m. */
  getTorque(): number {
    return this.appliedTorque;
  }

  /** Sets the torque, N·m, that acts in every step until changed. Wakes the body if changed. */
  setTorque(torque: number): void {
    finite('RigidBody.setTorque', 'torque', torque);
    if (torque !== this.appliedTorque) {
      this.appliedTorque = torque;
      this.rouse();
    }
  }

  /** How much of the gravity of the world acts on it; 1 unless set. */
  getGravityScale(): number {
    return this.gravityScale;
  }

  /** Sets how much of the gravity of the world acts on it: 0 none, −1 the opposite, 2 twice as much. Wakes the body if changed. Dynamic bodies feel it. */
  setGravityScale(gravityScale: number): void {
    finite('RigidBody.setGravityScale', 'gravityScale', gravityScale);
    if (gravityScale !== this.gravityScale) {
      this.gravityScale = gravityScale;
      this.rouse();
    }
  }

  /**
   * Adds a force, N, at a world point, to those that act in the next step, evenly, and no longer; without a point at the body origin, which turns nothing. Call it before each
   * step for a thruster, wind or buoyancy, also while the body sleeps: it falls asleep where it rests under what hardly changes from step to step, and wakes in the step in which that is no longer so.
   * What is added must stay within 1e150, and is lost if the body is put to sleep, leaves its world or is made static or kinematic before. Dynamic bodies only.
   */
  applyForce(force: Vec2Like, position?: Vec2Like): void {
    const where = 'RigidBody.applyForce';
    const moment = this.momentOf(where, 'force', force, position);
    this.push(where, 'force', force, force[0]!, force[1]!, moment);
  }

  /** Adds a torque, N·m, as `applyForce` adds a force. */
  applyTorque(torque: number): void {
    const where = 'RigidBody.applyTorque';
    this.push(where, 'torque', torque, 0, 0, finite(where, 'torque', torque));
  }

  /**
   * Applies an impulse, N·s, at a world point; without a point at the body origin, which turns nothing. Velocities must stay
   * within 1e150. Dynamic bodies only; wakes the body.
   */
  applyImpulse(impulse: Vec2Like, position?: Vec2Like): void {
    const where = 'RigidBody.applyImpulse';
    const moment = this.momentOf(where, 'impulse', impulse, position);
    if (this.kind !== DYNAMIC) {
      return;
    }
    const inverseMass = this.inverseMass();
    const vx = this.vx + impulse[0]! * inverseMass;
    const vy = this.vy + impulse[1]! * inverseMass;
    const w = moment === 0 ? this.w : this.w + moment * this.inverseInertia();
    leadsTo(where, 'impulse', impulse, 'velocities', vx, vy, w);
    this.vx = vx;
    this.vy = vy;
    this.w = w;
    this.rouse();
  }

  /** Applies an angular impulse, N·m·s. The velocity must stay within 1e150. Dynamic bodies only; wakes the body. */
  applyAngularImpulse(impulse: number): void {
    const where = 'RigidBody.applyAngularImpulse';
    finite(where, 'impulse', impulse);
    if (this.kind === DYNAMIC) {
      const w = this.w + impulse * this.inverseInertia();
      leadsTo(where, 'impulse', impulse, 'a velocity', w);
      this.w = w;
      this.rouse();
    }
  }

  /** @internal something pushes it in the next step, other than the gravity of the world */
  hasForce(): boolean {
    return (
      this.gravityScale !== 1 ||
      this.fx !== 0 ||
      this.fy !== 0 ||
      this.appliedTorque !== 0 ||
      (this.applied?.pushes() ?? false)
    );
  }

  /** About the origin, of what acts at a point, 0 without one; after a check of both. */
  private momentOf(where: string, name: string, given: Vec2Like, position: Vec2Like | undefined): number {
    vector(where, name, given, 2);
    if (position === undefined) {
      return 0;
    }
    vector(where, 'position', position, 2);
    return (position[0]! - this.x) * given[1]! - (position[1]! - this.y) * given[0]!;
  }

  private push(where: string, name: string, given: unknown, x: number, y: number, torque: number): void {
    if (this.kind !== DYNAMIC) {
      return;
    }
    const applied = this.applied ?? new Applied();
    leadsTo(where, name, given, 'forces', applied.x + x, applied.y + y, applied.torque + torque);
    if (this.asleep) {
      if (this.owner === null || this.owner.stepping) this.rouse();
      else this.owner.pushed.add(this);
    }
    this.applied = applied;
    applied.x += x;
    applied.y += y;
    applied.torque += torque;
  }
}
