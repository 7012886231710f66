import type { UserDataOf } from '../user-data.js';
import { boolean, nonNegative, nonNegativeOrInfinite, options, positive } from '../validate.js';
import type { Constraint } from './constraint.js';

/** Options of every constraint that can be changed later with `configure`. */
export interface ConstraintConfig {
  /** Rigid: errors are removed outright. `false`: a damped spring. Default `true`. */
  stiff?: boolean | undefined;
  /** Of the spring, Hz, > 0, whatever the masses. Default 10. */
  frequency?: number | undefined;
  /** Damping ratio of the spring, >= 0; 1 is critical. Default 1. */
  damping?: number | undefined;
  /** N (N·m for angles), >= 0: limits the force of elastic and velocity-only constraints, breaks any if `breakUnderForce`. Default `Infinity`. */
  maxForce?: number | undefined;
  /** m (rad for angles), >= 0: breaks if `breakUnderError`; else the largest correcting speed of an elastic constraint. Default `Infinity`. */
  maxError?: number | undefined;
  /** Leaves the world when it breaks; `false`: stays, disabled. Default `true`. */
  removeOnBreak?: boolean | undefined;
  /** Breaks when its force exceeds `maxForce`. Default `false`. */
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
