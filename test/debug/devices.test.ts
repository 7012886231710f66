import { describe, expect, it } from 'vitest';
import {
  type CanvasContextLike,
  CanvasDebugDevice,
  type DebugGraphicsDevice,
  Physics2DDebugDraw,
  SVGDebugDevice,
  WebGLDebugDevice,
} from '../../src/debug/index.js';
import { phys2D, type RigidBody, type Vec2 } from '../../src/index.js';
import { NOT_POSITIVE, refuses } from '../bad-input/refuses.js';
import { near } from '../conformance/setting.js';
import { RED } from './recorder.js';

const GREEN = [0, 1, 0, 0.5];

/** Draws in px on a device. */
function drawOn(graphicsDevice: DebugGraphicsDevice, what: (debug: Physics2DDebugDraw) => void): void {
  const debug = Physics2DDebugDraw.create({ graphicsDevice });
  debug.setPhysics2DViewport([0, 0, graphicsDevice.width, graphicsDevice.height]);
  debug.begin();
  what(debug);
  debug.end();
}

/** The strokes of an SVG document: colour, alpha and path. */
function strokes(svg: SVGDebugDevice): string[][] {
  const pattern = /<path stroke="rgb\(([^)]*)\)"(?: stroke-opacity="([^"]*)")? d="([^"]*)"\/>/g;
  return [...String(svg).matchAll(pattern)].map(([, color, alpha, path]) => [color!, alpha ?? '1', path!]);
}

/** The path of lines on an SVG of 100 × 80 px, by the physics of the drawing in px. */
function paths(what: (debug: Physics2DDebugDraw) => void): string[] {
  const svg = SVGDebugDevice.create({ width: 100, height: 80 });
  drawOn(svg, what);
  return strokes(svg).map(([, , path]) => path!);
}

describe('cutting to the clip rectangle', () => {
  it('keeps what is inside, and leaves out what is not', () => {
    expect(
      paths((debug) => {
        debug.drawLine(1, 2, 30, 40, RED);
        debug.drawLine(-5, -5, -1, 70, RED);
        debug.drawLine(101, 0, 101, 80, RED);
        debug.drawLine(90, -30, 130, 10, RED);
      }),
    ).toEqual(['M1 2L30 40']);
  });

  it('cuts at every side', () => {
    expect(
      paths((debug) => {
        debug.drawLine(-10, 10, 10, 30, RED);
        debug.drawLine(90, 10, 110, 30, RED);
        debug.drawLine(50, -10, 70, 10, RED);
        debug.drawLine(50, 70, 30, 90, RED);
        debug.drawLine(50, -100, 50, 200, RED);
      }),
    ).toEqual(['M0 20L10 30M90 10L100 20M60 0L70 10M50 70L40 80M50 0L50 80']);
  });

  it('keeps a line on the edge, and a point', () => {
    expect(paths((debug) => debug.drawLine(0, 0, 0, 80, RED))).toEqual(['M0 0L0 80']);
    expect(paths((debug) => debug.drawLine(5, 5, 5, 5, RED))).toEqual(['M5 5L5 5']);
    expect(paths((debug) => debug.drawLine(-5, 5, -5, 5, RED))).toEqual([]);
  });

  it('cuts to the screen viewport', () => {
    const svg = SVGDebugDevice.create({ width: 100, height: 80 });
    const debug = Physics2DDebugDraw.create({ graphicsDevice: svg });
    debug.setScreenViewport([20, 30, 60, 70]);
    debug.setPhysics2DViewport([0, 0, 4, 4]);
    debug.begin();
    debug.drawLine(-1, 2, 5, 2, RED);
    debug.end();
    expect(strokes(svg)).toEqual([['255, 0, 0', '1', 'M20 50L60 50']]);
  });

  it('is exact far from the origin, and for lines that reach to 1e20 m', () => {
    const svg = SVGDebugDevice.create({ width: 100, height: 80 });
    const debug = Physics2DDebugDraw.create({ graphicsDevice: svg });
    debug.setPhysics2DViewport([1e9, 1e9, 1e9 + 1, 1e9 + 1]);
    debug.begin();
    debug.drawLine(1e9 + 0.25, 1e9 + 0.5, 1e9 + 0.75, 1e9 + 0.5, RED);
    debug.end();
    debug.setPhysics2DViewport([0, 0, 10, 8]);
    debug.begin();
    debug.drawLine(2, 3, 2 + 1e20, 3, RED);
    debug.drawLine(2, 3, 2 - 0.6e20, 3 + 0.8e20, GREEN);
    debug.end();
    expect(strokes(svg).map(([, , path]) => path)).toEqual(['M25 40L75 40', 'M20 30L100 30', 'M20 30L0 56.67']);
    svg.clear();
    debug.begin();
    debug.drawLine(-1e20, 2, 1e20, 2, RED);
    debug.drawLine(3, 1e20, 3, -1e20, RED);
    debug.end();
    expect(strokes(svg).map(([, , path]) => path)).toEqual(['M0 20L100 20M30 80L30 0']);
  });

  it('is as exact for lines that come from 1e20 m as for those that go there', () => {
    const svg = SVGDebugDevice.create({ width: 100, height: 80 });
    const debug = Physics2DDebugDraw.create({ graphicsDevice: svg });
    debug.setPhysics2DViewport([0, 0, 10, 8]);
    debug.begin();
    debug.drawLine(2 + 1e20, 3, 2, 3, RED);
    debug.drawLine(2 - 0.6e20, 3 + 0.8e20, 2, 3, GREEN);
    debug.end();
    expect(strokes(svg).map(([, , path]) => path)).toEqual(['M100 30L20 30', 'M0 56.67L20 30']);
  });

  it.each<[Vec2, string, string]>([
    [[1, 0], 'M0 40L50 40', 'M50 40L100 40'],
    [[1, 1], 'M10 0L50 40', 'M50 40L90 80'],
    [[3, 4], 'M20 0L50 40', 'M50 40L80 80'],
    [[1, 0.5], 'M0 15L50 40', 'M50 40L100 65'],
  ])('shows both halves of a line constraint without bounds, along %j', (axis, below, above) => {
    const svg = SVGDebugDevice.create({ width: 100, height: 80 });
    const debug = Physics2DDebugDraw.create({ graphicsDevice: svg });
    debug.setPhysics2DViewport([0, 0, 10, 8]);
    const [bodyA, bodyB] = [0, 1].map(() => phys2D.createRigidBody({ position: [5, 4] })) as [RigidBody, RigidBody];
    debug.begin();
    debug.drawConstraint(phys2D.createLineConstraint({ bodyA, bodyB, axis }));
    debug.end();
    const paths = strokes(svg).map(([, , path]) => path);
    expect(paths.slice(-2)).toEqual([below, above]);
  });

  it('leaves out what is too far away for numbers, and nothing else', () => {
    expect(
      paths((debug) => {
        debug.drawLine(1, 2, 30, 40, RED);
        debug.drawRectangle(-1e308, -1e308, 1e308, 1e308, RED);
        debug.drawCurve(0, 0, 1e308, 1e308, 1, 1, RED);
        debug.drawLine(30, 40, 50, 60, RED);
      }),
    ).toEqual(['M1 2L30 40L50 60']);
  });
});

describe('SVG', () => {
  it('has one path for what follows in one colour, without moves where lines hang together', () => {
    const svg = SVGDebugDevice.create({ width: 100, height: 80 });
    drawOn(svg, (debug) => {
      debug.drawRectangle(10, 10, 20, 30, RED);
      debug.drawLine(1, 1, 2, 2.126, RED);
      debug.drawLine(2, 2.126, 3, -0.001, GREEN);
      debug.drawLine(3, 0, 4, 4, RED);
    });
    expect(strokes(svg)).toEqual([
      ['255, 0, 0', '1', 'M10 10L20 10L20 30L10 30L10 10M1 1L2 2.13'],
      ['0, 255, 0', '0.5', 'M2 2.13L3 0'],
      ['255, 0, 0', '1', 'M3 0L4 4'],
    ]);
  });

  it('is a whole document, with background and line width', () => {
    const svg = SVGDebugDevice.create({ width: 100, height: 80, lineWidth: 2, background: '#123456' });
    drawOn(svg, (debug) => debug.drawLine(0, 0, 1, 1, RED));
    expect(String(svg)).toBe(`<svg xmlns="http://www.w3.org/2000/svg" width="100" height="80" viewBox="0 0 100 80">
<rect width="100" height="80" fill="#123456"/>
<g fill="none" stroke-width="2" stroke-linejoin="round">
<path stroke="rgb(255, 0, 0)" d="M0 0L1 1"/>
</g>
</svg>
`);
  });

  it('gathers frames until it is cleared', () => {
    const svg = SVGDebugDevice.create({ width: 100, height: 80 });
    drawOn(svg, (debug) => debug.drawLine(0, 0, 1, 1, RED));
    drawOn(svg, (debug) => debug.drawLine(0, 0, 2, 2, RED));
    expect(strokes(svg)).toHaveLength(2);
    svg.clear();
    expect(strokes(svg)).toEqual([]);
  });

  it('refuses bad options', () => {
    const where = 'SVGDebugDevice.create';
    const valid = { width: 1, height: 1 };
    for (const name of ['width', 'height', 'lineWidth']) {
      for (const bad of NOT_POSITIVE) {
        refuses((value) => SVGDebugDevice.create({ ...valid, [name]: value }), where, name, bad);
      }
    }
    for (const name of ['background', 'title']) {
      refuses((value) => SVGDebugDevice.create({ ...valid, [name]: value }), where, name, [7, TypeError]);
    }
  });

  it('lets no text out of its place', () => {
    const svg = SVGDebugDevice.create({ width: 1, height: 1, title: '<b> & "c"', background: '"/><script>' });
    expect(String(svg)).toContain('<title>&#60;b&#62; &#38; &#34;c&#34;</title>');
    expect(String(svg)).not.toContain('<script>');
  });
});

/** A context that writes down what it is told. */
class FakeContext implements CanvasContextLike {
  readonly canvas = { width: 100, height: 80 };
  readonly log: string[] = [];
  /** All manners in which it stroked. */
  readonly inks = new Set<string>();
  strokeStyle: unknown = 'black';
  lineWidth = 7;
  lineCap = 'square';
  lineJoin = 'miter';
  globalAlpha = 0.25;
  globalCompositeOperation = 'multiply';
  dash = [4, 2];
  setLineDash(lengths: number[]): void {
    this.dash = lengths;
  }
  save(): void {
    this.log.push('save');
  }
  restore(): void {
    this.log.push('restore');
  }
  setTransform(...matrix: number[]): void {
    this.log.push(`transform ${matrix}`);
  }
  beginPath(): void {
    this.log.push('begin');
  }
  moveTo(x: number, y: number): void {
    this.log.push(`M${x} ${y}`);
  }
  lineTo(x: number, y: number): void {
    this.log.push(`L${x} ${y}`);
  }
  stroke(): void {
    this.log.push(`stroke ${this.strokeStyle} ${this.lineWidth}`);
    this.inks.add(`${this.globalAlpha} ${this.globalCompositeOperation} [${this.dash}]`);
  }
}

describe('Canvas', () => {
  it('strokes one path for what follows in one colour, within save and restore', () => {
    const context = new FakeContext();
    drawOn(CanvasDebugDevice.create({ context, lineWidth: 2 }), (debug) => {
      debug.drawLine(1, 2, 3, 4, RED);
      debug.drawLine(3, 4, 5, 6, RED);
      debug.drawLine(-1, 0, -1, 5, GREEN);
      debug.drawLine(1, 2, 3, 4, GREEN);
    });
    const rounded = context.log.map((entry) =>
      entry.replace(/\d+\.\d+(?=[ ]|$)/g, (x) => String(Math.round(Number(x) * 1e6) / 1e6)),
    );
    expect(rounded).toEqual([
      'save',
      'transform 1,0,0,1,0,0',
      'begin',
      'M1 2',
      'L3 4',
      'L5 6',
      'stroke rgba(255, 0, 0, 1) 2',
      'begin',
      'M1 2',
      'L3 4',
      'stroke rgba(0, 255, 0, 0.5) 2',
      'begin',
      'restore',
    ]);
    // Whatever the page left in the context.
    expect([...context.inks]).toEqual(['1 source-over []']);
  });

  it('divides long paths, and loses nothing', () => {
    const context = new FakeContext();
    drawOn(CanvasDebugDevice.create({ context }), (debug) => {
      for (let i = 0; i < 1700; i += 1) {
        debug.drawLine(i / 20, 0, (i + 1) / 20, 0, RED);
      }
    });
    const lines = context.log.filter((entry) => entry.startsWith('L'));
    const lengths = context.log
      .join('\n')
      .split('stroke')
      .map((path) => path.split('\nL').length - 1);
    expect(lines).toHaveLength(1700);
    expect(Math.max(...lengths)).toBeLessThanOrEqual(500);
    near(Number(lines.at(-1)!.slice(1).split(' ')[0]), 85);
  });

  it('has the size of its canvas', () => {
    const context = new FakeContext();
    const device = CanvasDebugDevice.create({ context });
    context.canvas.width = 50;
    expect([device.width, device.height]).toEqual([50, 80]);
  });

  it('refuses bad options', () => {
    const where = 'CanvasDebugDevice.create';
    refuses((params) => CanvasDebugDevice.create(params), where, 'params', [undefined, TypeError]);
    for (const [value, shown] of [
      [undefined, 'undefined'],
      [null, 'null'],
      [{}, 'an object'],
    ] as const) {
      refuses((context) => CanvasDebugDevice.create({ context }), where, 'context', [value, TypeError, shown]);
    }
    const context = new FakeContext();
    for (const bad of NOT_POSITIVE) {
      refuses((lineWidth) => CanvasDebugDevice.create({ context, lineWidth }), where, 'lineWidth', bad);
    }
  });
});

it('the WebGL device refuses what is no WebGL 2 context, and bad line widths', () => {
  const where = 'WebGLDebugDevice.create';
  refuses((params) => WebGLDebugDevice.create(params), where, 'params', [undefined, TypeError]);
  for (const [value, shown] of [
    [undefined, 'undefined'],
    [null, 'null'],
    [{}, 'an object'],
  ] as const) {
    refuses((context) => WebGLDebugDevice.create({ context }), where, 'context', [value, TypeError, shown]);
  }
  const context = { bindVertexArray() {} } as never;
  for (const bad of NOT_POSITIVE) {
    refuses((lineWidth) => WebGLDebugDevice.create({ context, lineWidth }), where, 'lineWidth', bad);
  }
});
