// What users of the types write. The errors that are expected are part of the test: where one is missing, the compiler says so.

const USE = `
const world: World = phys2D.createWorld({ gravity: [0, 10], substeps: 2 });
const vertices: Vec2[] = phys2D.createBoxVertices(1, 1);
const box: Polygon = createPolygonShape({ vertices, userData: { name: 'box' } });
const body: RigidBody = phys2D.createRigidBody({ shapes: [box], position: new Float32Array(2) });
const made: World = createWorld({ gravity: undefined });
const params: RigidBodyParams = { type: 'kinematic', userData: 7 };
const added: boolean = world.addRigidBody(body) && made.addRigidBody(phys2D.createRigidBody(params));
const place: [number, number] = body.getPosition();
const into: Float64Array = body.getPosition(new Float64Array(2));
const kind: boolean = body.isDynamic();
const isWorld: boolean = world instanceof World;
const device: Physics2DDevice = phys2D;
const hinge = phys2D.createPointConstraint({ bodyA: body, bodyB: phys2D.createRigidBody() });
const hingeType: 'POINT' = hinge.type;
const joint: Constraint = hinge;
box.addEventListener('hit', function (arbiter, other, hit) {
  const shape: Shape = this;
  const numbers: number[] = [hit.approachSpeed, hit.impulse];
  const flag: boolean = arbiter.active;
  // @ts-expect-error userData is unknown until it is looked at
  const name: string = other.userData.name;
  void [shape, numbers, flag, name];
});
body.addEventListener('wake', () => {});
joint.addEventListener('break', () => {});
for (const shape of body.shapes) {
  const radius: number = shape.type === 'CIRCLE' ? shape.getRadius() : shape.computeArea();
  // @ts-expect-error polygons have no radius
  shape.getRadius();
  const either: Shape = shape instanceof Shape ? shape.clone() : shape;
  void [radius, either];
}
for (const { shapeA, shapeB } of world.dynamicArbiters) {
  if (shapeA.type === 'POLYGON' && shapeB.type === 'CIRCLE') shapeA.setVertices([shapeB.getOrigin(), [1, 0], [1, 1]]);
}
const found = world.rayCast({ origin: [0, 0], direction: [1, 0], maxFactor: 1 });
if (found?.shape.type === 'POLYGON') found.shape.setVertices(vertices);
for (const one of body.constraints) {
  if (one.type === 'MOTOR') one.setRate(one.getRate() + 1);
  else if (one.type === 'CUSTOM') void one.bodies.length;
  else if ('setLowerBound' in one) one.setLowerBound(0);
  // @ts-expect-error not every kind has a rate
  one.setRate(1);
}
const name: string = typeof box.userData === 'string' ? box.userData : '';
// @ts-expect-error no such event
box.addEventListener('hitt', () => {});
box.addEventListener('hit', () => {}, undefined, 1);
box.addEventListener('preSolve', () => {}, undefined, true);
// @ts-expect-error an option of preSolve alone
box.addEventListener('begin', () => {}, undefined, true);
// @ts-expect-error an event of constraints
body.addEventListener('break', () => {});
// @ts-expect-error unknown option
phys2D.createWorld({ grvity: [0, 10] });
// @ts-expect-error no such type of a body
phys2D.createRigidBody({ type: 'dynamc' });
// @ts-expect-error a required option
phys2D.createCircleShape({});
// @ts-expect-error read-only
body.world = world;
// @ts-expect-error made by createWorld
new World();
// @ts-expect-error internal member
world.stepping;
// @ts-expect-error internal member
body.vx;
void [added, place, into, kind, isWorld, device, hingeType, name];
`;

const NAMES = 'Constraint, Physics2DDevice, Polygon, RigidBody, RigidBodyParams, Vec2'.split(', ');

/** A program that says what its user data is. */
export const USER_DATA: Readonly<Record<string, string>> = {
  'user-data.mts': `import { phys2D } from 'phys2d';
declare module 'phys2d' {
  interface UserData {
    shape: { damage: number };
    body: string;
  }
}
const box = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1, 1), userData: { damage: 3 } });
const body = phys2D.createRigidBody({ shapes: [box], userData: 'a box' });
box.addEventListener('begin', (_, other) => {
  const damage: number | undefined = other.userData?.damage;
  const name: string | null | undefined = other.body?.userData;
  void [damage, name];
});
for (const shape of body.shapes) void shape.userData?.damage.toFixed();
const material = phys2D.createMaterial({ userData: 7 });
// @ts-expect-error nothing was said of materials: unknown
material.userData.toFixed();
// @ts-expect-error of another type
phys2D.createCircleShape({ radius: 1, userData: 'a disc' });
// @ts-expect-error it may be null
box.userData.damage;
`,
};

export const TYPES: Readonly<Record<string, string>> = {
  'import.mts': `import phys2D, { createPolygonShape, createWorld, Shape, World } from 'phys2d';
import type { ${NAMES.join(', ')} } from 'phys2d';
import { CanvasDebugDevice, Physics2DDebugDraw, SVGDebugDevice, type DebugGraphicsDevice } from 'phys2d/debug';
import { Physics2DDebugDraw as Same } from 'phys2d';
import { FixedStepRunner } from 'phys2d/runner';
import { Recorder, serialize } from 'phys2d/state';
import { validate } from 'phys2d/validate';
${USE}
const graphicsDevice: DebugGraphicsDevice = SVGDebugDevice.create({ width: 10, height: 10 });
const debug: Physics2DDebugDraw = Same.create({ graphicsDevice });
const runner: FixedStepRunner = FixedStepRunner.create({ world });
debug.interpolation = runner.interpolation;
const bytes: number = Recorder.create(world).recording.snapshot.byteLength + serialize(world).bodies.length;
validate(world);
void bytes;
declare const canvas: HTMLCanvasElement;
CanvasDebugDevice.create({ context: canvas.getContext('2d')! });
`,
  'named.cts': `import { createPolygonShape, createWorld, phys2D, Shape, World } from 'phys2d';
import type { ${NAMES.join(', ')} } from 'phys2d';
import { Physics2DDebugDraw, SVGDebugDevice } from 'phys2d/debug';
import { FixedStepRunner } from 'phys2d/runner';
import { Recorder, serialize } from 'phys2d/state';
import { validate } from 'phys2d/validate';
${USE}
const debug: Physics2DDebugDraw = Physics2DDebugDraw.create({ graphicsDevice: SVGDebugDevice.create({ width: 1, height: 1 }) });
const runner: FixedStepRunner = FixedStepRunner.create({ world });
debug.interpolation = runner.interpolation;
const bytes: number = Recorder.create(world).recording.snapshot.byteLength + serialize(world).bodies.length;
validate(world);
void bytes;
`,
  'require.cts': `import phys2D = require('phys2d');
import createWorld = phys2D.createWorld;
import createPolygonShape = phys2D.createPolygonShape;
import Shape = phys2D.Shape;
import World = phys2D.World;
${NAMES.map((name) => `type ${name} = phys2D.${name};`).join('\n')}
${USE}`,
};
