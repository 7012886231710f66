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

/** 2^-800, by which masses are multiplied where they could sum up to more than there are numbers: it changes no bit of a quotient of two. */
const SMALL = 1.499696813895631e-241;

/** What a body is made of, and how what is derived of it is kept right. {@link RigidBody} is its public face. */
export abstract class BodyState extends BodyNumbers {
  // What steps ask of thousands comes first, as in shapes.

  /** @internal DYNAMIC, KINEMATIC or STATIC */
  kind = DYNAMIC;
  /** @internal */
  asleep = false;
  /** @internal slot in the solver's arrays during a step; 0 is everything that cannot move */
  slot = 0;
  /** @internal what `bullet` is */
  isBullet = false;
  /** @internal what pushes it for one step, once anything has */
  applied: Applied | null = null;
  /** @internal how many enabled constraints in a world keep it from interacting with other bodies */
  ignoring = 0;
  /** @internal shapes, mass or radius differ from what is cached */
  massStale = true;
  /** @internal turned geometry, bounds and broadphase are behind the placement */
  placeStale = true;
  /** @internal the last step in which the body was not at rest or was woken */
  wakeTime = 0;
  /** @internal the step that comes after something that touched it was taken away */
  unloaded = -1;
  /** @internal index among the movers of a step, −1 if it is none */
  mover = -1;
  /** @internal index in the live list of its type, −1 while in none */
  liveIndex = -1;
  /** Attached shapes. Do not modify. */
  readonly shapes: Shape[];
  /** Constraints in a world, enabled or not, that use this body. Do not modify. */
  readonly constraints: Constraint[] = [];
  /** @internal its `wake` event waits for the next step */
  woken = false;
  /** @internal */
  owner: World | null = null;
  /** @internal when it was added to its world; grows with each body, shape and constraint. Keeps its name */
  order = 0;
  /** @internal index in the world's list of bodies */
  index = -1;
  /** @internal those it fell asleep with */
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
    this.isBullet = given.bullet;
    this.userData = given.userData;
    this.shapes = this.own(given.shapes);
  }

  /** Takes those that are free, into the list itself, which is no longer than it must be: one that grows has room for many. */
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

  /** Does not pass through other dynamic bodies when it is fast. A change wakes nothing; within a step it may take effect in that one. */
  get bullet(): boolean {
    return this.isBullet;
  }

  set bullet(value: boolean) {
    this.isBullet = boolean('RigidBody', 'bullet', value);
  }

  /** Σ density · area, kg. Overlaps count twice, sensors count. */
  computeMassFromShapes(): number {
    let mass = 0;
    for (const shape of this.shapes) {
      mass += shape.material.density * shape.computeArea();
    }
    return mass;
  }

  /** Σ density · area · massless inertia, kg·m² about the body origin. */
  computeInertiaFromShapes(): number {
    let inertia = 0;
    for (const shape of this.shapes) {
      inertia += shape.material.density * shape.computeArea() * shape.computeMasslessInertia();
    }
    return inertia;
  }

  /** Centre of mass of the shapes in body coordinates, m; `[0, 0]` without shapes or mass. */
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

  /** Smallest `[minX, minY, maxX, maxY]` around all shapes; `[∞, ∞, −∞, −∞]` without shapes. m. */
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

  /** @internal an impulse has an effect on it */
  canBePushed(): boolean {
    this.refreshMass();
    return (
      this.kind === DYNAMIC &&
      ((this.mass > 0 && this.mass < Infinity) || (this.inertia > 0 && this.inertia < Infinity))
    );
  }

  /** @internal it has a velocity */
  isGoing(): boolean {
    return this.vx !== 0 || this.vy !== 0 || this.w !== 0;
  }

  /** @internal it is going, or its surface is */
  drives(): boolean {
    return this.isGoing() || this.surfaceX !== 0 || this.surfaceY !== 0;
  }

  /** @internal after a teleport or a change of type: constraints look at the body anew */
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

  /** @internal resets what the body had from its world, and what it remembers of times that may come again after a `restore` */
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

  /** @internal within the body: all of them, or none */
  protected moveShapes(where: string, x: number, y: number): void {
    if (!this.shapes.every((shape) => shape.staysWhole(x, y))) {
      throw rangeError(where, 'shapes', 'ones that stay whole where they come to be', this.shapes);
    }
    for (const shape of this.shapes) {
      shape.translate([x, y]);
    }
  }

  /** @internal after a change of `angle` */
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

  /** @internal becomes the body of a shape, which is not in the list yet */
  abstract claim(shape: Shape): void;

  /** @internal the automatic wake: with a `wake` event if the body was asleep */
  abstract rouse(): void;

  /** @internal */
  abstract moved(): void;

  /** @internal */
  abstract place(): void;
}
