import type { BodyHandler } from './body.js';
import type { Applied } from './body-applied.js';
import { DYNAMIC, STATIC } from './body-kind.js';
import { BodyNumbers } from './body-numbers.js';
import { checkedParams, type RigidBodyParams } from './body-params.js';
import type { Constraint } from './constraint/constraint.js';
import { type Listeners, NO_LISTENERS } from './listeners.js';
import { cosSin } from './math/trig.js';
import { type NumberSink, type Rect, type Vec2, type Vec2Like, vec2 } from './math/vectors.js';
import { presentBounds } from './shape/presently.js';
import type { Shape } from './shape/shape.js';
import type { Island } from './solver/sleep.js';
import type { UserDataOf } from './user-data.js';
import { boolean, rangeError, sink } from './validate.js';
import type { World } from './world.js';

/** Angle, cosine, sine: scratch of `refreshTurn`. */
const turn = /* @__PURE__ */ new Float64Array(3);

/** 2^-800, a factor for masses where their sum could overflow: it changes no bit of the quotient of two. */
const SMALL = 1.499696813895631e-241;

/** The state of a body, and how all that is derived from it is kept up to date. {@link RigidBody} is its public face. */
export abstract class BodyState extends BodyNumbers {
  // What steps read of thousands of bodies comes first, as in shapes.

  /** @internal DYNAMIC, KINEMATIC or STATIC */
  kind = DYNAMIC;
  /** @internal */
  asleep = false;
  /** @internal slot in the solver's arrays during a step; 0 for all that cannot move */
  slot = 0;
  /** @internal the value of `bullet` */
  isBullet = false;
  /** @internal the forces for one step, once there were any */
  applied: Applied | null = null;
  /**
   * @internal the bodies that enabled constraints of a world keep it from interacting with, itself included, once for each constraint;
   * `null` before the first
   */
  ignoring: BodyState[] | null = null;
  /** @internal mass, inertia and radius have to be computed anew before their next use */
  massStale = true;
  /** @internal turned geometry, bounds and broadphase do not match the placement */
  placeStale = true;
  /** @internal the last step in which the body was not at rest, or was woken */
  wakeTime = 0;
  /** @internal the step after something that touched it was removed */
  unloaded = -1;
  /** @internal index among the movers of a step, −1 if it is not one */
  mover = -1;
  /** @internal index in the live list of its type, −1 while in none */
  liveIndex = -1;
  /** @internal what `allowSleeping` is */
  mayRest = true;
  /** Attached shapes. Do not modify. */
  readonly shapes: Shape[];
  /** The constraints in a world, enabled or not, that use this body. Do not modify. */
  readonly constraints: Constraint[] = [];
  /** @internal its `wake` event waits for the next step */
  woken = false;
  /** @internal */
  owner: World | null = null;
  /** @internal rank in the order in which bodies, shapes and constraints came into their worlds. Keeps its name */
  order = 0;
  /** @internal index in the world's list of bodies */
  index = -1;
  /** @internal the island it fell asleep with */
  island: Island | null = null;
  /** @internal */
  listeners: Listeners<BodyHandler> = NO_LISTENERS;
  /** Anything of yours. */
  userData: UserDataOf<'body'>;

  /** @internal */
  constructor(params: RigidBodyParams | undefined) {
    super();
    const given = checkedParams(params);
    const moves = given.kind !== STATIC;
    this.kind = given.kind;
    this.x = given.position[0]!;
    this.y = given.position[1]!;
    this.angle = given.rotation;
    this.refreshTurn();
    this.vx = moves ? given.velocity[0]! : 0;
    this.vy = moves ? given.velocity[1]! : 0;
    this.w = moves ? given.angularVelocity : 0;
    this.fx = given.force[0]!;
    this.fy = given.force[1]!;
    this.appliedTorque = given.torque;
    this.linearDrag = given.linearDrag;
    this.angularDrag = given.angularDrag;
    this.gravityScale = given.gravityScale;
    this.surfaceX = given.surfaceVelocity[0]!;
    this.surfaceY = given.surfaceVelocity[1]!;
    this.fixedMass = given.mass;
    this.fixedInertia = given.inertia;
    this.asleep = given.sleeping;
    this.mayRest = given.allowSleeping;
    this.isBullet = given.bullet;
    this.userData = given.userData;
    this.shapes = this.own(given.shapes);
  }

  /**
   * Claims the shapes that are free, and drops the others from the list. The list itself becomes `shapes`, as it is no longer than it must
   * be: one that grows has room for many.
   */
  private own(shapes: Shape[]): Shape[] {
    let count = 0;
    for (const shape of shapes) {
      if (shape.owner === null) {
        this.claim(shape);
        shapes[count] = shape;
        count += 1;
      }
    }
    shapes.length = count;
    return shapes;
  }

  /** Whether it falls asleep by itself once it rests, as `World.allowSleeping` for all. While it does not, what it touches or is tied to stays awake, too. A change wakes it. */
  get allowSleeping(): boolean {
    return this.mayRest;
  }

  set allowSleeping(value: boolean) {
    if (boolean('RigidBody', 'allowSleeping', value) !== this.mayRest) {
      this.mayRest = value;
      this.rouse();
    }
  }

  /**
   * Continuous collision with other dynamic bodies: it does not pass through them when it is fast. A change wakes nothing; within a step it
   * may take effect in that one.
   */
  get bullet(): boolean {
    return this.isBullet;
  }

  set bullet(value: boolean) {
    this.isBullet = boolean('RigidBody', 'bullet', value);
  }

  /** The mass of the shapes: Σ density · area, kg. Overlaps count twice, sensors count. */
  computeMassFromShapes(): number {
    let mass = 0;
    for (const shape of this.shapes) {
      mass += shape.material.density * shape.computeArea();
    }
    return mass;
  }

  /** The inertia of the shapes: Σ density · area · massless inertia, kg·m² about the body origin. */
  computeInertiaFromShapes(): number {
    let inertia = 0;
    for (const shape of this.shapes) {
      inertia += shape.material.density * shape.computeArea() * shape.computeMasslessInertia();
    }
    return inertia;
  }

  /** The centre of mass of the shapes in body coordinates, m; `[0, 0]` without shapes or mass. */
  computeLocalCenterOfMass(): Vec2;
  computeLocalCenterOfMass<T extends NumberSink>(dst: T): T;
  computeLocalCenterOfMass<T extends NumberSink>(dst?: T): T | Vec2 {
    let x = 0;
    let y = 0;
    let total = 0;
    const centre: Vec2 = [0, 0];
    const unit = this.computeMassFromShapes() < 1 ? 1 : SMALL;
    for (const shape of this.shapes) {
      const mass = unit * shape.computeArea() * shape.material.density;
      shape.computeCenterOfMass(centre);
      x += mass * centre[0];
      y += mass * centre[1];
      total += mass;
    }
    const hasMass = total > 0;
    return vec2(hasMass ? x / total : 0, hasMass ? y / total : 0, 'RigidBody.computeLocalCenterOfMass', dst);
  }

  /** The smallest rectangle `[minX, minY, maxX, maxY]` around all shapes, in world coordinates, m; `[∞, ∞, −∞, −∞]` without shapes. */
  computeWorldBounds(): Rect;
  computeWorldBounds<T extends NumberSink>(dst: T): T;
  computeWorldBounds<T extends NumberSink>(dst?: T): T | Rect {
    if (dst !== undefined) sink('RigidBody.computeWorldBounds', 'dst', dst, 4);
    const result = dst === undefined ? ([0, 0, 0, 0] as Rect) : dst;
    for (let k = 0; k < 4; k += 1) {
      result[k] = k < 2 ? Infinity : -Infinity;
    }
    for (const shape of this.shapes) {
      const bounds = presentBounds(shape);
      for (let k = 0; k < 4; k += 1) {
        result[k] = (k < 2 ? Math.min : Math.max)(result[k]!, bounds[k]!);
      }
    }
    return result;
  }

  /** @internal */
  shapesChanged(): void {
    this.massStale = true;
  }

  /** @internal 0 for everything that cannot be pushed */
  inverseMass(): number {
    this.refreshMass();
    return this.kind === DYNAMIC && this.mass > 0 ? 1 / this.mass : 0;
  }

  /** @internal 0 for everything that cannot be turned */
  inverseInertia(): number {
    this.refreshMass();
    return this.kind === DYNAMIC && this.inertia > 0 ? 1 / this.inertia : 0;
  }

  /** @internal whether an impulse has an effect on it */
  canBePushed(): boolean {
    this.refreshMass();
    return (
      this.kind === DYNAMIC &&
      ((this.mass > 0 && this.mass < Infinity) || (this.inertia > 0 && this.inertia < Infinity))
    );
  }

  /** @internal whether it moves or turns */
  isGoing(): boolean {
    return this.vx !== 0 || this.vy !== 0 || this.w !== 0;
  }

  /** @internal whether it moves or turns, or has a surface velocity */
  drives(): boolean {
    return this.isGoing() || this.surfaceX !== 0 || this.surfaceY !== 0;
  }

  /** @internal after a teleport or a change of type: has constraints take its placement anew */
  touchConstraints(): void {
    for (const constraint of this.constraints) {
      constraint.touch();
    }
  }

  /** @internal */
  putAt(x: number, y: number, angle: number): void {
    this.owner?.holdContacts(this);
    if (angle !== this.angle) {
      this.angle = angle;
      this.refreshTurn();
    }
    this.x = x;
    this.y = y;
    this.touchConstraints();
    this.moved();
  }

  /** @internal resets all that belongs to the world the body was in, and step numbers that may come again after a `restore` */
  leave(): void {
    this.owner!.pushed.delete(this);
    this.owner!.someLeft = true;
    this.owner = null;
    this.asleep = false;
    this.woken = false;
    this.index = -1;
    this.liveIndex = -1;
    this.slot = 0;
    this.unloaded = -1;
    this.applied?.clear();
    this.island = null;
    this.placeStale = true;
    for (const shape of this.shapes) {
      shape.leave();
    }
  }

  /** @internal translates all shapes within the body, or none */
  protected moveShapes(where: string, x: number, y: number): void {
    if (!this.shapes.every((shape) => shape.staysWhole(x, y))) {
      throw rangeError(where, 'shapes', 'ones that stay whole where they come to be', this.shapes);
    }
    for (const shape of this.shapes) {
      shape.translate([x, y]);
    }
  }

  /** @internal computes `cos` and `sin` after a change of `angle` */
  refreshTurn(): void {
    turn[0] = this.angle;
    cosSin(turn);
    this.cos = turn[1]!;
    this.sin = turn[2]!;
  }

  /** @internal */
  refreshMass(): void {
    if (this.massStale) {
      this.renewMass();
    }
  }

  private renewMass(): void {
    this.massStale = false;
    this.mass = this.fixedMass >= 0 ? this.fixedMass : this.computeMassFromShapes();
    this.inertia = this.fixedInertia >= 0 ? this.fixedInertia : this.computeInertiaFromShapes();
    this.radius = 0;
    for (const shape of this.shapes) {
      this.radius = Math.max(this.radius, shape.reach());
    }
  }

  /** @internal */
  protected toLocal<T extends NumberSink>(x: number, y: number, where: string, dst: T | undefined): T | Vec2 {
    return vec2(this.cos * x + this.sin * y, this.cos * y - this.sin * x, where, dst);
  }

  /** @internal */
  protected toWorld<T extends NumberSink>(
    local: Vec2Like,
    x: number,
    y: number,
    where: string,
    dst: T | undefined,
  ): T | Vec2 {
    const lx = local[0]!;
    const ly = local[1]!;
    return vec2(x + this.cos * lx - this.sin * ly, y + this.sin * lx + this.cos * ly, where, dst);
  }

  /** @internal becomes the body of a shape that is not in its list yet */
  abstract claim(shape: Shape): void;

  /** @internal the automatic wake: with a `wake` event if the body was asleep */
  abstract rouse(): void;

  /** @internal */
  abstract moved(): void;

  /** @internal */
  abstract place(): void;
}
