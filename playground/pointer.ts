import type { Vec2 } from '../src/index.js';
import type { Simulation } from './simulation.js';
import { addBody, explode, Grip, pick, type Tool } from './tools.js';
import type { View } from './view.js';

/** px of the page: how far from a body one may be and still take hold of it. */
const REACH = { mouse: 8, touch: 26 };

/**
 * Mouse and touch on the canvas. One finger does what the tool says; where there is nothing to take hold of it moves the picture, and two fingers
 * always do. The wheel makes the picture larger and smaller.
 */
export class Pointers {
  tool: Tool = 'grab';
  /** Where each finger is, px of the page. */
  private readonly fingers = new Map<number, Vec2>();
  private readonly grips = new Map<number, Grip>();
  private generation = -1;

  constructor(
    private readonly view: View,
    private readonly simulation: Simulation,
  ) {
    const { canvas } = view;
    canvas.addEventListener('pointerdown', (event) => this.down(event));
    canvas.addEventListener('pointermove', (event) => this.move(event));
    for (const type of ['pointerup', 'pointercancel'] as const) {
      canvas.addEventListener(type, (event) => this.up(event));
    }
    canvas.addEventListener('wheel', (event) => this.wheel(event), { passive: false });
    canvas.addEventListener('contextmenu', (event) => event.preventDefault());
  }

  /** Before each frame: springs follow their fingers also when the picture moves. What was held in a world that is gone is let go. */
  update(): void {
    if (this.generation !== this.simulation.generation) {
      this.generation = this.simulation.generation;
      this.grips.clear();
    }
    for (const [id, grip] of this.grips) {
      const finger = this.fingers.get(id);
      if (grip.body.world !== this.simulation.world) {
        this.grips.delete(id);
      } else if (finger !== undefined) {
        grip.move(this.view.toWorld(...finger));
      }
    }
    const holds = this.grips.size > 0 || (this.fingers.size > 0 && this.tool === 'grab');
    this.view.canvas.dataset.holding = String(holds);
  }

  private down(event: PointerEvent): void {
    const { view, simulation, fingers } = this;
    const at: Vec2 = [event.clientX, event.clientY];
    view.canvas.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, at);
    if (event.button > 0 || fingers.size > 1) {
      return;
    }
    const point = view.toWorld(...at);
    const { world } = simulation;
    const reach = REACH[event.pointerType === 'touch' ? 'touch' : 'mouse'] * view.pixel;
    if (this.tool === 'grab') {
      const body = pick(world, point, reach, true);
      if (body !== null) {
        this.grips.set(event.pointerId, new Grip(world, body, point));
        simulation.touched = true;
      }
      return;
    }
    simulation.touched = true;
    if (this.tool === 'delete') {
      const body = pick(world, point, reach, false);
      if (body !== null) {
        world.removeRigidBody(body);
      }
    } else if (this.tool === 'explode') {
      explode(world, point, view.height);
    } else {
      addBody(world, this.tool, point, view.height);
    }
  }

  private move(event: PointerEvent): void {
    const { fingers, view } = this;
    const last = fingers.get(event.pointerId);
    if (last === undefined) {
      return;
    }
    const at: Vec2 = [event.clientX, event.clientY];
    fingers.set(event.pointerId, at);
    if (this.grips.has(event.pointerId)) {
      return;
    }
    const other = [...fingers].find(([id]) => id !== event.pointerId)?.[1];
    if (other !== undefined) {
      const before = Math.hypot(last[0] - other[0], last[1] - other[1]);
      const after = Math.hypot(at[0] - other[0], at[1] - other[1]);
      view.pan((at[0] - last[0]) / 2, (at[1] - last[1]) / 2);
      if (before > 10) {
        view.zoom(after / before, (at[0] + other[0]) / 2, (at[1] + other[1]) / 2);
      }
    } else if (this.tool === 'grab' || event.buttons > 1) {
      view.pan(at[0] - last[0], at[1] - last[1]);
    }
  }

  private up(event: PointerEvent): void {
    const grip = this.grips.get(event.pointerId);
    if (grip !== undefined && grip.body.world === this.simulation.world) {
      grip.release();
    }
    this.grips.delete(event.pointerId);
    this.fingers.delete(event.pointerId);
  }

  private wheel(event: WheelEvent): void {
    event.preventDefault();
    const delta = event.deltaMode === 1 ? 30 * event.deltaY : event.deltaY;
    this.view.zoom(Math.exp(-0.0015 * Math.max(-300, Math.min(300, delta))), event.clientX, event.clientY);
  }
}
