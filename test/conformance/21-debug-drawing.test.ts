import { describe, expect, it } from 'vitest';
import { phys2D } from '../../src/index.js';
import { draw, RED, recorder } from '../debug/recorder.js';
import { add, boxBody, disc, near, plainBody, staticBody, steps, tie, weightless } from './setting.js';

const DEFAULTS = {
  physics2DToScreen: 0,
  screenToPhysics2D: 0,
  showRigidBodies: true,
  showColliderShapes: true,
  showSensorShapes: true,
  showSensorsShapes: true,
  showBodyDetail: false,
  showShapeDetail: false,
  showConstraints: true,
  showContacts: false,
  showContactImpulses: false,
  circleMaxError: 0.4,
  curveMaxError: 0.6,
  spiralMaxArc: Math.PI / 4,
  spiralEpsilon: 1e-5,
  spiralSpringSize: 0.75,
  minSpringLength: 0.5,
  constraintAnchorRadius: 3,
  constraintSpringRadius: 3,
  constraintSpringNumCoils: 3,
  constraintSpiralMinRadius: 10,
  constraintSpiralDeltaRadius: 2.5 / Math.PI,
  constraintSpiralNumCoils: 4,
  contactRadius: 3,
  contactImpulseScale: 30,
  bodyPositionRadius: 0.5,
  circleOriginRadius: 0.5,
  constraintColorA: [1, 0, 0, 0.8],
  constraintColorB: [0, 0, 1, 0.8],
  constraintColorC: [0, 1, 0, 0.8],
  constraintColorD: [1, 0, 1, 0.8],
  constraintErrorColorA: [1, 1, 0.5, 0.8],
  constraintErrorColorB: [0.5, 1, 1, 0.8],
  constraintErrorColorC: [0.4, 1, 0.4, 0.8],
  constraintErrorColorD: [1, 0.4, 1, 0.8],
  dynamicContactColor: [1, 0, 0.5, 0.7],
  normalImpulseColor: [1, 0, 0, 1],
  bodyDetailColor: [0, 1, 1, 0.5],
  constraintSleepingColorA: [0.7, 0.2, 0.2, 0.6],
  constraintSleepingColorB: [0.2, 0.2, 0.7, 0.6],
  constraintSleepingColorC: [0.2, 0.7, 0.2, 0.6],
  constraintSleepingColorD: [0.7, 0.2, 0.7, 0.6],
  constraintErrorSleepingColorA: [0.7, 0.7, 0.5, 0.6],
  constraintErrorSleepingColorB: [0.5, 0.7, 0.7, 0.6],
  constraintErrorSleepingColorC: [0.4, 0.7, 0.4, 0.6],
  constraintErrorSleepingColorD: [0.7, 0.4, 0.7, 0.6],
  staticContactColor: [0.5, 0, 1, 0.7],
  frictionImpulseColor: [0, 0, 1, 1],
  shapeDetailColor: [1, 1, 0, 0.5],
} as const;

describe('21 Debug drawing', () => {
  it('C-242 every property has its default', () => {
    const debug = recorder().debug as unknown as Record<string, unknown>;
    expect(Object.fromEntries(Object.keys(DEFAULTS).map((name) => [name, debug[name]]))).toEqual(DEFAULTS);
  });

  it('C-243 lines, rectangles and circles, all in the given colour', () => {
    const color = [0.25, 0.5, 0.75, 1];
    const line = draw((debug) => debug.drawLine(0, 0, 1, 2, color));
    const rectangle = draw((debug) => debug.drawRectangle(0, 0, 1, 2, color));
    const circle = draw((debug) => debug.drawCircle(0, 0, 0.001, color));
    expect(line).toHaveLength(1);
    expect(rectangle).toHaveLength(4);
    expect(circle.length).toBeGreaterThanOrEqual(3);
    for (const segment of [...line, ...rectangle, ...circle]) {
      expect(segment.color).toEqual(color);
    }
  });

  it('C-244 the scales of a screen of 600 × 600', () => {
    const { debug } = recorder(600, 600);
    debug.begin();
    near(debug.physics2DToScreen, 60);
    near(debug.screenToPhysics2D, 1 / 60);
  });

  it('C-245 a circle of 100 px has 36 segments', () => {
    expect(draw((debug) => debug.drawCircle(5, 5, 100 / 60, RED))).toHaveLength(36);
  });

  it('C-246 sensors, sleeping bullets and contacts can be drawn [D-06]', () => {
    const world = weightless();
    const bullet = plainBody({ bullet: true, velocity: [50, 0] });
    add(world, bullet, plainBody({ position: [0.5, 0.5] }), boxBody(1, 1, { position: [0.2, 0] }, { sensor: true }));
    add(
      world,
      staticBody({ shapes: [disc(3, { sensor: true })] }),
      staticBody({ position: [4, 0], shapes: [disc(1)] }),
    );
    const count = (): number =>
      draw((debug) => {
        debug.showContacts = true;
        debug.showContactImpulses = true;
        debug.showBodyDetail = true;
        debug.showShapeDetail = true;
        debug.drawWorld(world);
        debug.drawRigidBody(staticBody({ shapes: [disc(1)] }));
      }).length;
    steps(world, 3);
    expect(count()).toBeGreaterThan(100);
    bullet.sleep();
    expect(count()).toBeGreaterThan(100);
  });

  it('C-247 a custom constraint draws itself, a disabled one is not drawn, and nothing is if nothing is shown', () => {
    const world = weightless();
    const body = plainBody();
    add(world, body);
    const calls: unknown[] = [];
    const custom = phys2D.createCustomConstraint({
      dimension: 1,
      bodies: [body],
      stiff: false,
      jacobian() {},
      debugDraw(debug, stiff) {
        calls.push(debug, stiff);
      },
    });
    tie(world, custom);
    draw((debug) => {
      debug.drawWorld(world);
      expect(calls).toHaveLength(2);
      expect(calls[0]).toBe(debug);
      expect(calls[1]).toBe(false);
      custom.disable();
      debug.drawWorld(world);
      expect(calls).toHaveLength(2);
      custom.enable();
    });
    const nothing = draw((debug) => {
      debug.showRigidBodies = false;
      debug.showConstraints = false;
      debug.drawWorld(world);
    });
    expect(nothing).toEqual([]);
    expect(calls).toHaveLength(2);
  });
});
