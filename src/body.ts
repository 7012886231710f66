import { BodyForces } from './body-forces.js';
import { DYNAMIC, KINEMATIC, STATIC } from './body-kind.js';
import type { RigidBodyParams } from './body-params.js';
import { addListener, bitOf, OF_BODIES, plainListener, removeListener } from './listeners.js';
import { takeOut } from './math/list.js';
import { type NumberSink, type Vec2, type Vec2Like, vec2 } from './math/vectors.js';
import { Shape } from './shape/shape.js';
import { callable, finite, instance, leadsTo, nonNegative, positive, positiveOrInfinite, vector } from './validate.js';
import type { World } from './world.js';

/** The events of a body. */
export type BodyEventType = 'wake' | 'sleep';

/** Called without arguments, `this` = the body. */
export type BodyHandler = (this: RigidBody) => void;

/**
 * A rigid body: shapes that move together. The body origin is its centre of rotation and of gravity, wherever the shapes are; see
 * `alignWithOrigin`. In a world, changes wake the body unless stated otherwise; teleports and geometry changes are ignored during a step.
 */
export class RigidBody extends BodyForces {
  /** Of the class, as in Turbulenz. */
  static get version(): number {
    return 1;
  }

  /** @internal use `createRigidBody` */
  constructor(params?: RigidBodyParams) {
    super(params);
  }

  /** The world the body is in, or `null`. */
  get world(): World | null {
    return this.owner;
  }

  /** Whether it is asleep: at rest, and left out of steps. Always `true` for a static body in a world. */
  get sleeping(): boolean {
    return this.asleep;
  }

  /** Whether it is dynamic: moved by forces and contacts. */
  isDynamic(): boolean {
    return this.kind === DYNAMIC;
  }

  /** Whether it is kinematic: moved by its velocity alone. */
  isKinematic(): boolean {
    return this.kind === KINEMATIC;
  }

  /** Whether it is static: not moved at all. */
  isStatic(): boolean {
    return this.kind === STATIC;
  }

  /** Makes the body dynamic; its velocity stays. Ignored during a step. */
  setAsDynamic(): void {
    this.setKind(DYNAMIC);
  }

  /** Makes the body kinematic; its velocity stays. Ignored during a step. */
  setAsKinematic(): void {
    this.setKind(KINEMATIC);
  }

  /** Makes the body static and zeroes its velocities. Ignored during a step. */
  setAsStatic(): void {
    this.setKind(STATIC);
  }

  /** The position of the body origin in the world, m. */
  getPosition(): Vec2;
  getPosition<T extends NumberSink>(dst: T): T;
  getPosition<T extends NumberSink>(dst?: T): T | Vec2 {
    return vec2(this.x, this.y, 'RigidBody.getPosition', dst);
  }

  /**
   * Sets the position of the body origin in the world, m: a teleport. Ignored during a step and for a static body in a world. Wakes the
   * body if changed.
   */
  setPosition(position: Vec2Like): void {
    vector('RigidBody.setPosition', 'position', position, 2);
    if (!this.isLocked() && (position[0] !== this.x || position[1] !== this.y)) {
      this.putAt(position[0]!, position[1]!, this.angle);
      this.rouse();
    }
  }

  /** The rotation, clockwise on screen, rad; never wrapped to a range. */
  getRotation(): number {
    return this.angle;
  }

  /** Sets the rotation, clockwise on screen, rad: a teleport. Ignored as `setPosition` is. Wakes the body if changed. */
  setRotation(rotation: number): void {
    finite('RigidBody.setRotation', 'rotation', rotation);
    if (!this.isLocked() && rotation !== this.angle) {
      this.putAt(this.x, this.y, rotation);
      this.rouse();
    }
  }

  /** The velocity of the body origin, m/s; y points down. */
  getVelocity(): Vec2;
  getVelocity<T extends NumberSink>(dst: T): T;
  getVelocity<T extends NumberSink>(dst?: T): T | Vec2 {
    return vec2(this.vx, this.vy, 'RigidBody.getVelocity', dst);
  }

  /** The velocity of the body at a world point, m/s. */
  getVelocityAtPoint(position: Vec2Like): Vec2;
  getVelocityAtPoint<T extends NumberSink>(position: Vec2Like, dst: T): T;
  getVelocityAtPoint<T extends NumberSink>(position: Vec2Like, dst?: T): T | Vec2 {
    const where = 'RigidBody.getVelocityAtPoint';
    vector(where, 'position', position, 2);
    const { x, y, vx, vy, w } = this;
    return vec2(vx - w * (position[1]! - y), vy + w * (position[0]! - x), where, dst);
  }

  /** Sets the velocity, m/s. A static body has none. Wakes the body if changed. */
  setVelocity(velocity: Vec2Like): void {
    vector('RigidBody.setVelocity', 'velocity', velocity, 2);
    if (this.kind !== STATIC && (velocity[0] !== this.vx || velocity[1] !== this.vy)) {
      this.vx = velocity[0]!;
      this.vy = velocity[1]!;
      this.rouse();
    }
  }

  /** The angular velocity, clockwise on screen, rad/s. */
  getAngularVelocity(): number {
    return this.w;
  }

  /** Sets the angular velocity, rad/s. A static body has none. Wakes the body if changed. */
  setAngularVelocity(angularVelocity: number): void {
    finite('RigidBody.setAngularVelocity', 'angularVelocity', angularVelocity);
    if (this.kind !== STATIC && angularVelocity !== this.w) {
      this.w = angularVelocity;
      this.rouse();
    }
  }

  /** Sets the velocities that move the body to the given placement in `deltaTime` seconds (> 0). Each must come to at most 1e150. Wakes the body. */
  setVelocityFromPosition(targetPosition: Vec2Like, targetRotation: number, deltaTime: number): void {
    const where = 'RigidBody.setVelocityFromPosition';
    vector(where, 'targetPosition', targetPosition, 2);
    finite(where, 'targetRotation', targetRotation);
    positive(where, 'deltaTime', deltaTime);
    if (this.kind === STATIC) {
      return;
    }
    const vx = (targetPosition[0]! - this.x) / deltaTime;
    const vy = (targetPosition[1]! - this.y) / deltaTime;
    const w = (targetRotation - this.angle) / deltaTime;
    leadsTo(where, 'deltaTime', deltaTime, 'velocities', vx, vy, w);
    this.vx = vx;
    this.vy = vy;
    this.w = w;
    this.rouse();
  }

  /**
   * Moves the body with its velocities for `deltaTime` seconds; a negative time moves it back. Position and rotation must stay within 1e150
   * m and rad. Ignored as `setPosition` is. Wakes the body.
   */
  integrate(deltaTime: number): void {
    const where = 'RigidBody.integrate';
    finite(where, 'deltaTime', deltaTime);
    if (!this.isLocked()) {
      const x = this.x + this.vx * deltaTime;
      const y = this.y + this.vy * deltaTime;
      const angle = this.angle + this.w * deltaTime;
      leadsTo(where, 'deltaTime', deltaTime, 'a placement', x, y, angle);
      this.putAt(x, y, angle);
      this.rouse();
    }
  }

  /** The share of the velocity lost per second; 0.05 unless set. */
  getLinearDrag(): number {
    return this.linearDrag;
  }

  /** Sets the share of the velocity lost per second, >= 0; 1 and more stop the body in each step. Wakes the body. */
  setLinearDrag(linearDrag: number): void {
    this.linearDrag = nonNegative('RigidBody.setLinearDrag', 'linearDrag', linearDrag);
    this.rouse();
  }

  /** The share of the angular velocity lost per second; 0.05 unless set. */
  getAngularDrag(): number {
    return this.angularDrag;
  }

  /** Sets the share of the angular velocity lost per second, >= 0; 1 and more stop its rotation in each step. Wakes the body. */
  setAngularDrag(angularDrag: number): void {
    this.angularDrag = nonNegative('RigidBody.setAngularDrag', 'angularDrag', angularDrag);
    this.rouse();
  }

  /** The velocity of the surface, m/s: x along the surface, clockwise around the body; y along its outward normal. */
  getSurfaceVelocity(): Vec2;
  getSurfaceVelocity<T extends NumberSink>(dst: T): T;
  getSurfaceVelocity<T extends NumberSink>(dst?: T): T | Vec2 {
    return vec2(this.surfaceX, this.surfaceY, 'RigidBody.getSurfaceVelocity', dst);
  }

  /** Sets the surface velocity, m/s, as of a conveyor belt. Wakes the body, and what rests on it. */
  setSurfaceVelocity(velocity: Vec2Like): void {
    vector('RigidBody.setSurfaceVelocity', 'velocity', velocity, 2);
    this.surfaceX = velocity[0]!;
    this.surfaceY = velocity[1]!;
    this.rouse();
  }

  /** The mass, kg, whatever the type; 0 for a body without shapes and without a given mass. */
  getMass(): number {
    this.refreshMass();
    return this.mass;
  }

  /**
   * Fixes the mass, kg, > 0, `Infinity` allowed. The inertia does not change, see `RigidBodyParams.mass`. Wakes the body if the value
   * changes or was "from shapes".
   */
  setMass(mass: number): void {
    positiveOrInfinite('RigidBody.setMass', 'mass', mass);
    if (mass !== this.fixedMass) {
      this.fixedMass = mass;
      this.massStale = true;
      this.rouse();
    }
  }

  /** Computes the mass from the shapes again, and keeps it in step with them. Wakes the body if it was fixed. */
  setMassFromShapes(): void {
    if (this.fixedMass >= 0) {
      this.fixedMass = -1;
      this.massStale = true;
      this.rouse();
    }
  }

  /** The moment of inertia about the body origin, kg·m², whatever the type. */
  getInertia(): number {
    this.refreshMass();
    return this.inertia;
  }

  /** Fixes the inertia, kg·m², > 0, `Infinity` allowed. Wakes the body if the value changes or was "from shapes". */
  setInertia(inertia: number): void {
    positiveOrInfinite('RigidBody.setInertia', 'inertia', inertia);
    if (inertia !== this.fixedInertia) {
      this.fixedInertia = inertia;
      this.massStale = true;
      this.rouse();
    }
  }

  /** Computes the inertia from the shapes again, and keeps it in step with them. Wakes the body if it was fixed. */
  setInertiaFromShapes(): void {
    if (this.fixedInertia >= 0) {
      this.fixedInertia = -1;
      this.massStale = true;
      this.rouse();
    }
  }

  /**
   * Translates all shapes so that their centre of mass is the body origin. The body's position stays, so the shapes move in the world. No
   * effect without shapes or mass. Ignored as `setPosition` is. Wakes the body.
   *
   * @throws RangeError, before anything changes, if corners of a shape would coincide after the move, as with shapes that are 1e14 m apart.
   */
  alignWithOrigin(): void {
    if (this.isLocked() || !(this.computeMassFromShapes() > 0)) {
      return;
    }
    const [x, y] = this.computeLocalCenterOfMass();
    this.moveShapes('RigidBody.alignWithOrigin', -x, -y);
  }

  /** Attaches a shape. @returns `false`, without effect, if it has a body already, during a step, and for a static body in a world. */
  addShape(shape: Shape): boolean {
    instance('RigidBody.addShape', 'shape', shape, Shape, 'a Shape');
    if (shape.owner !== null || this.isLocked()) {
      return false;
    }
    this.claim(shape);
    this.shapes.push(shape);
    this.owner?.shapeAdded(shape);
    this.rouse();
    return true;
  }

  /**
   * Detaches a shape; its interactions end. @returns `false`, without effect, if it is not this body's, during a step, and for a static
   * body in a world.
   */
  removeShape(shape: Shape): boolean {
    instance('RigidBody.removeShape', 'shape', shape, Shape, 'a Shape');
    if (shape.owner !== this || this.isLocked()) {
      return false;
    }
    this.rouse();
    this.owner?.shapeRemoved(shape);
    takeOut(this.shapes, this.shapes.indexOf(shape));
    shape.detach();
    this.shapesChanged();
    return true;
  }

  /** Converts a point in the world to body coordinates, m. */
  transformWorldPointToLocal(worldPoint: Vec2Like): Vec2;
  transformWorldPointToLocal<T extends NumberSink>(worldPoint: Vec2Like, dst: T): T;
  transformWorldPointToLocal<T extends NumberSink>(worldPoint: Vec2Like, dst?: T): T | Vec2 {
    const where = 'RigidBody.transformWorldPointToLocal';
    vector(where, 'worldPoint', worldPoint, 2);
    return this.toLocal(worldPoint[0]! - this.x, worldPoint[1]! - this.y, where, dst);
  }

  /** Converts a vector in the world to body coordinates: rotates it only. */
  transformWorldVectorToLocal(worldVector: Vec2Like): Vec2;
  transformWorldVectorToLocal<T extends NumberSink>(worldVector: Vec2Like, dst: T): T;
  transformWorldVectorToLocal<T extends NumberSink>(worldVector: Vec2Like, dst?: T): T | Vec2 {
    const where = 'RigidBody.transformWorldVectorToLocal';
    vector(where, 'worldVector', worldVector, 2);
    return this.toLocal(worldVector[0]!, worldVector[1]!, where, dst);
  }

  /** Converts a point in body coordinates to world coordinates, m. */
  transformLocalPointToWorld(localPoint: Vec2Like): Vec2;
  transformLocalPointToWorld<T extends NumberSink>(localPoint: Vec2Like, dst: T): T;
  transformLocalPointToWorld<T extends NumberSink>(localPoint: Vec2Like, dst?: T): T | Vec2 {
    const where = 'RigidBody.transformLocalPointToWorld';
    vector(where, 'localPoint', localPoint, 2);
    return this.toWorld(localPoint, this.x, this.y, where, dst);
  }

  /** Converts a vector in body coordinates to world coordinates: rotates it only. */
  transformLocalVectorToWorld(localVector: Vec2Like): Vec2;
  transformLocalVectorToWorld<T extends NumberSink>(localVector: Vec2Like, dst: T): T;
  transformLocalVectorToWorld<T extends NumberSink>(localVector: Vec2Like, dst?: T): T | Vec2 {
    const where = 'RigidBody.transformLocalVectorToWorld';
    vector(where, 'localVector', localVector, 2);
    return this.toWorld(localVector, 0, 0, where, dst);
  }

  /** Wakes the body, without a `wake` event for itself, and what sleeps with it. Outside a world only clears the flag. */
  wake(): void {
    if (this.owner !== null) {
      this.owner.wakeBody(this, true);
    } else {
      this.asleep = false;
    }
  }

  /** Puts this dynamic body to sleep at once, without an event; it keeps its velocity. Outside a world only sets the flag. */
  sleep(): void {
    if (this.owner !== null) {
      this.owner.sleepBody(this);
    } else {
      this.asleep = true;
      this.applied?.clear();
    }
  }

  /** Adds a handler. @returns `false` for an unknown type or a handler already present. Otherwise wakes the body without an event. */
  addEventListener(eventType: BodyEventType, handler: BodyHandler): boolean {
    callable('RigidBody.addEventListener', 'handler', handler);
    return addListener(this, plainListener(bitOf(eventType, OF_BODIES), handler), this);
  }

  /** Removes a handler. @returns whether it was there. */
  removeEventListener(eventType: BodyEventType, handler: BodyHandler): boolean {
    callable('RigidBody.removeEventListener', 'handler', handler);
    return removeListener(this, plainListener(bitOf(eventType, OF_BODIES), handler), this);
  }

  /** @internal wakes the body after a change, with a `wake` event if it was asleep; if it is in no world, wakes what it is an anchor of */
  override rouse(): void {
    if (this.owner !== null) {
      this.owner.wakeBody(this, false);
      this.rouseTies(this.owner);
      return;
    }
    this.asleep = false;
    for (const constraint of this.constraints) {
      constraint.rouse();
    }
  }

  /** @internal wakes its constraints that are in other worlds than the given one: it is an anchor of those */
  rouseTies(world: World | null): void {
    for (const constraint of this.constraints) {
      if (constraint.owner !== null && constraint.owner !== world) constraint.rouse();
    }
  }

  /** @internal whether the body may not be moved or reshaped now */
  isLocked(): boolean {
    return this.owner !== null && (this.owner.stepping || this.kind === STATIC);
  }

  /** @internal the turned geometry has to be refreshed before its next use */
  override moved(): void {
    if (!this.placeStale) {
      this.placeStale = true;
      this.owner?.stale.add(this);
    }
  }

  /** @internal brings turned geometry and bounds up to date */
  override place(): void {
    if (!this.placeStale) {
      return;
    }
    for (const shape of this.shapes) {
      shape.place(this);
    }
    if (this.owner === null) {
      this.placeStale = false;
    }
  }

  /** @internal */
  override claim(shape: Shape): void {
    shape.owner = this;
    this.shapesChanged();
    this.moved();
  }

  private setKind(kind: number): void {
    if (kind === this.kind || this.owner?.stepping) {
      return;
    }
    if (this.owner !== null) {
      this.owner.changeKind(this, kind);
    } else {
      this.kind = kind;
      this.touchConstraints();
      this.rouseTies(null);
    }
    this.applied?.clear();
    if (kind === STATIC) {
      this.vx = 0;
      this.vy = 0;
      this.w = 0;
    }
  }
}
