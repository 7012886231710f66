import { describe, expect, it } from 'vitest';
import { Physics2DDebugDraw } from '../../src/debug/index.js';
import { NOT_BOOLEAN, NOT_FINITE, NOT_NON_NEGATIVE, NOT_POSITIVE, NOT_VECTOR, refuses } from '../bad-input/refuses.js';
import { recorder } from './recorder.js';

type Settings = Record<string, unknown>;

const BOOLEANS = [
  'showRigidBodies',
  'showColliderShapes',
  'showSensorShapes',
  'showSensorsShapes',
  'showBodyDetail',
  'showShapeDetail',
  'showConstraints',
  'showContacts',
  'showContactImpulses',
];
const POSITIVE = ['circleMaxError', 'curveMaxError', 'spiralMaxArc'];
const NON_NEGATIVE = [
  'spiralEpsilon',
  'spiralSpringSize',
  'minSpringLength',
  'constraintAnchorRadius',
  'constraintSpringRadius',
  'constraintSpiralMinRadius',
  'constraintSpiralDeltaRadius',
  'contactRadius',
  'bodyPositionRadius',
  'circleOriginRadius',
];
const FINITE = ['constraintSpringNumCoils', 'constraintSpiralNumCoils', 'contactImpulseScale'];
const COLORS = ['constraintColorA', 'constraintErrorSleepingColorD', 'bodyDetailColor'];

describe('settings', () => {
  it.each([
    ...BOOLEANS.map((name) => [name, NOT_BOOLEAN, false] as const),
    ...POSITIVE.map((name) => [name, NOT_POSITIVE, 3] as const),
    ...NON_NEGATIVE.map((name) => [name, NOT_NON_NEGATIVE, 0] as const),
    ...FINITE.map((name) => [name, NOT_FINITE, -2.5] as const),
    ['interpolation', [...NOT_FINITE, [-0.1, RangeError], [1.1, RangeError]], 0.25] as const,
    ...COLORS.map((name) => [name, NOT_VECTOR, [0, 0.5, 1, 0.25]] as const),
  ])('%s refuses bad values and takes good ones', (name, bads, good) => {
    const debug = recorder().debug as unknown as Settings;
    const before = debug[name];
    for (const bad of bads) {
      refuses(
        (value) => {
          debug[name] = value;
        },
        'Physics2DDebugDraw',
        name,
        bad,
      );
      expect(debug[name]).toEqual(before);
    }
    debug[name] = good;
    expect(debug[name]).toEqual(good);
  });

  it('colours outside of 0 to 1 are refused', () => {
    const { debug } = recorder();
    const set = (color: unknown) => () => {
      debug.shapeDetailColor = color as never;
    };
    refuses(set([0, 0, 2, 1]), 'Physics2DDebugDraw', 'shapeDetailColor[2]', [2, RangeError]);
    refuses(set([0, 0, 1, -1]), 'Physics2DDebugDraw', 'shapeDetailColor[3]', [-1, RangeError]);
    expect(debug.shapeDetailColor).toEqual([1, 1, 0, 0.5]);
  });

  it('a colour is copied, and belongs to one object', () => {
    const { debug } = recorder();
    const color: [number, number, number, number] = [0, 0, 0, 1];
    debug.constraintColorA = color;
    color[0] = 1;
    expect(debug.constraintColorA).toEqual([0, 0, 0, 1]);
    debug.constraintColorB[0] = 0.5;
    expect(recorder().debug.constraintColorB).toEqual([0, 0, 1, 0.8]);
  });

  it('showSensorShapes and showSensorsShapes are one', () => {
    const { debug } = recorder();
    debug.showSensorShapes = false;
    expect(debug.showSensorsShapes).toBe(false);
    debug.showSensorsShapes = true;
    expect(debug.showSensorShapes).toBe(true);
  });

  it('the scales can not be set', () => {
    const debug = recorder().debug as unknown as Settings;
    expect(() => {
      debug.physics2DToScreen = 1;
    }).toThrow(TypeError);
    expect(() => {
      debug.screenToPhysics2D = 1;
    }).toThrow(TypeError);
  });

  it('the version is 1', () => {
    expect(Physics2DDebugDraw.version).toBe(1);
  });
});
