/**
 * The checks at the public edge and their messages. Every message names the function, the argument, the rule and the
 * value received: `createCircleShape: radius must be a finite number > 0, got -3`. A check never changes anything.
 *
 * Wrong kind of thing: `TypeError`. Right kind, value out of range: `RangeError`.
 */

import { FAR } from './config.js';
import type { Ray } from './math/vectors.js';

/** The class of an object, if its name says something: names of one or two letters are from minifiers, and some bundlers put `_` before names. */
function classOf(value: object): string {
  const name: unknown = Object.getPrototypeOf(value)?.constructor?.name;
  const isTelling = typeof name === 'string' && name.length > 2 && name !== 'Object';
  return isTelling ? ` of class ${name.replace('_', '').slice(0, 40)}` : '';
}

/** A value as it appears in a message: short, and without ever throwing. */
function show(value: unknown): string {
  if (typeof value === 'string') {
    return JSON.stringify(value.length > 40 ? `${value.slice(0, 40)}…` : value);
  }
  if (typeof value === 'function') {
    return 'a function';
  }
  if (Array.isArray(value)) {
    return `an array of length ${value.length}`;
  }
  if (typeof value === 'object' && value !== null) {
    return `an object${classOf(value)}`;
  }
  return String(value);
}

/** The error for a value of the wrong kind. */
export function typeError(where: string, name: string, rule: string, value: unknown): TypeError {
  return new TypeError(`${where}: ${name} must be ${rule}, got ${show(value)}`);
}

/** The error for a value of the right kind that is out of range. */
export function rangeError(where: string, name: string, rule: string, value: unknown): RangeError {
  return new RangeError(`${where}: ${name} must be ${rule}, got ${show(value)}`);
}

/** The error for what should be a number within some range. */
function noNumber(where: string, name: string, rule: string, value: unknown): Error {
  return (typeof value === 'number' ? rangeError : typeError)(where, name, rule, value);
}

/** Any finite number. */
export function finite(where: string, name: string, value: unknown): number {
  if (!(typeof value === 'number' && Number.isFinite(value))) {
    throw noNumber(where, name, 'a finite number', value);
  }
  return value;
}

/** A number that may be infinite, but not NaN. */
export function notNaN(where: string, name: string, value: unknown): number {
  if (!(typeof value === 'number' && !Number.isNaN(value))) {
    throw noNumber(where, name, 'a number, not NaN', value);
  }
  return value;
}

/** A finite number > 0. */
export function positive(where: string, name: string, value: unknown): number {
  if (!(typeof value === 'number' && value > 0 && value < Infinity)) {
    throw noNumber(where, name, 'a finite number > 0', value);
  }
  return value;
}

/** A number > 0, `Infinity` included. */
export function positiveOrInfinite(where: string, name: string, value: unknown): number {
  if (!(typeof value === 'number' && value > 0)) {
    throw noNumber(where, name, 'a number > 0', value);
  }
  return value;
}

/** A finite number >= 0. */
export function nonNegative(where: string, name: string, value: unknown): number {
  if (!(typeof value === 'number' && value >= 0 && value < Infinity)) {
    throw noNumber(where, name, 'a finite number >= 0', value);
  }
  return value;
}

/** A number >= 0, `Infinity` included. */
export function nonNegativeOrInfinite(where: string, name: string, value: unknown): number {
  if (!(typeof value === 'number' && value >= 0)) {
    throw noNumber(where, name, 'a number >= 0', value);
  }
  return value;
}

/** An integer from `least` to 1e9: snapshots and arrays have no room for more. */
export function integer(where: string, name: string, value: unknown, least: number): number {
  if (!(typeof value === 'number' && Number.isInteger(value) && value >= least && value <= 1e9)) {
    throw noNumber(where, name, `an integer from ${least} to 1e9`, value);
  }
  return value;
}

/** A set of 32 bits given as a number: any integer from -2^31 to 2^32 - 1; returned as an unsigned integer. */
export function bits(where: string, name: string, value: unknown): number {
  if (!(typeof value === 'number' && Number.isInteger(value) && value >= -0x80000000 && value <= 0xffffffff)) {
    throw noNumber(where, name, 'an integer of 32 bits', value);
  }
  return value >>> 0;
}

/** `true` or `false`. */
export function boolean(where: string, name: string, value: unknown): boolean {
  if (typeof value !== 'boolean') {
    throw typeError(where, name, 'a boolean', value);
  }
  return value;
}

/** A finite number of magnitude `most` or less. */
export function within(where: string, name: string, value: unknown, most: number): number {
  const n = finite(where, name, value);
  if (Math.abs(n) > most) {
    throw rangeError(where, name, `a number of at most ${most}`, n);
  }
  return n;
}

/** Whether it is an object of length `count` or more. */
function isList(value: unknown, count: number): value is ArrayLike<unknown> {
  return typeof value === 'object' && value !== null && (value as ArrayLike<unknown>).length >= count;
}

/**
 * Whether `vector` accepts it. Asked first where it is called for every corner, as composing the names for messages would cost more than
 * all else.
 */
export function isVector(value: unknown, count: number, most: number): value is ArrayLike<number> {
  if (!isList(value, count)) {
    return false;
  }
  for (let i = 0; i < count; i += 1) {
    const n = value[i];
    if (typeof n !== 'number' || !(Math.abs(n) <= most)) {
      return false;
    }
  }
  return true;
}

/** `count` finite numbers of magnitude `most` or less, at the indices 0 … count − 1. */
export function vector(
  where: string,
  name: string,
  value: unknown,
  count: number,
  most = Number.MAX_VALUE,
): ArrayLike<number> {
  if (isVector(value, count, most)) {
    return value;
  }
  if (!isList(value, count)) {
    throw typeError(where, name, `${count} finite numbers${count === 2 ? ' [x, y]' : ''}`, value);
  }
  for (let i = 0; i < count; i += 1) {
    within(where, `${name}[${i}]`, value[i], most);
  }
  return value as ArrayLike<number>;
}

/** `count` numbers, which may be infinite, at the indices 0 … count − 1. */
export function numbers(where: string, name: string, value: unknown, count: number): void {
  if (!isList(value, count)) {
    throw typeError(where, name, `${count} numbers`, value);
  }
  for (let i = 0; i < count; i += 1) {
    notNaN(where, `${name}[${i}]`, value[i]);
  }
}

/** A ray: a finite origin, a finite direction other than zero, and its length `maxFactor`, which may be `Infinity`. */
export function checkedRay(where: string, ray: unknown): Ray {
  if (typeof ray !== 'object' || ray === null) {
    throw typeError(where, 'ray', 'a ray { origin, direction, maxFactor }', ray);
  }
  const { origin, direction, maxFactor } = ray as Ray;
  vector(where, 'ray.origin', origin, 2);
  vector(where, 'ray.direction', direction, 2);
  if (direction[0] === 0 && direction[1] === 0) {
    throw rangeError(where, 'ray.direction', 'other than [0, 0]', direction);
  }
  nonNegativeOrInfinite(where, 'ray.maxFactor', maxFactor);
  return ray as Ray;
}

/** Blames an argument if the results it leads to are not all of magnitude 1e150 or less. */
export function leadsTo(
  where: string,
  name: string,
  value: unknown,
  what: string,
  ...results: readonly number[]
): void {
  if (!results.every((result) => Math.abs(result) <= FAR)) {
    throw rangeError(where, name, `one that leads to ${what} of at most ${FAR}`, value);
  }
}

/** Whether `count` numbers can be written to it: an array grows, a typed one does not. What is read-only shows when it is written to. */
export function holdsNumbers(value: unknown, count: number): boolean {
  return (
    typeof value === 'object' &&
    value !== null &&
    !(ArrayBuffer.isView(value) && !((value as unknown as ArrayLike<number>).length >= count))
  );
}

/** The error for a bad destination of `count` numbers. */
export function noSink(where: string, name: string, value: unknown, count: number): TypeError {
  return typeError(where, name, `an array to write ${count} numbers into`, value);
}

/** A destination for `count` numbers: anything with writable indices. */
export function sink(where: string, name: string, value: unknown, count: number): void {
  if (!holdsNumbers(value, count) || Object.isFrozen(value) || isShut(value as ArrayLike<unknown>, count)) {
    throw noSink(where, name, value, count);
  }
}

/** Whether it cannot grow to hold `count` numbers, or holds integers of another type. */
function isShut(value: ArrayLike<unknown>, count: number): boolean {
  return typeof value[0] === 'bigint' || (!Object.isExtensible(value) && !(value.length >= count));
}

/** A destination for objects: an array, or anything else with writable indices. */
export function list(where: string, name: string, value: unknown): void {
  if (typeof value !== 'object' || value === null || ArrayBuffer.isView(value) || !Object.isExtensible(value)) {
    throw typeError(where, name, 'an array to write into', value);
  }
}

/** The value of an option, or its default if it is left out or `undefined`. `null` is a value like any other, and mostly a wrong one. */
export function optional<T>(value: T | undefined, fallback: T): T {
  return value === undefined ? fallback : value;
}

/** The options object of a factory; `undefined` counts as "no options" unless the factory needs one. */
export function options<T extends object>(
  where: string,
  value: T | undefined,
  required: boolean,
  name = 'params',
): Partial<T> {
  if (value === undefined && !required) {
    return {};
  }
  if (typeof value !== 'object' || value === null || Array.isArray(value)) {
    throw typeError(where, name, 'an object of options', value);
  }
  return value;
}

/** An object of a class; `rule` names it in the message. */
export function instance<T>(
  where: string,
  name: string,
  value: unknown,
  kind: abstract new (...args: never[]) => T,
  rule: string,
): T {
  if (!(value instanceof kind)) {
    throw typeError(where, name, rule, value);
  }
  return value;
}

/** A function. */
export function callable(where: string, name: string, value: unknown): void {
  if (typeof value !== 'function') {
    throw typeError(where, name, 'a function', value);
  }
}

/** The `callback` of a query; `null` without one. */
export function callbackOf<T>(where: string, callback: T | undefined): T | null {
  if (callback === undefined) {
    return null;
  }
  callable(where, 'callback', callback);
  return callback;
}
