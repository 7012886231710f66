import { Applied } from './body-applied.js';
import { DYNAMIC } from './body-kind.js';
import { BodyState } from './body-state.js';
import { type NumberSink, type Vec2, type Vec2Like, vec2 } from './math/vectors.js';
import { finite, leadsTo, vector } from './validate.js';

/** The forces on a body: lasting forces, forces for one step, impulses, its share of gravity. {@link RigidBody} is its public face. */
export abstract class BodyForces extends BodyState {
  /** The force set by `setForce`, N, without gravity, contacts and constraints. */
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

  /** The torque set by `setTorque`, N·m. */
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

  /** How much of the world's gravity acts on the body; 1 unless set. */
  getGravityScale(): number {
    return this.gravityScale;
  }

  /**
   * Sets how much of the world's gravity acts on the body: 0 none, −1 the opposite, 2 twice as much. Only dynamic bodies feel it. Wakes the
   * body if changed.
   */
  setGravityScale(gravityScale: number): void {
    finite('RigidBody.setGravityScale', 'gravityScale', gravityScale);
    if (gravityScale !== this.gravityScale) {
      this.gravityScale = gravityScale;
      this.rouse();
    }
  }

  /**
   * Adds a force, N, at a world point, that acts evenly throughout the next step and no longer. Without a point it acts at the body origin,
   * and does not turn the body. For a thruster, wind or buoyancy, call it before each step, also while the body sleeps: the body falls
   * asleep if it rests under forces that hardly change from step to step, and wakes in the step in which they change.
   *
   * The sum of what is added must stay within 1e150. It is lost if the body is put to sleep, leaves its world or is made static or
   * kinematic before the step. Dynamic bodies only.
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
   * Applies an impulse, N·s, at a world point; without a point at the body origin, which does not turn the body. The velocities must stay
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

  /** @internal whether anything but the world's gravity, unscaled, acts on it in the next step */
  hasForce(): boolean {
    return (
      this.gravityScale !== 1 ||
      this.fx !== 0 ||
      this.fy !== 0 ||
      this.appliedTorque !== 0 ||
      (this.applied?.pushes() ?? false)
    );
  }

  /** Checks a force or impulse and its point, and returns its moment about the origin: 0 without a point. */
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
