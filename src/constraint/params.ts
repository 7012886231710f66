import type { UserDataOf } from '../user-data.js';
import { boolean, nonNegative, nonNegativeOrInfinite, options, positive } from '../validate.js';
import type { Constraint } from './constraint.js';

/** Options of every constraint that can be changed later with `configure`. */
export interface ConstraintConfig {
  /** Rigid: errors are removed outright. `false`: a damped spring. Without effect on motors, and on custom constraints without `position`. Default `true`. */
  stiff?: boolean | undefined;
  /** With `stiff: false`: how fast the spring swings, Hz, > 0, whatever the masses. Default 10. */
  frequency?: number | undefined;
  /** With `stiff: false`: the damping ratio, >= 0; at 1 the spring comes to rest without swinging over. How it is solved damps a spring of its own accord, by about 0.013 · `frequency` at 60 steps of four sub-steps in a second. Default 1. */
  damping?: number | undefined;
  /**
   * The largest force, N (for angles and motors torque, N·m), >= 0, of constraints that are not stiff, and of motors. A stiff one takes no notice, unless it
   * has `breakUnderForce`: any constraint that has breaks above it. Of a weld it is the length of both together, √(fx² + fy² + torque²). Default `Infinity`.
   */
  maxForce?: number | undefined;
  /** With `breakUnderError` the error above which the constraint breaks, m (for angles rad), >= 0. Else, with `stiff: false`, the largest speed at which it corrects one, m/s (for angles rad/s). Default `Infinity`. */
  maxError?: number | undefined;
  /** Leaves the world when it breaks; `false`: stays, disabled. Default `true`. */
  removeOnBreak?: boolean | undefined;
  /** Breaks when its force exceeds `maxForce`: at once, or, as far as it is what turns a swinging body, after three steps on end, or ten where more than four hang together, as that is not known before. Default `false`. */
  breakUnderForce?: boolean | undefined;
  /** Breaks when its error exceeds `maxError`. Default `false`. */
  breakUnderError?: boolean | undefined;
  /** Its bodies do not interact with each other. Default `false`. */
  ignoreInteractions?: boolean | undefined;
}

/** Options of every constraint. */
export interface ConstraintParams extends ConstraintConfig {
  /** Stays asleep when added to a world. Default `false`. */
  sleeping?: boolean | undefined;
  /** Does nothing until enabled. Default `false`. */
  disabled?: boolean | undefined;
  /** Anything of yours. Default `null`. */
  userData?: UserDataOf<'constraint'> | undefined;
}

/** The options that are given, checked; nothing is changed before all are. */
export function checkedConfig(where: string, params: ConstraintConfig): Partial<Constraint> {
  const given = options(where, params, true);
  const checked: Partial<Constraint> = {};
  for (const name of ['stiff', 'removeOnBreak', 'breakUnderForce', 'breakUnderError', 'ignoreInteractions'] as const) {
    if (given[name] !== undefined) checked[name] = boolean(where, name, given[name]);
  }
  if (given.frequency !== undefined) checked.frequency = positive(where, 'frequency', given.frequency);
  if (given.damping !== undefined) checked.damping = nonNegative(where, 'damping', given.damping);
  if (given.maxForce !== undefined) checked.maxForce = nonNegativeOrInfinite(where, 'maxForce', given.maxForce);
  if (given.maxError !== undefined) checked.maxError = nonNegativeOrInfinite(where, 'maxError', given.maxError);
  return checked;
}
