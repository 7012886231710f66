/**
 * Debug drawing, and devices that it draws with.
 *
 * @module phys2d/debug
 */

export type { CanvasContextLike, CanvasDebugDeviceParams } from './canvas.js';
export { CanvasDebugDevice } from './canvas.js';
export type { ColorLike, DebugGraphicsDevice, DebugLines } from './device.js';
export type { DebugDrawParams } from './draw.js';
export { Physics2DDebugDraw } from './draw.js';
export type { Color } from './settings.js';
export type { SVGDebugDeviceParams } from './svg.js';
export { SVGDebugDevice } from './svg.js';
export type { WebGL2ContextLike, WebGLDebugDeviceParams } from './webgl.js';
export { WebGLDebugDevice } from './webgl.js';
