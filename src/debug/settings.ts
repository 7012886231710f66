import { boolean, finite, nonNegative, positive, rangeError, vector } from '../validate.js';
import type { ColorLike } from './device.js';

/** A colour of the settings, `[r, g, b, a]`, each from 0 to 1. */
export type Color = [r: number, g: number, b: number, a: number];

const WHERE = 'Physics2DDebugDraw';

type Check = (where: string, name: string, value: never) => unknown;

/** Names, default values, and what else is allowed. */
const SETTINGS: readonly (readonly [check: Check, defaults: Readonly<Record<string, unknown>>])[] = [
  [
    boolean,
    {
      showRigidBodies: true,
      showColliderShapes: true,
      showSensorShapes: true,
      showBodyDetail: false,
      showShapeDetail: false,
      showConstraints: true,
      showContacts: false,
      showContactImpulses: false,
    },
  ],
  [positive, { circleMaxError: 0.4, curveMaxError: 0.6, spiralMaxArc: Math.PI / 4 }],
  [
    nonNegative,
    {
      spiralEpsilon: 1e-5,
      spiralSpringSize: 0.75,
      minSpringLength: 0.5,
      constraintAnchorRadius: 3,
      constraintSpringRadius: 3,
      constraintSpiralMinRadius: 10,
      constraintSpiralDeltaRadius: 2.5 / Math.PI,
      contactRadius: 3,
      bodyPositionRadius: 0.5,
      circleOriginRadius: 0.5,
    },
  ],
  [finite, { constraintSpringNumCoils: 3, constraintSpiralNumCoils: 4, contactImpulseScale: 30 }],
  [share, { interpolation: 1 }],
  [
    color,
    {
      constraintColorA: [1, 0, 0, 0.8],
      constraintColorB: [0, 0, 1, 0.8],
      constraintColorC: [0, 1, 0, 0.8],
      constraintColorD: [1, 0, 1, 0.8],
      constraintSleepingColorA: [0.7, 0.2, 0.2, 0.6],
      constraintSleepingColorB: [0.2, 0.2, 0.7, 0.6],
      constraintSleepingColorC: [0.2, 0.7, 0.2, 0.6],
      constraintSleepingColorD: [0.7, 0.2, 0.7, 0.6],
      constraintErrorColorA: [1, 1, 0.5, 0.8],
      constraintErrorColorB: [0.5, 1, 1, 0.8],
      constraintErrorColorC: [0.4, 1, 0.4, 0.8],
      constraintErrorColorD: [1, 0.4, 1, 0.8],
      constraintErrorSleepingColorA: [0.7, 0.7, 0.5, 0.6],
      constraintErrorSleepingColorB: [0.5, 0.7, 0.7, 0.6],
      constraintErrorSleepingColorC: [0.4, 0.7, 0.4, 0.6],
      constraintErrorSleepingColorD: [0.7, 0.4, 0.7, 0.6],
      dynamicContactColor: [1, 0, 0.5, 0.7],
      staticContactColor: [0.5, 0, 1, 0.7],
      normalImpulseColor: [1, 0, 0, 1],
      frictionImpulseColor: [0, 0, 1, 1],
      bodyDetailColor: [0, 1, 1, 0.5],
      shapeDetailColor: [1, 1, 0, 0.5],
    },
  ],
];

/** What `Physics2DDebugDraw` shows, and how. Every property may be set at any time; a bad value is refused, a colour is copied. */
export abstract class DebugSettings {
  /** In `drawWorld`. Default `true`. */
  declare showRigidBodies: boolean;
  /** Default `true`. */
  declare showColliderShapes: boolean;
  /** Default `true`. */
  declare showSensorShapes: boolean;
  /** The origin of each body, and a line from where it was before the last step. Default `false`. */
  declare showBodyDetail: boolean;
  /** World bounds of each shape, and origins of circles. Default `false`. */
  declare showShapeDetail: boolean;
  /** In `drawWorld`, those that are enabled. Default `true`. */
  declare showConstraints: boolean;
  /** In `drawWorld`. Default `false`. */
  declare showContacts: boolean;
  /** With `showContacts`. Default `false`. */
  declare showContactImpulses: boolean;

  /**
   * Share of the last step, 0 to 1, that has passed in the picture: bodies and constraints are drawn between their placements before and after it.
   * `FixedStepRunner.interpolation` is made for it. Default 1: the present placements.
   */
  declare interpolation: number;

  /** px, > 0. Largest distance of chord and circle. Default 0.4. */
  declare circleMaxError: number;
  /** px, > 0. Largest distance of chord and curve. Default 0.6. */
  declare curveMaxError: number;
  /** rad, > 0. Longest piece of a spiral. Default π/4. */
  declare spiralMaxArc: number;
  /** A piece of a spiral is straight if the sine of what it turns by is below this. Default 1e-5. */
  declare spiralEpsilon: number;
  /** Amplitude of a spiral spring as a part of the gap between the arms of its spiral. Default 0.75. */
  declare spiralSpringSize: number;
  /** px. Shorter linear springs become a line. Default 0.5. */
  declare minSpringLength: number;

  /** px. Default 3. */
  declare constraintAnchorRadius: number;
  /** px. Default 3. */
  declare constraintSpringRadius: number;
  /** Default 3; a line if <= 0. */
  declare constraintSpringNumCoils: number;
  /** px. Default 10. */
  declare constraintSpiralMinRadius: number;
  /** px per rad. Default 2.5/π. */
  declare constraintSpiralDeltaRadius: number;
  /** Default 4; a spiral if <= 0. */
  declare constraintSpiralNumCoils: number;
  /** px. Default 3. */
  declare contactRadius: number;
  /** px per N·s. Default 30. */
  declare contactImpulseScale: number;
  /** px. Default 0.5. */
  declare bodyPositionRadius: number;
  /** px. Default 0.5. */
  declare circleOriginRadius: number;

  /** Anchor of body A. */
  declare constraintColorA: Color;
  /** Anchor of body B. */
  declare constraintColorB: Color;
  /** Anchor of body C. */
  declare constraintColorC: Color;
  /** Anchor of body D. */
  declare constraintColorD: Color;
  /** Anchor of body A, of a constraint that sleeps. */
  declare constraintSleepingColorA: Color;
  /** Anchor of body B, of a constraint that sleeps. */
  declare constraintSleepingColorB: Color;
  /** Anchor of body C, of a constraint that sleeps. */
  declare constraintSleepingColorC: Color;
  /** Anchor of body D, of a constraint that sleeps. */
  declare constraintSleepingColorD: Color;
  /** Lower bounds; what concerns body A. */
  declare constraintErrorColorA: Color;
  /** Upper bounds; what concerns body B. */
  declare constraintErrorColorB: Color;
  /** What a point, weld or line constraint is off by; the lower bound of the second link of a pulley. */
  declare constraintErrorColorC: Color;
  /** The upper bound of the second link of a pulley. */
  declare constraintErrorColorD: Color;
  /** As `constraintErrorColorA`, of a constraint that sleeps. */
  declare constraintErrorSleepingColorA: Color;
  /** As `constraintErrorColorB`, of a constraint that sleeps. */
  declare constraintErrorSleepingColorB: Color;
  /** As `constraintErrorColorC`, of a constraint that sleeps. */
  declare constraintErrorSleepingColorC: Color;
  /** As `constraintErrorColorD`, of a constraint that sleeps. */
  declare constraintErrorSleepingColorD: Color;
  /** Contacts of two dynamic bodies. */
  declare dynamicContactColor: Color;
  /** Contacts with a static or kinematic body. */
  declare staticContactColor: Color;
  /** What pushes two shapes apart, if `showContactImpulses`. */
  declare normalImpulseColor: Color;
  /** What slows their sliding, if `showContactImpulses`. */
  declare frictionImpulseColor: Color;
  /** Of what `showBodyDetail` shows. */
  declare bodyDetailColor: Color;
  /** Of what `showShapeDetail` shows. */
  declare shapeDetailColor: Color;

  private readonly settings: Record<string, unknown> = {};

  /** @internal */
  constructor() {
    for (const [check, defaults] of SETTINGS) {
      for (const name of Object.keys(defaults)) {
        this.settings[name] = check(WHERE, name, defaults[name] as never);
      }
    }
  }

  /** The same as `showSensorShapes`, as the original spelt it. */
  get showSensorsShapes(): boolean {
    return this.showSensorShapes;
  }

  set showSensorsShapes(show: boolean) {
    this.settings.showSensorShapes = boolean(WHERE, 'showSensorsShapes', show);
  }

  static {
    for (const [check, defaults] of SETTINGS) {
      for (const name of Object.keys(defaults)) {
        Object.defineProperty(DebugSettings.prototype, name, {
          get(this: DebugSettings): unknown {
            return this.settings[name];
          },
          set(this: DebugSettings, value: never) {
            this.settings[name] = check(WHERE, name, value);
          },
        });
      }
    }
  }
}

function share(where: string, name: string, value: unknown): unknown {
  if (!isShare(finite(where, name, value))) {
    throw rangeError(where, name, 'a number from 0 to 1', value);
  }
  return value;
}

/** A copy of a colour. */
function color(where: string, name: string, value: ColorLike): Color {
  const [r, g, b, a] = checkedColor(where, name, value) as Color;
  return [r, g, b, a];
}

/** @internal */
export function checkedColor(where: string, name: string, value: ColorLike): ColorLike {
  if (!isColor(value)) {
    vector(where, name, value, 4);
    const wrong = Array.from(value).findIndex((part) => !isShare(part));
    throw rangeError(where, `${name}[${wrong}]`, 'a number from 0 to 1', value[wrong]);
  }
  return value;
}

/** The usual case of the checks, without the names that they would put together for a message. */
function isColor(value: ColorLike): boolean {
  return (
    typeof value === 'object' &&
    value !== null &&
    value.length >= 4 &&
    isShare(value[0]) &&
    isShare(value[1]) &&
    isShare(value[2]) &&
    isShare(value[3])
  );
}

function isShare(value: unknown): boolean {
  return typeof value === 'number' && value >= 0 && value <= 1;
}
