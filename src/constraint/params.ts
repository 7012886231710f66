import type { UserDataOf } from '../user-data.js';
import { boolean, nonNegative, nonNegativeOrInfinite, options, positive } from '../validate.js';
import type { Constraint } from './constraint.js';

/** Options of every constraint that can be changed later with `configure`. */
export interface ConstraintConfig {
  /**
   * Rigid: errors are removed outright. `false`: a damped spring. Has no effect on motors, and on custom constraints without `position`.
   * Default `true`.
   */
  stiff?: boolean | undefined;
  /** With `stiff: false`: the frequency of the spring, Hz, > 0, whatever the masses. Default 10. */
  frequency?: number | undefined;
  /**
   * With `stiff: false`: the damping ratio, >= 0; at 1 the spring comes to rest without overshoot. The way it is solved adds damping of its
   * own, about 0.013 · `frequency` at 60 steps a second of four sub-steps each. Default 1.
   */
  damping?: number | undefined;
  /**
   * The largest force, N (for angle constraints and motors torque, N·m), >= 0, of constraints that are not stiff, and of motors. Has no
   * effect on a stiff one, unless it has `breakUnderForce`: any constraint with that breaks above it. For a weld, force and torque count
   * together: √(fx² + fy² + torque²). Default `Infinity`.
   */
  maxForce?: number | undefined;
  /**
   * With `breakUnderError`, the error above which the constraint breaks, m (for angles rad), >= 0. Otherwise, with `stiff: false`, the
   * largest speed at which it corrects an error, m/s (for angles rad/s). Default `Infinity`.
   */
  maxError?: number | undefined;
  /** Leaves the world when it breaks; `false`: it stays, disabled. Default `true`. */
  removeOnBreak?: boolean | undefined;
  /**
   * Breaks when its force exceeds `maxForce`: at once, or, if it does so only together with the part that turns a swinging body, which is
   * not known before the step is over, after three steps on end, or ten where more than four constraints are connected. Default `false`.
   */
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

/** The options given, all checked, so that nothing is changed if one is not valid. */
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
