import { createContext, Script } from 'node:vm';
import type { validate } from '../../src/audit/index.js';
import type { Physics2DDevice } from '../../src/index.js';
import { Stage } from './stage.js';
import { type Statement, textOf, Writer } from './writer.js';

export interface Engine {
  readonly phys2D: Physics2DDevice;
  readonly validate: typeof validate;
}

export interface Failure {
  readonly seed: number;
  readonly message: string;
  /** What is left when everything is taken out without which it fails as well. */
  readonly program: readonly Statement[];
}

const NAMES = '{ phys2D, utils, w, b, s, c, m, h, all, step, stop, few, bind, move, save, look }';

/** ms. A call that takes longer hangs. */
const TOO_LONG = 2000;

/** Runs a program. @returns how it fails, or `null`. */
export function run({ phys2D, validate }: Engine, program: readonly Statement[], limit = TOO_LONG): string | null {
  const stage = new Stage(phys2D, validate, limit);
  const lines = program.map((statement, i) => `stage.next(${i});\n${textOf(statement)}`);
  const code = `(() => { const ${NAMES} = stage;\n${lines.join('\n')}\nstage.next(${program.length}); })()`;
  try {
    new Script(code).runInContext(createContext({ stage, performance }), { timeout: 20 * limit });
    return null;
  } catch (error) {
    return error instanceof Error || Object.hasOwn(error as object, 'message')
      ? (error as Error).message
      : String(error);
  }
}

/** What makes two failures alike: not the numbers. */
export function kindOf(message: string): string {
  return message.replace(/-?\d+(?:\.\d+)?(?:e[+-]?\d+)?|-?Infinity|NaN/g, '#');
}

/** Takes out what is not needed for the failure: longer runs first, then statements, then those of handlers. */
export function shrink(engine: Engine, program: readonly Statement[], message: string): Statement[] {
  const kind = kindOf(message);
  const fails = (shorter: readonly Statement[]): boolean => {
    const failure = run(engine, shorter);
    return failure !== null && kindOf(failure) === kind;
  };
  let best = [...program];
  for (let size = Math.ceil(best.length / 2); size >= 1; size = size > 1 ? Math.floor(size / 2) : 0) {
    for (let at = best.length - size; at > -size; at -= size) {
      const shorter = [...best.slice(0, Math.max(0, at)), ...best.slice(at + size)];
      if (shorter.length < best.length && fails(shorter)) {
        best = shorter;
      }
    }
  }
  for (let at = best.length - 1; at >= 0; at -= 1) {
    for (let k = best[at]!.inner.length - 1; k >= 0; k -= 1) {
      const inner = best[at]!.inner.filter((_, i) => i !== k);
      const shorter = best.map((statement, i) => (i === at ? { ...statement, inner } : statement));
      if (fails(shorter)) {
        best = shorter;
      }
    }
  }
  return best;
}

/** Runs the program of a seed. @returns how it fails, shrunk unless that kind is known, or `null`. */
export function fuzz(engine: Engine, seed: number, length: number, isKnown = (_kind: string) => false): Failure | null {
  const program = new Writer(seed).write(length);
  const message = run(engine, program);
  if (message === null) {
    return null;
  }
  return { seed, message, program: isKnown(kindOf(message)) ? [] : shrink(engine, program, message) };
}

/** A failure as a test, to be put beside this file. */
export function testOf({ seed, message, program }: Failure): string {
  const lines = program.map((statement, i) => `  stage.next(${i});\n  ${textOf(statement)}`);
  return `// @ts-nocheck: ${message.replaceAll('\n', ' ')}
import { expect, it } from 'vitest';
import { validate } from '../../src/audit/index.js';
import { phys2D as device } from '../../src/index.js';
import { Stage } from './stage.js';

it('fuzz, seed ${seed}', () => {
  const stage = new Stage(device, validate, ${TOO_LONG});
  const ${NAMES} = stage;
${lines.join('\n')}
  stage.next(${program.length});
  expect(stage.at).toBe(${program.length});
});
`;
}
