import { Physics2DDebugDraw } from '../src/debug/index.js';
import type { Vec2 } from '../src/index.js';
import { CanvasSurface } from './canvas.js';
import { pixelRatio } from './elements.js';
import type { DrawOption } from './settings.js';
import type { Simulation } from './simulation.js';
import type { Surface } from './surface.js';
import { DARK, LIGHT } from './theme.js';
import { WebGLSurface } from './webgl.js';

/** The canvas: which part of the plane it shows, and what. */
export class View {
  /** Middle of the picture, m; px of the page per m. */
  private x = 0;
  private y = 0;
  private scale = 1;
  private following = true;
  /** The seam of the picture and the window, px of the device for each of the page. */
  private ratio = 1;
  private readonly gl: WebGL2RenderingContext | null;
  private debug!: Physics2DDebugDraw;
  private surface!: Surface;
  private isDark = false;

  /** `margins`: px of the page above and below that are covered. */
  constructor(
    readonly canvas: HTMLCanvasElement,
    private readonly margins: () => readonly [number, number],
  ) {
    this.gl = canvas.getContext('webgl2', { alpha: false, antialias: true, powerPreference: 'high-performance' });
    this.prepare();
    canvas.addEventListener('webglcontextlost', (event) => event.preventDefault());
    canvas.addEventListener('webglcontextrestored', () => this.prepare());
  }

  /** m. Height of what is shown. */
  get height(): number {
    return this.canvas.clientHeight / this.scale;
  }

  /** m for each px of the page. */
  get pixel(): number {
    return 1 / this.scale;
  }

  private prepare(): void {
    const { gl, canvas } = this;
    this.ratio = pixelRatio();
    const lineWidth = Math.max(1, 1.25 * this.ratio);
    this.surface =
      gl === null ? new CanvasSurface(canvas.getContext('2d')!, lineWidth) : new WebGLSurface(gl, lineWidth);
    this.debug = Physics2DDebugDraw.create({ graphicsDevice: this.surface.device });
    this.setTheme(this.isDark);
  }

  setTheme(isDark: boolean): void {
    this.isDark = isDark;
    const { debug, ratio } = this;
    const { joint, other, error, contact, detail } = isDark ? DARK : LIGHT;
    debug.constraintAnchorRadius = 1.75 * ratio;
    debug.constraintSpringRadius = 2.5 * ratio;
    debug.constraintSpiralMinRadius = 6 * ratio;
    debug.contactRadius = 2 * ratio;
    for (const letter of ['A', 'B', 'C', 'D'] as const) {
      const color = [...Array.from(letter === 'A' ? joint : other)] as [number, number, number, number];
      const off = [...Array.from(error)] as [number, number, number, number];
      debug[`constraintColor${letter}`] = color;
      debug[`constraintSleepingColor${letter}`] = [color[0], color[1], color[2], 0.5];
      debug[`constraintErrorColor${letter}`] = off;
      debug[`constraintErrorSleepingColor${letter}`] = [off[0], off[1], off[2], 0.5];
    }
    const copy = (color: ArrayLike<number>): [number, number, number, number] => [color[0]!, color[1]!, color[2]!, 0.9];
    debug.dynamicContactColor = copy(contact);
    debug.staticContactColor = copy(contact);
    debug.normalImpulseColor = copy(contact);
    debug.frictionImpulseColor = copy(other);
    debug.bodyDetailColor = copy(detail);
    debug.shapeDetailColor = copy(detail);
  }

  /** Shows all of a scene. */
  fit({ scene, play }: Simulation): void {
    const [minX, minY, maxX, maxY] = scene.view;
    const { clientWidth, clientHeight } = this.canvas;
    const [above, below] = this.margins();
    const height = Math.max(50, clientHeight - above - below);
    // What is followed need not be seen as a whole.
    const wide = play.follow === undefined ? 0.97 : 1.7;
    this.scale = Math.min((wide * clientWidth) / (maxX - minX), (0.97 * height) / (maxY - minY));
    this.x = (minX + maxX) / 2;
    this.y = (minY + maxY) / 2 + (below - above) / 2 / this.scale;
    this.following = true;
  }

  /** The point of the plane at a point of the page. */
  toWorld(clientX: number, clientY: number): Vec2 {
    const box = this.canvas.getBoundingClientRect();
    return [
      this.x + (clientX - box.left - box.width / 2) / this.scale,
      this.y + (clientY - box.top - box.height / 2) / this.scale,
    ];
  }

  /** The point of the page at a point of the plane. */
  toPage([x, y]: Vec2): Vec2 {
    const box = this.canvas.getBoundingClientRect();
    return [box.left + box.width / 2 + (x - this.x) * this.scale, box.top + box.height / 2 + (y - this.y) * this.scale];
  }

  /** Moves the picture by px of the page. */
  pan(dx: number, dy: number): void {
    this.x -= dx / this.scale;
    this.y -= dy / this.scale;
    this.following = false;
  }

  /** Larger by a factor, around a point of the page. */
  zoom(factor: number, clientX: number, clientY: number): void {
    const [x, y] = this.toWorld(clientX, clientY);
    const scale = Math.min(2000, Math.max(1, this.scale * factor));
    const change = this.scale / scale;
    this.x = x + (this.x - x) * change;
    this.y = y + (this.y - y) * change;
    this.scale = scale;
  }

  /** Takes the size of the element. @returns whether that has changed. */
  resize(): boolean {
    const { canvas } = this;
    if (this.ratio !== pixelRatio()) {
      // Zoomed, or on another screen: lines are as wide as before to the eye.
      this.prepare();
    }
    const [width, height] = [canvas.clientWidth, canvas.clientHeight].map((size) =>
      Math.max(1, Math.round(size * this.ratio)),
    );
    const changed = canvas.width !== width || canvas.height !== height;
    if (changed) {
      canvas.width = width!;
      canvas.height = height!;
    }
    return changed;
  }

  draw(simulation: Simulation, draw: ReadonlySet<DrawOption>): void {
    const { surface, debug, canvas } = this;
    if (surface.isLost()) {
      return;
    }
    const { world, runner, play } = simulation;
    const smooth = simulation.playing && draw.has('smooth');
    if (play.follow !== undefined && this.following) {
      [this.x, this.y] = smooth ? runner.getPosition(play.follow) : play.follow.getPosition();
      this.y -= this.height / 12;
    }
    const palette = this.isDark ? DARK : LIGHT;
    surface.clear(palette.paper);
    const scale = this.scale * this.ratio;
    const [perX, perY] = [(2 * scale) / canvas.width, (2 * scale) / canvas.height];
    const [halfWidth, halfHeight] = [1 / perX, 1 / perY];
    if (!draw.has('debug')) {
      const mapping = [perX, -perY, -this.x * perX, this.y * perY] as const;
      const inks = draw.has('fill') ? palette.inks : hollow(palette.inks);
      surface.drawBodies({ world, runner, mapping, scale, rim: 1.25 * this.ratio, inks, smooth });
    }
    debug.showRigidBodies = draw.has('debug') || draw.has('boxes') || draw.has('bodies');
    debug.showColliderShapes = draw.has('debug') || draw.has('boxes');
    debug.showSensorShapes = debug.showColliderShapes;
    debug.showConstraints = draw.has('constraints');
    debug.showContacts = draw.has('contacts') || draw.has('impulses');
    debug.showContactImpulses = draw.has('impulses');
    debug.showShapeDetail = draw.has('boxes');
    debug.showBodyDetail = draw.has('bodies');
    debug.interpolation = smooth ? runner.interpolation : 1;
    debug.setPhysics2DViewport([this.x - halfWidth, this.y - halfHeight, this.x + halfWidth, this.y + halfHeight]);
    debug.begin();
    debug.drawWorld(world);
    debug.end();
  }
}

/** Inks that do not fill. */
function hollow(inks: Uint8Array): Uint8Array {
  return inks.map((value, i) => (i % 4 === 3 ? 0 : value));
}
