import type { Physics2DDevice, RigidBody, World } from '../../src/index.js';
import { generator } from '../scenes/mixed.js';

// A closed ring of boxes as one kinematic body, turning at 2 rad/s, and boxes that tumble in it. The test steps it some seconds long;
// drum-long.mjs, run by hand, as long as wanted.

const RADIUS = 5;
const THICKNESS = 0.2;
const SIDES = 48;
/** m. Boxes start in a grid, one in each cell. */
const CELL = 0.25;

export class DrumRun {
  readonly world: World;
  readonly boxes: RigidBody[] = [];
  private readonly gone = new Set<RigidBody>();

  constructor(phys2D: Physics2DDevice, count: number) {
    this.world = phys2D.createWorld({ gravity: [0, 30] });
    const side = 2 * (RADIUS + THICKNESS) * Math.tan(Math.PI / SIDES);
    const ring = Array.from({ length: SIDES }, (_, i) => {
      const shape = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(THICKNESS, side) });
      shape.translate([RADIUS + THICKNESS / 2, 0]);
      shape.rotate((2 * Math.PI * i) / SIDES);
      return shape;
    });
    this.world.addRigidBody(phys2D.createRigidBody({ type: 'kinematic', angularVelocity: 2, shapes: ring }));
    const random = generator(2);
    const half = Math.floor((RADIUS - 0.4) / CELL);
    for (let i = -half; i <= half; i += 1) {
      for (let k = -half; k <= half && this.boxes.length < count; k += 1) {
        if ((i * i + k * k) * CELL * CELL < (RADIUS - 0.4) ** 2) {
          const [width, height] = [0.1 + 0.14 * random(), 0.1 + 0.14 * random()];
          const shapes = [phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, height) })];
          const body = phys2D.createRigidBody({ shapes, position: [CELL * i, CELL * k] });
          this.world.addRigidBody(body);
          this.boxes.push(body);
        }
      }
    }
  }

  /** Steps; what has been outside once counts as escaped. */
  step(count: number): void {
    const limit = (RADIUS + THICKNESS / 2) / Math.cos(Math.PI / SIDES);
    for (let i = 0; i < count; i += 1) {
      this.world.step(1 / 60);
      for (const body of this.boxes) {
        const [x, y] = body.getPosition();
        if (!(x * x + y * y < limit * limit)) {
          this.gone.add(body);
        }
      }
    }
  }

  escaped(): number {
    return this.gone.size;
  }
}
