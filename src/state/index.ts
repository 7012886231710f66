/**
 * Worlds as plain data, recordings, and poses for a renderer.
 *
 * @module phys2d/state
 */

export { deserialize } from './deserialize.js';
export type { PoseBufferParams } from './poses.js';
export { POSE_STRIDE, PoseBuffer } from './poses.js';
export type { RecordedCall, RecordedSetting, RecordedStep, Recording } from './recorder.js';
export { Recorder, replay } from './recorder.js';
export type {
  DeserializeOptions,
  PlainBody,
  PlainConstraint,
  PlainMaterial,
  PlainNumber,
  PlainShape,
  PlainWorld,
  SerializeOptions,
} from './serialize.js';
export { serialize } from './serialize.js';
