import { boolean, finite, nonNegative, positive, rangeError, vector } from '../validate.js';
import type { ColorLike } from './device.js';

/** A colour of the settings, `[r, g, b, a]`, each from 0 to 1. */
export type Color = [r: number, g: number, b: number, a: number];

const WHERE = 'Physics2DDebugDraw';

type Check = (where: string, name: string, value: never) => unknown;

/** Settings by their check: names and default values. */
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

/** What `Physics2DDebugDraw` shows, and how. Every property may be set at any time; a bad value throws, a colour is copied. */
export abstract class DebugSettings {
  /** `drawWorld` shows bodies. Default `true`. */
  declare showRigidBodies: boolean;
  /** Shows the shapes that are no sensors. Default `true`. */
  declare showColliderShapes: boolean;
  /** Shows the sensors. Default `true`. */
  declare showSensorShapes: boolean;
  /** Shows the origin of each body, and a line from where it was before the last step. Default `false`. */
  declare showBodyDetail: boolean;
  /** Shows the world bounds of each shape, and the origins of circles. Default `false`. */
  declare showShapeDetail: boolean;
  /** `drawWorld` shows the constraints that are enabled. Default `true`. */
  declare showConstraints: boolean;
  /** `drawWorld` shows contacts. Default `false`. */
  declare showContacts: boolean;
  /** Shows the impulses of contacts, if `showContacts` is set. Default `false`. */
  declare showContactImpulses: boolean;

  /**
   * Share of the last step, 0 to 1, that has passed in the picture: bodies and constraints are drawn between their placements before and
   * after it. `FixedStepRunner.interpolation` gives this number. Default 1: the present placements.
   */
  declare interpolation: number;

  /** px, > 0. Largest distance between a circle and its chords. Default 0.4. */
  declare circleMaxError: number;
  /** px, > 0. Largest distance between a curve and its chords. Default 0.6. */
  declare curveMaxError: number;
  /** rad, > 0. Longest piece of a spiral. Default π/4. */
  declare spiralMaxArc: number;
  /** A piece of a spiral is drawn straight if the sine of the angle that it turns by is below this. Default 1e-5. */
  declare spiralEpsilon: number;
  /** Amplitude of a spiral spring, as a share of the gap between the arms of its spiral. Default 0.75. */
  declare spiralSpringSize: number;
  /** px. Shorter linear springs are drawn as a line. Default 0.5. */
  declare minSpringLength: number;

  /** px. Radius of anchors. Default 3. */
  declare constraintAnchorRadius: number;
  /** px. Amplitude of the springs of soft constraints. Default 3. */
  declare constraintSpringRadius: number;
  /** Coils of the spring of a soft constraint. Default 3; a line if <= 0. */
  declare constraintSpringNumCoils: number;
  /** px. Radius of the spiral on which angles are shown, where it begins. Default 10. */
  declare constraintSpiralMinRadius: number;
  /** px per rad. By how much the radius of that spiral grows. Default 2.5/π. */
  declare constraintSpiralDeltaRadius: number;
  /** Coils of the spring on that spiral. Default 4; a plain spiral if <= 0. */
  declare constraintSpiralNumCoils: number;
  /** px. Radius of contacts. Default 3. */
  declare contactRadius: number;
  /** px per N·s. Length at which impulses of contacts are shown. Default 30. */
  declare contactImpulseScale: number;
  /** px. Radius of the origins of bodies. Default 0.5. */
  declare bodyPositionRadius: number;
  /** px. Radius of the origins of circles. Default 0.5. */
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
  /** Lower bounds; and what else is shown for body A. */
  declare constraintErrorColorA: Color;
  /** Upper bounds; and what else is shown for body B. */
  declare constraintErrorColorB: Color;
  /** The error of a point, weld or line constraint; the lower bound of the second link of a pulley. */
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
  /** The normal impulses of contacts, if `showContactImpulses` is set. */
  declare normalImpulseColor: Color;
  /** The friction impulses of contacts, if `showContactImpulses` is set. */
  declare frictionImpulseColor: Color;
  /** What `showBodyDetail` shows. */
  declare bodyDetailColor: Color;
  /** What `showShapeDetail` shows. */
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

  /** The same as `showSensorShapes`, in the spelling of the original. */
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

/** The usual case of the checks, without building the names for a message. */
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
