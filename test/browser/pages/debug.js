import { CanvasDebugDevice, Physics2DDebugDraw, WebGLDebugDevice } from '/dist/debug.min.js';
import { phys2D } from '/dist/phys2d.min.js';
import { buildGallery, GALLERY } from '/scenes/gallery.js';

/** A canvas with a device that draws on it: 'canvas' or 'webgl'. */
function makeDevice(kind, width, height, lineWidth) {
  const canvas = document.createElement('canvas');
  canvas.width = width;
  canvas.height = height;
  document.body.style.margin = '0';
  document.body.append(canvas);
  if (kind === 'canvas') {
    const context = canvas.getContext('2d');
    context.fillRect(0, 0, width, height);
    return { canvas, device: CanvasDebugDevice.create({ context, lineWidth }) };
  }
  const context = canvas.getContext('webgl2', { preserveDrawingBuffer: true, antialias: false });
  context.clearColor(0, 0, 0, 1);
  context.clear(context.COLOR_BUFFER_BIT);
  return { canvas, device: WebGLDebugDevice.create({ context, lineWidth }) };
}

/** All pixels of a canvas, four bytes each. */
function pixelsOf(source) {
  const copy = document.createElement('canvas');
  copy.width = source.width;
  copy.height = source.height;
  const context = copy.getContext('2d');
  context.drawImage(source, 0, 0);
  return context.getImageData(0, 0, copy.width, copy.height).data;
}

/** Draws lines through the middles of pixels; returns the colours at the given pixels. */
export function pattern(kind, lines, viewport, places) {
  const { canvas, device } = makeDevice(kind, 100, 80, 1);
  const debug = Physics2DDebugDraw.create({ graphicsDevice: device });
  debug.setPhysics2DViewport(viewport);
  debug.setScreenViewport(viewport);
  debug.begin();
  for (const [x1, y1, x2, y2, color] of lines) {
    debug.drawLine(x1, y1, x2, y2, color);
  }
  debug.end();
  const data = pixelsOf(canvas);
  return places.map(([x, y]) => Array.from(data.slice(4 * (100 * y + x), 4 * (100 * y + x) + 3)));
}

/** Draws the gallery after some steps. */
export function gallery(kind, lineWidth = 1) {
  const world = phys2D.createWorld();
  buildGallery(phys2D, world);
  for (let i = 0; i < 24; i += 1) {
    world.step(1 / 60);
  }
  const { canvas, device } = makeDevice(kind, 60 * GALLERY[0], 60 * GALLERY[1], lineWidth);
  const debug = Physics2DDebugDraw.create({ graphicsDevice: device });
  debug.showContacts = true;
  debug.begin();
  debug.drawWorld(world);
  debug.end();
  return canvas;
}

/** Of what is lit in one picture of the gallery, how much is lit within a px in the other, and how many px are lit. */
export function compare() {
  const [a, b] = ['canvas', 'webgl'].map((kind) => {
    const canvas = gallery(kind);
    return { width: canvas.width, data: pixelsOf(canvas) };
  });
  const isLit = ({ data }, i) => Math.max(data[4 * i], data[4 * i + 1], data[4 * i + 2]) > 60;
  const share = (one, other) => {
    let lit = 0;
    let matched = 0;
    for (let i = 0; i < one.data.length / 4; i += 1) {
      if (isLit(one, i)) {
        const around = [-1, 0, 1].flatMap((dy) => [-1, 0, 1].map((dx) => i + dy * one.width + dx));
        lit += 1;
        matched += around.some((k) => isLit(other, k)) ? 1 : 0;
      }
    }
    return { lit, share: matched / lit };
  };
  return [share(a, b), share(b, a)];
}

let frame;

/** Lines of whole numbers, which the caller has not to box. */
function drawLines(debug, count) {
  const color = [1, 0.5, 0, 1];
  for (let i = 0; i < count; i += 1) {
    debug.drawLine(i % 700, (i >> 7) % 500, (i % 700) + 6, ((i >> 7) % 500) + 3, color);
  }
}

/** Bodies of 24 segments and more, some of them on springs. */
function crowd(count) {
  const world = phys2D.createWorld({ gravity: [0, 0] });
  const vertices = phys2D.createBoxVertices(40, 20);
  for (let i = 0; i < count / 24; i += 1) {
    const position = [20 + (i % 700), 20 + ((i >> 4) % 500)];
    const circle = phys2D.createCircleShape({ radius: 30, origin: [10, 0] });
    const box = phys2D.createPolygonShape({ vertices });
    const body = phys2D.createRigidBody({ position, rotation: i, shapes: [circle, box] });
    world.addRigidBody(body);
    if (i % 16 === 0) {
      const bodyA = phys2D.createRigidBody({ type: 'static' });
      world.addConstraint(phys2D.createPointConstraint({ bodyA, bodyB: body, stiff: false }));
    }
  }
  return world;
}

/** Makes ready to draw `count` segments, of a kind, with WebGL, one m for each px. Returns the calls of WebGL that draw in the first frame. */
export function prepareMany(kind, count) {
  const { canvas, device } = makeDevice('webgl', 800, 600, 1);
  const debug = Physics2DDebugDraw.create({ graphicsDevice: device });
  debug.setPhysics2DViewport([0, 0, 800, 600]);
  const world = crowd(count);
  frame = () => {
    debug.begin();
    if (kind === 'lines') {
      drawLines(debug, count);
    } else {
      debug.drawWorld(world);
    }
    debug.end();
  };
  const gl = canvas.getContext('webgl2');
  const names = ['drawArrays', 'drawElements', 'drawArraysInstanced', 'drawElementsInstanced'];
  const calls = [];
  for (const name of names) {
    gl[name] = (...args) => calls.push([name, ...args]);
  }
  frame();
  // The others do not draw either: computed by the processor, 100,000 lines take half a second.
  return calls;
}

/** Draws so many frames. Returns the milliseconds that each took on the average. */
export function drawMany(frames) {
  const start = performance.now();
  for (let i = 0; i < frames; i += 1) {
    frame();
  }
  return (performance.now() - start) / frames;
}

/** Draws a line, loses the context, draws, gets the context back, draws. Returns the colour on the line after each. */
export async function loseContext() {
  const { canvas, device } = makeDevice('webgl', 100, 80, 1);
  const gl = canvas.getContext('webgl2');
  const debug = Physics2DDebugDraw.create({ graphicsDevice: device });
  const colors = [];
  const draw = () => {
    debug.begin();
    debug.drawLine(0, 29.5 / 60, 1, 29.5 / 60, [0, 1, 0, 1]);
    debug.end();
    colors.push(Array.from(pixelsOf(canvas).slice(4 * (100 * 29 + 30), 4 * (100 * 29 + 30) + 4)));
  };
  const happens = (type) => new Promise((resolve) => canvas.addEventListener(type, resolve, { once: true }));
  canvas.addEventListener('webglcontextlost', (event) => event.preventDefault());
  draw();
  const extension = gl.getExtension('WEBGL_lose_context');
  const lost = happens('webglcontextlost');
  extension.loseContext();
  await lost;
  draw();
  const restored = happens('webglcontextrestored');
  setTimeout(() => extension.restoreContext(), 0);
  await restored;
  draw();
  debug.destroy();
  return { colors, error: gl.getError() };
}
