import type { UserDataOf } from './user-data.js';
import { nonNegative, notNaN, optional, options } from './validate.js';

/** Options of `createMaterial`. */
export interface MaterialParams {
  /** Coefficient of restitution: any number, ±Infinity allowed. −Infinity forces "never bounces", +Infinity "bounces fully". Default 0. */
  elasticity?: number | undefined;
  /** Coefficient of friction while the surfaces stick, >= 0. Default 2. */
  staticFriction?: number | undefined;
  /** Coefficient of friction while they slide, >= 0. Default 1. */
  dynamicFriction?: number | undefined;
  /** Resistance of circles to rolling, m, >= 0. Default 0.005. */
  rollingFriction?: number | undefined;
  /** Mass per area, kg/m², >= 0. Default 1. */
  density?: number | undefined;
  /** Anything of yours. Default `null`. */
  userData?: UserDataOf<'material'> | undefined;
}

/** Whether any material of the program has had a negative elasticity, which may take away the bounce of another one; never reset. */
export const materials = { someDeaden: false };

/**
 * What a shape is made of. Immutable apart from `userData`; shapes may share one. At a contact, the elasticity is the mean of both, clamped
 * to 0 to 1 (0 if either is −Infinity, else 1 if either is +Infinity), and each friction is the geometric mean of both.
 */
export class Material {
  /** Of the class, as in Turbulenz. */
  static get version(): number {
    return 1;
  }

  /** Anything of yours. */
  userData: UserDataOf<'material'>;

  /** @internal */
  readonly elasticity: number;
  /** @internal */
  readonly staticFriction: number;
  /** @internal */
  readonly dynamicFriction: number;
  /** @internal */
  readonly rollingFriction: number;
  /** @internal */
  readonly density: number;
  /** @internal its index while the state of the world is walked over */
  stateIndex = 0;

  /** @internal use `createMaterial` */
  constructor(params: MaterialParams = {}) {
    const where = 'createMaterial';
    const given = options(where, params, false);
    // No result depends on the sign of a zero, and JSON has none: 0 + removes it.
    this.elasticity = 0 + notNaN(where, 'elasticity', optional(given.elasticity, 0));
    materials.someDeaden ||= this.elasticity < 0;
    this.staticFriction = 0 + nonNegative(where, 'staticFriction', optional(given.staticFriction, 2));
    this.dynamicFriction = 0 + nonNegative(where, 'dynamicFriction', optional(given.dynamicFriction, 1));
    this.rollingFriction = 0 + nonNegative(where, 'rollingFriction', optional(given.rollingFriction, 0.005));
    this.density = 0 + nonNegative(where, 'density', optional(given.density, 1));
    this.userData = given.userData === undefined ? null : given.userData;
  }

  /** As given to `createMaterial`. */
  getElasticity(): number {
    return this.elasticity;
  }

  /** As given to `createMaterial`. */
  getStaticFriction(): number {
    return this.staticFriction;
  }

  /** As given to `createMaterial`. */
  getDynamicFriction(): number {
    return this.dynamicFriction;
  }

  /** Rolling friction, m, as given to `createMaterial`. */
  getRollingFriction(): number {
    return this.rollingFriction;
  }

  /** The mass per area, kg/m², as given to `createMaterial`. */
  getDensity(): number {
    return this.density;
  }
}

/** The material of every shape made without one: all defaults, one object for the whole program. */
export const DEFAULT_MATERIAL = /* @__PURE__ */ new Material();

/** Elasticity of a contact: −Infinity on either side gives 0, else +Infinity gives 1, else the mean within [0, 1]. */
export function mixElasticity(a: number, b: number): number {
  if (a === -Infinity || b === -Infinity) {
    return 0;
  }
  const mean = (a + b) / 2;
  return mean < 0 ? 0 : mean > 1 ? 1 : mean;
}

/** Any friction coefficient of a contact: the geometric mean, finite even where the product overflows. */
export function mixFriction(a: number, b: number): number {
  const product = a * b;
  return product < Infinity ? Math.sqrt(product) : Math.sqrt(a) * Math.sqrt(b);
}
