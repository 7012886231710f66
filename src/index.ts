/**
 * The engine: worlds, bodies, shapes, materials, constraints, and `phys2D`, which makes them.
 *
 * @module phys2d
 */

export type { BodyEventType, BodyHandler } from './body.js';
export { RigidBody } from './body.js';
export type { BodyType, RigidBodyParams } from './body-params.js';
export type { BoxTreeExternalNode, BoxTreeRayResult } from './broadphase/box-tree.js';
export { BoxTree, BoxTreeNode } from './broadphase/box-tree.js';
export { BoxTreeBroadphase } from './broadphase/box-tree-broadphase.js';
export type { Broadphase, BroadphaseFilter, BroadphaseHandle } from './broadphase/broadphase.js';
export { SweepAndPrune } from './broadphase/sweep-and-prune.js';
export { CollisionUtils } from './collide/utils.js';
export type { AngleConstraintParams } from './constraint/angle.js';
export { AngleConstraint } from './constraint/angle.js';
export type { ConstraintEventType, ConstraintHandler, ConstraintType } from './constraint/constraint.js';
export { Constraint } from './constraint/constraint.js';
export type { CustomCallback, CustomConstraintParams } from './constraint/custom.js';
export { CustomConstraint } from './constraint/custom.js';
export type { DistanceConstraintParams } from './constraint/distance.js';
export { DistanceConstraint } from './constraint/distance.js';
export type { LineConstraintParams } from './constraint/line.js';
export { LineConstraint } from './constraint/line.js';
export type { MotorConstraintParams } from './constraint/motor.js';
export { MotorConstraint } from './constraint/motor.js';
export type { ConstraintConfig, ConstraintParams } from './constraint/params.js';
export type { PointConstraintParams } from './constraint/point.js';
export { PointConstraint } from './constraint/point.js';
export type { PulleyConstraintParams } from './constraint/pulley.js';
export { PulleyConstraint } from './constraint/pulley.js';
export type { Bounds, RatioParams, TwoAnchorParams, TwoBodyParams } from './constraint/two-body.js';
export { TwoBodyConstraint } from './constraint/two-body.js';
export type { WeldConstraintParams } from './constraint/weld.js';
export { WeldConstraint } from './constraint/weld.js';
export { Arbiter } from './contact/arbiter.js';
export { Contact } from './contact/contact.js';
export { Hit } from './contact/hit.js';
export {
  createAngleConstraint,
  createBoxTreeBroadphase,
  createCircleShape,
  createCollisionUtils,
  createCustomConstraint,
  createDistanceConstraint,
  createLineConstraint,
  createMaterial,
  createMotorConstraint,
  createPointConstraint,
  createPolygonShape,
  createPulleyConstraint,
  createRigidBody,
  createSweepAndPruneBroadphase,
  createWeldConstraint,
  createWorld,
  getDefaultMaterial,
} from './create.js';
export { Physics2DDebugDraw } from './debug/index.js';
export { Physics2DDevice, phys2D, phys2D as default } from './device.js';
export { createBoxVertices, createRectangleVertices, createRegularPolygonVertices } from './geometry/vertices.js';
export { Kernels } from './kernels.js';
export type { MaterialParams } from './material.js';
export { Material } from './material.js';
export type { Matrix23Like, NumberSink, Ray, Rect, RectLike, Vec2, Vec2Like, Vec3, Vec3Like } from './math/vectors.js';
export type { Clock, Phase, Profile } from './profile.js';
export type { CastResult } from './query/casts.js';
export type { CircleParams } from './shape/circle.js';
export { Circle } from './shape/circle.js';
export type { PolygonParams } from './shape/polygon.js';
export { Polygon } from './shape/polygon.js';
export type { HitHandler, ShapeEvents, ShapeEventType, ShapeHandler, ShapeParams } from './shape/shape.js';
export { Shape } from './shape/shape.js';
export { simdKernels } from './simd.js';
export { worldState } from './state/snapshot.js';
export type { UserData } from './user-data.js';
export { World } from './world.js';
export type {
  PoseUpdate,
  WorldBodyHandler,
  WorldContactHandler,
  WorldEvents,
  WorldEventType,
  WorldHitHandler,
  WorldParams,
  WorldSaving,
} from './world-state.js';
