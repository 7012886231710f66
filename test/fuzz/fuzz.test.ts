import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { describe, expect, it } from 'vitest';
import type * as audit from '../../src/audit/index.js';
import type * as source from '../../src/index.js';
import { type Engine, fuzz, run, shrink, testOf } from './fuzz.js';
import { textOf, Writer } from './writer.js';

// Random programs over the whole API, from the bundle as built, which is ten times as fast. `npm run fuzz` runs more of them.

const PROGRAMS = 300;
const LENGTH = 200;
/** Seeds that found something, once. */
const FOUND = [30214, 103960, 202255, 310353, 315360, 400776];

const dist = join(import.meta.dirname, '../../dist');
const load = (name: string): Promise<unknown> => import(/* @vite-ignore */ pathToFileURL(join(dist, name)).href);
const { phys2D } = (await load('phys2d.js')) as typeof source;
const { validate } = (await load('validate.js')) as typeof audit;
const engine: Engine = { phys2D, validate };

/** Public methods by class, from the published types; boxes, drawing and what saves have tests of their own. */
function publicMethods(): [name: string, method: string][] {
  const files = readdirSync(dist, { recursive: true, encoding: 'utf8' }).filter(
    (name) => name.endsWith('.d.ts') && !/^(?:debug|broadphase|runner|state)/.test(name),
  );
  return files.flatMap((file) =>
    readFileSync(join(dist, file), 'utf8')
      .split(/^export declare (?:abstract )?class /m)
      .slice(1)
      .flatMap((text) => {
        const methods = text.split(/^\}/m)[0]!.matchAll(/^ {4}(?:abstract )?(?!constructor|static|private)(\w+)[<(]/gm);
        return [...methods].map(([, method]): [string, string] => [/^\w+/.exec(text)![0], method!]);
      }),
  );
}

describe('random programs', () => {
  it(`${PROGRAMS} of ${LENGTH} calls`, () => {
    for (const seed of [...FOUND, ...Array.from({ length: PROGRAMS }, (_, i) => i + 1)]) {
      const failure = fuzz(engine, seed, LENGTH);
      expect(failure === null ? '' : testOf(failure)).toBe('');
    }
  }, 120_000);

  it('call every public method', () => {
    const programs = Array.from({ length: 100 }, (_, i) => new Writer(i).write(LENGTH).map(textOf).join('\n')).join(
      '\n',
    );
    const methods = publicMethods();
    // By `look`, `bind`, `save` and the stage itself.
    const looked =
      /^(?:get|is|compute)[A-Z]|^transform(?:World|Local)|^set(?:Lower|Upper)Bound$|^createCollisionUtils$|^hash$|^snapshot$|^restore$/;
    const isCalled = (method: string): boolean => new RegExp(`[.( ]${method}(?:\\?\\.)?\\(`).test(programs);
    expect(methods.length).toBeGreaterThan(150);
    expect(methods.filter(([, method]) => !looked.test(method) && !isCalled(method))).toEqual([]);
  });

  it('are the same for the same seed, and do something', () => {
    const [first, same, other] = [new Writer(5), new Writer(5), new Writer(6)].map((writer) => writer.write(LENGTH));
    expect(first).toEqual(same);
    expect(first).not.toEqual(other);
    let [arbiters, constraints, sleeping] = [0, 0, 0];
    const watch = (world: source.World): void => {
      arbiters += world.dynamicArbiters.length + world.staticArbiters.length;
      constraints += world.liveConstraints.length;
      sleeping += world.rigidBodies.filter((body) => body.isDynamic() && body.sleeping).length;
    };
    for (let seed = 1; seed <= 20; seed += 1) {
      run({ phys2D, validate: watch }, new Writer(seed).write(LENGTH));
    }
    expect(Math.min(arbiters, constraints, sleeping)).toBeGreaterThan(100);
  });
});

describe('a failure', () => {
  /** As if a world could not bear that a kinematic body leaves it and a constraint has come. */
  const strict: Engine = {
    phys2D,
    validate(world) {
      validate(world);
      if (world.constraints.length > 0 && world.rigidBodies.some((body) => body.isKinematic())) {
        throw new Error(`a constraint, and a kinematic body at ${world.rigidBodies.length}`);
      }
    },
  };
  const failure = [1, 2, 3, 4, 5].map((seed) => fuzz(strict, seed, LENGTH)).find((found) => found !== null)!;

  it('is shrunk to what it needs', () => {
    expect(failure.message).toMatch(/^a constraint, and a kinematic body at \d+$/);
    expect(run(strict, failure.program)).toMatch(/^a constraint, and a kinematic body at \d+$/);
    expect(failure.program.length).toBeLessThan(12);
    for (let i = 0; i < failure.program.length; i += 1) {
      expect(
        run(
          strict,
          failure.program.filter((_, k) => k !== i),
        ) ?? '',
      ).not.toMatch(/^a constraint, and a kin/);
    }
    expect(shrink(strict, failure.program, failure.message)).toEqual(failure.program);
  });

  it('is printed as a test that runs', () => {
    const text = testOf(failure);
    expect(text).toContain("from 'vitest'");
    for (const statement of failure.program) {
      expect(text).toContain(textOf(statement));
    }
  });

  it('is also an error that is thrown, and a call that takes too long', () => {
    const statement = (head: string) => [{ head, inner: [], tail: '' }];
    expect(run(engine, statement('phys2D.createCircleShape({ radius: -1 });'))).toContain('radius must be');
    expect(run(engine, statement('undefined.x;'))).toContain('undefined');
    expect(run(engine, statement('w[0] = phys2D.createWorld(); step(w[0], 1 / 60);'))).toBeNull();
    const loop = statement('for (const t = performance.now(); performance.now() - t < 200; );');
    expect(run(engine, loop, 20)).toBe('took longer than 20 ms');
    expect(run(engine, statement('for (;;);'), 20)).toContain('timed out');
  });
});
