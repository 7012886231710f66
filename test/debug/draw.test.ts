import { describe, expect, it } from 'vitest';
import { type DebugGraphicsDevice, Physics2DDebugDraw } from '../../src/debug/index.js';
import { NOT_FINITE, NOT_NON_NEGATIVE, NOT_VECTOR, refuses } from '../bad-input/refuses.js';
import { near } from '../conformance/setting.js';
import { draw, RED, type RecordingDevice, recorder } from './recorder.js';

/** px of a physics point by the mapping that the device got. */
function toScreen({ width, height, frames }: RecordingDevice, x: number, y: number): [number, number] {
  const [c0, c1, c2, c3] = frames.at(-1)!.mapping as [number, number, number, number];
  return [((x * c0 + c2 + 1) / 2) * width, ((1 - (y * c1 + c3)) / 2) * height];
}

function frame({ debug }: { debug: Physics2DDebugDraw }): void {
  debug.begin();
  debug.drawLine(0, 0, 1, 1, RED);
  debug.end();
}

describe('the mapping to the device', () => {
  it('is 60 px per metre from the upper left by default, on all of it', () => {
    const recording = recorder(800, 300);
    frame(recording);
    const { device, debug } = recording;
    near(toScreen(device, 0, 0), [0, 0]);
    near(toScreen(device, 1, 2), [60, 120]);
    near(toScreen(device, 800 / 60, 5), [800, 300]);
    expect(device.frames[0]!.clip).toEqual([0, 0, 800, 300]);
    near(debug.physics2DToScreen, 60);
    near(debug.screenToPhysics2D, 1 / 60);
  });

  it('takes the corners of the physics viewport to those of the screen viewport', () => {
    const recording = recorder(800, 400);
    const { device, debug } = recording;
    debug.setScreenViewport([100, 50, 500, 250]);
    debug.setPhysics2DViewport(new Float32Array([-3, 2, 1, 6]));
    frame(recording);
    near(toScreen(device, -3, 2), [100, 50]);
    near(toScreen(device, 1, 6), [500, 250]);
    near(toScreen(device, -1, 4), [300, 150]);
    expect(device.frames[0]!.clip).toEqual([100, 50, 400, 200]);
    near(debug.physics2DToScreen, (400 / 4 + 200 / 4) / 2);
    near(debug.screenToPhysics2D, 1 / 75);
  });

  it('has the coefficients of the specification', () => {
    const recording = recorder(800, 400);
    const [sx, sy, sw, sh] = [100, 50, 400, 200];
    const [px, py, pw, ph] = [-3, 2, 4, 4];
    recording.debug.setScreenViewport([sx, sy, sx + sw, sy + sh]);
    recording.debug.setPhysics2DViewport([px, py, px + pw, py + ph]);
    frame(recording);
    near(
      recording.device.frames[0]!.mapping,
      [
        (2 * sw) / (800 * pw),
        (-2 * sh) / (400 * ph),
        (-2 * px * sw) / (800 * pw) + (2 * sx) / 800 - 1,
        (2 * py * sh) / (400 * ph) - (2 * sy) / 400 + 1,
      ],
      1e-12,
    );
  });

  it.each(['setPhysics2DViewport', 'setScreenViewport'] as const)('is finite for the largest %s', (name) => {
    const { device, debug } = recorder();
    debug[name]([-1e150, -1e150, 1e150, 1e150]);
    debug.begin();
    expect(debug.physics2DToScreen).toBeGreaterThan(0);
    debug.drawLine(0, 0, 1, 1, [1, 1, 1, 1]);
    debug.end();
    expect(device.frames).toHaveLength(1);
    expect([...debug.lines.mapping, ...debug.lines.clip].every(Number.isFinite)).toBe(true);
  });

  it('follows viewports and the size of the device at the next begin only, and goes back to the defaults', () => {
    const recording = recorder();
    const { device, debug } = recording;
    frame(recording);
    debug.begin();
    debug.setPhysics2DViewport([0, 0, 1, 1]);
    debug.setScreenViewport([0, 0, 10, 10]);
    device.width = 1200;
    debug.drawLine(0, 0, 1, 1, RED);
    expect(debug.physics2DToScreen).toBe(60);
    debug.end();
    expect(device.frames[1]).toEqual(device.frames[0]);
    frame(recording);
    expect(device.frames[2]!.clip).toEqual([0, 0, 10, 10]);
    near(debug.physics2DToScreen, 10);
    debug.setPhysics2DViewport(null);
    debug.setScreenViewport(undefined);
    frame(recording);
    expect(device.frames[3]!.clip).toEqual([0, 0, 1200, 600]);
    near(toScreen(device, 20, 10), [1200, 600]);
  });

  it('keeps nothing of the rectangles', () => {
    const recording = recorder();
    const rectangle = [0, 0, 300, 300];
    recording.debug.setScreenViewport(rectangle);
    rectangle[2] = 1;
    frame(recording);
    expect(recording.device.frames[0]!.clip).toEqual([0, 0, 300, 300]);
  });

  it('stays finite on a device without area', () => {
    const recording = recorder(0, 0);
    frame(recording);
    expect(recording.device.frames[0]!.mapping.every(Number.isFinite)).toBe(true);
    expect(recording.debug.physics2DToScreen).toBeGreaterThan(0);
  });
});

describe('a frame', () => {
  it('scales are 0 before the first begin, and nothing can be drawn', () => {
    const { debug } = recorder();
    expect([debug.physics2DToScreen, debug.screenToPhysics2D]).toEqual([0, 0]);
    expect(() => debug.drawLine(0, 0, 1, 1, RED)).toThrow(
      'Physics2DDebugDraw.drawLine: must not be called before begin',
    );
  });

  it('is sent at its end, in the order of drawing, and then forgotten', () => {
    const { device, debug } = recorder();
    debug.begin();
    for (let i = 0; i < 1000; i += 1) {
      debug.drawLine(i, 0, i, 1, [i / 1000, 0, 0, 1]);
    }
    expect(device.frames).toHaveLength(0);
    debug.end();
    expect(device.frames).toHaveLength(1);
    const { segments } = device.frames[0]!;
    expect(segments.map(({ ends }) => ends)).toEqual(Array.from({ length: 1000 }, (_, i) => [i, 0, i, 1]));
    expect(segments.map(({ color }) => color)).toEqual(Array.from({ length: 1000 }, (_, i) => [i / 1000, 0, 0, 1]));
    debug.end();
    expect(device.frames).toHaveLength(1);
  });

  it('in which nothing was drawn is not sent', () => {
    const { device, debug } = recorder();
    debug.begin();
    debug.end();
    expect(device.frames).toEqual([]);
  });

  it('that was not ended is dropped by the next', () => {
    const { device, debug } = recorder();
    debug.begin();
    debug.drawLine(0, 0, 1, 1, RED);
    debug.begin();
    debug.drawRectangle(0, 0, 1, 1, RED);
    debug.end();
    expect(device.frames.map(({ segments }) => segments.length)).toEqual([4]);
  });

  it('that the device could not draw is not sent again', () => {
    const { device, debug } = recorder();
    const { drawLines } = device;
    device.drawLines = () => {
      throw new Error('lost');
    };
    debug.begin();
    debug.drawLine(0, 0, 1, 1, RED);
    expect(() => debug.end()).toThrow('lost');
    device.drawLines = drawLines;
    debug.end();
    expect(device.frames).toEqual([]);
  });

  it('ends for good with destroy, which releases the device once', () => {
    const { device, debug } = recorder();
    debug.begin();
    debug.destroy();
    debug.destroy();
    expect(device.destroyed).toBe(1);
    for (const call of [
      () => debug.begin(),
      () => debug.end(),
      () => debug.drawLine(0, 0, 1, 1, RED),
      () => debug.drawWorld({} as never),
    ]) {
      expect(call).toThrow(/^Physics2DDebugDraw\.\w+: must not be called after destroy$/);
    }
  });

  it('works with a device that has nothing to release', () => {
    const graphicsDevice: DebugGraphicsDevice = { width: 1, height: 1, drawLines: () => {} };
    expect(() => Physics2DDebugDraw.create({ graphicsDevice }).destroy()).not.toThrow();
  });
});

describe('refusals', () => {
  const valid: Record<string, Record<string, unknown>> = {
    drawLine: { x1: 0, y1: 0, x2: 1, y2: 1, color: RED },
    drawRectangle: { x1: 0, y1: 0, x2: 1, y2: 1, color: RED },
    drawCircle: { x: 0, y: 0, radius: 1, color: RED },
    drawCurve: { x1: 0, y1: 0, cx: 1, cy: 0, x2: 1, y2: 1, color: RED },
    drawSpiral: { x: 0, y: 0, angle1: 0, angle2: 1, radius1: 1, radius2: 2, color: RED },
    drawLinearSpring: { x1: 0, y1: 0, x2: 1, y2: 1, numCoils: 3, radius: 0.1, color: RED },
    drawSpiralSpring: { x: 0, y: 0, angle1: 0, angle2: 1, radius1: 1, radius2: 2, numCoils: 3, color: RED },
  };
  const BAD_COLORS = [...NOT_VECTOR, [[1, 0, 0], TypeError, 'an array of length 3']] as typeof NOT_VECTOR;

  it.each(Object.keys(valid))('%s refuses bad numbers and colours, and draws nothing of them', (name) => {
    const { device, debug } = recorder();
    debug.begin();
    const call = (args: object): unknown =>
      (debug[name as 'drawLine'] as (...values: unknown[]) => unknown).apply(debug, Object.values(args));
    for (const argument of Object.keys(valid[name]!)) {
      const bads =
        argument === 'color'
          ? BAD_COLORS
          : argument === 'radius' && name === 'drawCircle'
            ? NOT_NON_NEGATIVE
            : NOT_FINITE;
      for (const bad of bads) {
        refuses((value) => call({ ...valid[name], [argument]: value }), `Physics2DDebugDraw.${name}`, argument, bad);
      }
    }
    for (const [index, value, kind] of [
      [0, NaN, RangeError],
      [1, -0.1, RangeError],
      [2, 1.5, RangeError],
      [3, '1', TypeError],
    ] as const) {
      const color = Object.assign([0, 0, 0, 1], { [index]: value });
      const shown = typeof value === 'string' ? `"${value}"` : undefined;
      refuses(
        () => call({ ...valid[name], color }),
        `Physics2DDebugDraw.${name}`,
        `color[${index}]`,
        shown === undefined ? [value, kind] : [value, kind, shown],
      );
    }
    debug.end();
    expect(device.frames).toEqual([]);
    debug.begin();
    call(valid[name]!);
    debug.end();
    expect(device.frames).toHaveLength(1);
  });

  it.each(['setPhysics2DViewport', 'setScreenViewport'] as const)(
    '%s refuses what has no area, and keeps what it had',
    (name) => {
      const recording = recorder();
      const { device, debug } = recording;
      debug[name]([0, 0, 5, 5]);
      for (const bad of [
        ...NOT_VECTOR.filter(([value]) => value !== null),
        [[0, 0, 1], TypeError, 'an array of length 3'],
      ] as typeof NOT_VECTOR) {
        refuses((value) => debug[name](value), `Physics2DDebugDraw.${name}`, 'rectangle', bad);
      }
      refuses((value) => debug[name]([0, value, 1, 1]), `Physics2DDebugDraw.${name}`, 'rectangle[1]', [
        NaN,
        RangeError,
      ]);
      refuses((value) => debug[name]([0, 0, value, 1]), `Physics2DDebugDraw.${name}`, 'rectangle[2]', [0, RangeError]);
      refuses((value) => debug[name]([0, 0, 1, value]), `Physics2DDebugDraw.${name}`, 'rectangle[3]', [-1, RangeError]);
      for (const far of [1.1e150, 1.7e308]) {
        expect(() => debug[name]([-far, -far, far, far])).toThrow(
          new RangeError(
            `Physics2DDebugDraw.${name}: rectangle[0] must be a number of at most 1e+150, got ${String(-far)}`,
          ),
        );
      }
      frame(recording);
      const { device: other, debug: same } = recorder();
      same[name]([0, 0, 5, 5]);
      frame({ debug: same });
      expect(device.frames).toEqual(other.frames);
    },
  );

  it('create refuses what is no device', () => {
    const where = 'Physics2DDebugDraw.create';
    refuses((params) => Physics2DDebugDraw.create(params), where, 'params', [undefined, TypeError]);
    for (const [value, shown] of [
      [undefined, 'undefined'],
      [null, 'null'],
      [{}, 'an object'],
    ] as const) {
      refuses((graphicsDevice) => Physics2DDebugDraw.create({ graphicsDevice }), where, 'graphicsDevice', [
        value,
        TypeError,
        shown,
      ]);
    }
    for (const [width, kind, shown] of NOT_NON_NEGATIVE) {
      const device = { width, height: 1, drawLines() {} };
      const bad = shown === undefined ? ([width, kind] as const) : ([width, kind, shown] as const);
      refuses(() => Physics2DDebugDraw.create({ graphicsDevice: device as never }), where, 'graphicsDevice.width', bad);
    }
  });

  it('begin refuses a device that lost its size', () => {
    const { device, debug } = recorder();
    device.height = NaN;
    refuses(() => debug.begin(), 'Physics2DDebugDraw.begin', 'graphicsDevice.height', [NaN, RangeError]);
  });

  it.each([
    ['drawWorld', 'world'],
    ['drawRigidBody', 'rigidBody'],
    ['drawConstraint', 'constraint'],
  ] as const)('%s refuses anything else', (name, argument) => {
    draw((debug) => {
      for (const bad of [
        [undefined, TypeError],
        [null, TypeError],
        [7, TypeError],
        [{}, TypeError, 'an object'],
      ] as const) {
        refuses((value) => debug[name](value), `Physics2DDebugDraw.${name}`, argument, bad);
      }
    });
  });
});
