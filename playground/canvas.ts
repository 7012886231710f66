import { CanvasDebugDevice, type DebugGraphicsDevice } from '../src/debug/index.js';
import type { Shape, Vec2 } from '../src/index.js';
import { type Frame, inkOf, poseOf, type Surface, strengthOf } from './surface.js';
import type { Rgb } from './theme.js';

/** A 2D canvas, where there is no WebGL 2. The same picture, and slower. */
export class CanvasSurface implements Surface {
  readonly device: DebugGraphicsDevice;

  constructor(
    private readonly context: CanvasRenderingContext2D,
    lineWidth: number,
  ) {
    this.device = CanvasDebugDevice.create({ context, lineWidth });
  }

  isLost(): boolean {
    return false;
  }

  clear([r, g, b]: Rgb): void {
    const { context } = this;
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.fillStyle = `rgb(${r} ${g} ${b})`;
    context.fillRect(0, 0, context.canvas.width, context.canvas.height);
  }

  drawBodies(frame: Frame): void {
    const { context } = this;
    const { width, height } = context.canvas;
    const { mapping, scale, inks } = frame;
    const position: Vec2 = [0, 0];
    frame.world.rigidBodies.forEach((body, i) => {
      const angle = poseOf(body, frame, position);
      const x = ((position[0] * mapping[0] + mapping[2] + 1) / 2) * width;
      const y = ((1 - position[1] * mapping[1] - mapping[3]) / 2) * height;
      const [c, s] = [scale * Math.cos(angle), scale * Math.sin(angle)];
      const at = 4 * inkOf(body);
      const color = `${inks[at]} ${inks[at + 1]} ${inks[at + 2]}`;
      const fill = Math.min(1, (inks[at + 3]! / 255) * strengthOf(body, i));
      context.lineWidth = frame.rim / scale;
      context.fillStyle = `rgb(${color} / ${fill})`;
      context.strokeStyle = `rgb(${color})`;
      context.setTransform(c, s, -s, c, x, y);
      for (const shape of body.shapes) {
        context.globalAlpha = shape.sensor ? 0.4 : 1;
        trace(context, shape, !body.isStatic());
        context.fill();
        context.stroke();
      }
    });
    context.globalAlpha = 1;
    context.setTransform(1, 0, 0, 1, 0, 0);
  }
}

/** The outline of a shape as the path, with a tick that shows how a disc turns. */
function trace(context: CanvasRenderingContext2D, shape: Shape, ticked: boolean): void {
  context.beginPath();
  if (shape.type === 'CIRCLE') {
    const [x, y] = shape.getOrigin();
    const radius = shape.getRadius();
    context.arc(x, y, radius, 0, 2 * Math.PI);
    if (ticked) {
      context.lineTo(x + 0.4 * radius, y);
    }
    return;
  }
  const { vertices } = shape;
  for (let i = 0; i < vertices.length; i += 2) {
    context.lineTo(vertices[i]!, vertices[i + 1]!);
  }
  context.closePath();
}
