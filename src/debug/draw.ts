import type { RigidBody } from '../body.js';
import { FAR } from '../config.js';
import type { Constraint } from '../constraint/constraint.js';
import type { RectLike } from '../math/vectors.js';
import { finite, nonNegative, options, rangeError, typeError, vector } from '../validate.js';
import type { World } from '../world.js';
import { addRectangle, addRigidBody } from './bodies.js';
import { addConstraint } from './constraints.js';
import { addContacts } from './contacts.js';
import { addCircle, addCurve, addLinearSpring, addSpiral } from './curves.js';
import type { ColorLike, DebugGraphicsDevice } from './device.js';
import { LineBuffer } from './lines.js';
import { checkedColor, DebugSettings } from './settings.js';

/** Options of `Physics2DDebugDraw.create`. */
export interface DebugDrawParams {
  /** What it draws with. */
  graphicsDevice: DebugGraphicsDevice;
}

type Viewport = [minX: number, minY: number, maxX: number, maxY: number];

/** px per m, without viewports. */
const DEFAULT_SCALE = 60;

/**
 * Draws worlds, bodies and constraints, and lines and curves of your own, as coloured line segments. Coordinates are physics coordinates,
 * m, unless px is said. In each frame call `begin`, then what draws, then `end`; what is drawn last is on top.
 *
 * It only reads: it changes and wakes nothing. It can draw worlds of any of the bundles.
 */
export class Physics2DDebugDraw extends DebugSettings {
  /** Version of the class, as in Turbulenz. */
  static get version(): number {
    return 1;
  }

  /** @internal */
  readonly lines = new LineBuffer();
  private device: DebugGraphicsDevice | null;
  /** [minX, minY, maxX, maxY], in px and in m; `null`: the default. */
  private screenPort: Viewport | null = null;
  private physicsPort: Viewport | null = null;
  private scale = 0;

  /** @internal use `create` */
  constructor(params: DebugDrawParams) {
    super();
    this.device = checkedDevice(options('Physics2DDebugDraw.create', params, true).graphicsDevice);
  }

  /** Makes a debug drawing for a graphics device. */
  static create(params: DebugDrawParams): Physics2DDebugDraw {
    return new Physics2DDebugDraw(params);
  }

  /** px per m, the mean of both axes; 0 before the first `begin`. */
  get physics2DToScreen(): number {
    return this.scale;
  }

  /** m per px; 0 before the first `begin`. */
  get screenToPhysics2D(): number {
    return this.scale === 0 ? 0 : 1 / this.scale;
  }

  /**
   * Sets the part of the physics plane that fills the screen viewport, m: `[minX, minY, maxX, maxY]`, numbers of at most 1e150. Without a
   * rectangle: the default, `[0, 0, width / 60, height / 60]` of the device. Takes effect at the next `begin`.
   */
  setPhysics2DViewport(rectangle: RectLike | null | undefined): void {
    this.physicsPort = viewport('Physics2DDebugDraw.setPhysics2DViewport', rectangle);
  }

  /**
   * Sets the part of the device that is drawn on, px from the upper left: `[minX, minY, maxX, maxY]`, numbers of at most 1e150. Without a
   * rectangle: all of it. Takes effect at the next `begin`.
   */
  setScreenViewport(rectangle: RectLike | null | undefined): void {
    this.screenPort = viewport('Physics2DDebugDraw.setScreenViewport', rectangle);
  }

  /** Begins a frame, with the present size of the device and the viewports. Lines of a frame that was not ended are dropped. */
  begin(): void {
    const where = 'Physics2DDebugDraw.begin';
    const { width, height } = this.living(where);
    // A device without area, such as a canvas that is folded away, counts as one px: nothing is visible in any case.
    const w = Math.max(1, nonNegative(where, 'graphicsDevice.width', width));
    const h = Math.max(1, nonNegative(where, 'graphicsDevice.height', height));
    const [sx, sy, right, bottom] = this.screenPort ?? [0, 0, w, h];
    const [px, py, maxX, maxY] = this.physicsPort ?? [0, 0, w / DEFAULT_SCALE, h / DEFAULT_SCALE];
    const perX = (right - sx) / (maxX - px);
    const perY = (bottom - sy) / (maxY - py);
    const { mapping, clip } = this.lines;
    mapping[0] = (2 * perX) / w;
    mapping[1] = (-2 * perY) / h;
    mapping[2] = (-2 * px * perX) / w + (2 * sx) / w - 1;
    mapping[3] = (2 * py * perY) / h - (2 * sy) / h + 1;
    clip[0] = sx;
    clip[1] = sy;
    clip[2] = right - sx;
    clip[3] = bottom - sy;
    this.scale = (perX + perY) / 2;
    this.lines.segmentCount = 0;
  }

  /** Ends a frame: hands everything to the device. If nothing was drawn, it is not called. */
  end(): void {
    const device = this.living('Physics2DDebugDraw.end');
    if (this.lines.segmentCount > 0) {
      try {
        device.drawLines(this.lines);
      } finally {
        this.lines.segmentCount = 0;
      }
    }
  }

  /** Destroys the device. Afterwards nothing can be drawn with this object. */
  destroy(): void {
    const { device } = this;
    this.device = null;
    device?.destroy?.();
  }

  /** Draws the bodies, then the contacts, then the constraints that are enabled, as the settings say. */
  drawWorld(world: World): void {
    const where = this.drawing('Physics2DDebugDraw.drawWorld');
    if (!(Array.isArray(world?.rigidBodies) && Array.isArray(world.constraints))) {
      throw typeError(where, 'world', 'a World', world);
    }
    if (this.showRigidBodies) {
      for (const body of world.rigidBodies) {
        addRigidBody(this, body);
      }
    }
    if (this.showContacts) {
      addContacts(this, world.dynamicArbiters, this.dynamicContactColor);
      addContacts(this, world.staticArbiters, this.staticContactColor);
    }
    if (this.showConstraints) {
      for (const constraint of world.constraints) {
        if (constraint.isEnabled()) {
          addConstraint(this, constraint);
        }
      }
    }
  }

  /** Draws the outlines of the shapes of a body, in a world or not. */
  drawRigidBody(rigidBody: RigidBody): void {
    const where = this.drawing('Physics2DDebugDraw.drawRigidBody');
    if (!(Array.isArray(rigidBody?.shapes) && typeof rigidBody.getPosition === 'function')) {
      throw typeError(where, 'rigidBody', 'a RigidBody', rigidBody);
    }
    addRigidBody(this, rigidBody);
  }

  /** Draws a constraint, in a world or not, enabled or not. */
  drawConstraint(constraint: Constraint): void {
    const where = this.drawing('Physics2DDebugDraw.drawConstraint');
    if (!(typeof constraint?.type === 'string' && typeof constraint.getImpulseForBody === 'function')) {
      throw typeError(where, 'constraint', 'a Constraint', constraint);
    }
    addConstraint(this, constraint);
  }

  /** Draws a line between two points of the world, m. */
  drawLine(x1: number, y1: number, x2: number, y2: number, color: ColorLike): void {
    const where = this.drawing('Physics2DDebugDraw.drawLine');
    checkEnds(where, x1, y1, x2, y2);
    this.lines.setColor(checkedColor(where, 'color', color));
    this.lines.add(x1, y1, x2, y2);
  }

  /** Draws the outline of the rectangle between two opposite corners. */
  drawRectangle(x1: number, y1: number, x2: number, y2: number, color: ColorLike): void {
    const where = this.drawing('Physics2DDebugDraw.drawRectangle');
    checkEnds(where, x1, y1, x2, y2);
    this.lines.setColor(checkedColor(where, 'color', color));
    addRectangle(this, x1, y1, x2, y2);
  }

  /** Draws a circle around (x, y); `radius` >= 0. As many segments as `circleMaxError` asks for. */
  drawCircle(x: number, y: number, radius: number, color: ColorLike): void {
    const where = this.drawing('Physics2DDebugDraw.drawCircle');
    finite(where, 'x', x);
    finite(where, 'y', y);
    nonNegative(where, 'radius', radius);
    this.lines.setColor(checkedColor(where, 'color', color));
    addCircle(this, x, y, radius);
  }

  /** Draws the quadratic Bézier curve from (x1, y1) to (x2, y2) with the control point (cx, cy); as fine as `curveMaxError` asks for. */
  drawCurve(x1: number, y1: number, cx: number, cy: number, x2: number, y2: number, color: ColorLike): void {
    const where = this.drawing('Physics2DDebugDraw.drawCurve');
    checkEnds(where, x1, y1, x2, y2);
    finite(where, 'cx', cx);
    finite(where, 'cy', cy);
    this.lines.setColor(checkedColor(where, 'color', color));
    addCurve(this, x1, y1, cx, cy, x2, y2);
  }

  /**
   * Draws a spiral around (x, y): the radius goes from `radius1` at `angle1` to `radius2` at `angle2`, in proportion to the angle. Nothing
   * if the angles are equal.
   */
  drawSpiral(
    x: number,
    y: number,
    angle1: number,
    angle2: number,
    radius1: number,
    radius2: number,
    color: ColorLike,
  ): void {
    const where = this.drawing('Physics2DDebugDraw.drawSpiral');
    checkSpiral(where, x, y, angle1, angle2, radius1, radius2);
    this.lines.setColor(checkedColor(where, 'color', color));
    addSpiral(this, x, y, angle1, angle2, radius1, radius2);
  }

  /**
   * Draws a spring from (x1, y1) to (x2, y2): `numCoils` sine waves of the amplitude `radius`; a line if `numCoils` <= 0, or if it is
   * shorter than `minSpringLength`.
   */
  drawLinearSpring(
    x1: number,
    y1: number,
    x2: number,
    y2: number,
    numCoils: number,
    radius: number,
    color: ColorLike,
  ): void {
    const where = this.drawing('Physics2DDebugDraw.drawLinearSpring');
    checkEnds(where, x1, y1, x2, y2);
    finite(where, 'numCoils', numCoils);
    finite(where, 'radius', radius);
    this.lines.setColor(checkedColor(where, 'color', color));
    addLinearSpring(this, x1, y1, x2, y2, numCoils, radius);
  }

  /**
   * Draws a spiral as `drawSpiral` does, with `numCoils` sine waves on its radius, the amplitude of which is set by `spiralSpringSize`.
   * Without coils, a plain spiral.
   */
  drawSpiralSpring(
    x: number,
    y: number,
    angle1: number,
    angle2: number,
    radius1: number,
    radius2: number,
    numCoils: number,
    color: ColorLike,
  ): void {
    const where = this.drawing('Physics2DDebugDraw.drawSpiralSpring');
    checkSpiral(where, x, y, angle1, angle2, radius1, radius2);
    finite(where, 'numCoils', numCoils);
    this.lines.setColor(checkedColor(where, 'color', color));
    addSpiral(this, x, y, angle1, angle2, radius1, radius2, numCoils);
  }

  /** The device. @throws after `destroy`. */
  private living(where: string): DebugGraphicsDevice {
    if (this.device === null) {
      throw new Error(`${where}: must not be called after destroy`);
    }
    return this.device;
  }

  /** Checks that something may be drawn now. @returns `where`. */
  private drawing(where: string): string {
    this.living(where);
    if (this.scale === 0) {
      throw new Error(`${where}: must not be called before begin`);
    }
    return where;
  }
}

function checkEnds(where: string, x1: number, y1: number, x2: number, y2: number): void {
  finite(where, 'x1', x1);
  finite(where, 'y1', y1);
  finite(where, 'x2', x2);
  finite(where, 'y2', y2);
}

function checkSpiral(
  where: string,
  x: number,
  y: number,
  angle1: number,
  angle2: number,
  radius1: number,
  radius2: number,
): void {
  finite(where, 'x', x);
  finite(where, 'y', y);
  finite(where, 'angle1', angle1);
  finite(where, 'angle2', angle2);
  finite(where, 'radius1', radius1);
  finite(where, 'radius2', radius2);
}

function checkedDevice(value: DebugGraphicsDevice | undefined): DebugGraphicsDevice {
  const where = 'Physics2DDebugDraw.create';
  if (typeof value !== 'object' || value === null || typeof value.drawLines !== 'function') {
    throw typeError(where, 'graphicsDevice', 'a device with the method drawLines', value);
  }
  nonNegative(where, 'graphicsDevice.width', value.width);
  nonNegative(where, 'graphicsDevice.height', value.height);
  return value;
}

/** A copy of a rectangle, which must have an area; `null` without one. */
function viewport(where: string, rectangle: RectLike | null | undefined): Viewport | null {
  if (rectangle === null || rectangle === undefined) {
    return null;
  }
  const [minX, minY, maxX, maxY] = vector(where, 'rectangle', rectangle, 4, FAR) as unknown as Viewport;
  if (!(maxX > minX)) {
    throw rangeError(where, 'rectangle[2]', `more than rectangle[0] (${minX})`, maxX);
  }
  if (!(maxY > minY)) {
    throw rangeError(where, 'rectangle[3]', `more than rectangle[1] (${minY})`, maxY);
  }
  return [minX, minY, maxX, maxY];
}
