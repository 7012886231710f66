import { readdirSync, readFileSync } from 'node:fs';
import { join, posix } from 'node:path';
import { describe, expect, it } from 'vitest';

// The rules of the house, read off the source text: reproducible arithmetic, imports that run downward, no `any`, short files.

/** Path below `src` → source text. */
type House = ReadonlyMap<string, string>;

/** From the ground up. A value import may point to its own layer or a lower one; a type-only import anywhere. */
const LAYERS: readonly (readonly string[])[] = [
  ['config', 'validate', 'listeners', 'user'],
  ['math'],
  ['geometry'],
  ['material', 'shape'],
  ['body'],
  ['broadphase', 'collide'],
  ['contact'],
  ['events', 'profile'],
  ['constraint'],
  ['solver'],
  ['query', 'debug', 'outline', 'runner', 'audit', 'state'],
  ['kernels', 'simd'],
  ['world'],
  ['create'],
  ['device'],
  ['index'],
  ['umd'],
];

/** What of `Math` every engine rounds alike. All the rest is left to the engine, so it is forbidden unless named here. */
const EXACT = new Set(
  'abs ceil clz32 floor fround imul max min round sign sqrt trunc E LN10 LN2 LOG10E LOG2E PI SQRT1_2 SQRT2'.split(' '),
);

const MAX_LINES = 500;

/** The source with comments, regular expressions and (unless kept) the text of strings blanked out; lines stay. */
function strip(source: string, keepStrings = false): string {
  const comment = /\/\/[^\n]*|\/\*[\s\S]*?\*\//y;
  const string = /'(?:\\[\s\S]|[^'\\])*'|"(?:\\[\s\S]|[^"\\])*"/y;
  const template = /(?:\\[\s\S]|\$(?!\{)|[^`\\$])*(`|\$\{)/y;
  const regex = /\/(?:\\.|\[(?:\\.|[^\]\\\n])*\]|[^/\\\n[*])(?:\\.|\[(?:\\.|[^\]\\\n])*\]|[^/\\\n[])*\/[a-z]*/y;
  const blank = (text: string): string => text.replace(/[^\n]/g, ' ');
  /** Braces open inside each `${` that we are in. */
  const holes: number[] = [];
  /** The last characters of code: they tell a division from a regular expression. */
  let tail = '';
  let out = '';
  let at = 0;
  const match = (pattern: RegExp): string | null => {
    pattern.lastIndex = at;
    const found = pattern.exec(source)?.[0] ?? null;
    at += found?.length ?? 0;
    return found;
  };
  const templateText = (): void => {
    const text = match(template) ?? '';
    const opensHole = text.endsWith('${');
    if (opensHole) {
      holes.push(0);
    }
    tail = opensHole ? '' : ')';
    out += keepStrings ? text : blank(text);
  };
  while (at < source.length) {
    const char = source[at]!;
    const mayStartRegex = /(?:^|[^\w)\]}$]|\breturn)$/.test(tail);
    const skipped = char === '/' ? (match(comment) ?? (mayStartRegex ? match(regex) : null)) : null;
    const text = char === "'" || char === '"' ? match(string) : null;
    if (skipped !== null) {
      out += blank(skipped);
    } else if (text !== null) {
      out += keepStrings ? text : `'${blank(text.slice(2))}'`;
      tail = ')';
    } else {
      at += 1;
      out += char;
      tail = char.trim() === '' ? tail : (tail + char).slice(-8);
      if (char === '`') {
        templateText();
      } else if (holes.length > 0 && char === '{') {
        holes[holes.length - 1]! += 1;
      } else if (holes.length > 0 && char === '}' && holes[holes.length - 1]!-- === 0) {
        holes.pop();
        templateText();
      }
    }
  }
  return out;
}

function lineOf(text: string, index: number): number {
  return text.slice(0, index).split('\n').length;
}

function imports(source: string): { target: string; typeOnly: boolean }[] {
  const pattern =
    /^[ \t]*(?:import|export)\s+(type\s+)?(?:[\w$*{},\s]+?\sfrom\s+)?['"]([^'"\n]+)['"]|\bimport\(\s*['"]([^'"\n]+)/gm;
  return [...strip(source, true).matchAll(pattern)].map((found) => ({
    target: found[2] ?? found[3]!,
    typeOnly: found[1] !== undefined,
  }));
}

/** The files that a file imports values from. */
function valueImports(house: House, file: string): string[] {
  return imports(house.get(file)!)
    .filter(({ target, typeOnly }) => target.startsWith('.') && !typeOnly)
    .map(({ target }) => posix.join(posix.dirname(file), target).replace(/\.js$/, '.ts'));
}

function unreproducible(house: House): string[] {
  const found: string[] = [];
  for (const [file, source] of house) {
    if (file.startsWith('debug/')) {
      continue;
    }
    const code = strip(source);
    for (const use of code.matchAll(
      /(?<![.\w$])Math\b(?:\s*\.\s*(\w+))?|\*\*|(?<![.\w$])(?:Date|performance|crypto)\b/g,
    )) {
      if (use[1] === undefined || !EXACT.has(use[1])) {
        found.push(`${file}:${lineOf(code, use.index)} ${use[0]}`);
      }
    }
  }
  return found;
}

function anys(house: House): string[] {
  return [...house].flatMap(([file, source]) => {
    const code = strip(source);
    return [...code.matchAll(/(?<![.\w$])any\b(?!\s*[(:])/g)].map((use) => `${file}:${lineOf(code, use.index)} any`);
  });
}

function longFiles(house: House): string[] {
  return [...house]
    .map(([file, source]) => ({ file, lines: source.trimEnd().split('\n').length }))
    .filter(({ lines }) => lines > MAX_LINES)
    .map(({ file, lines }) => `${file} has ${lines} lines`);
}

/** The layer of a folder, of a file such as `world.ts`, or of a part of one such as `body-state.ts`. */
function layerOf(file: string): number {
  const name = file.split('/')[0]!.replace(/(?:-\w+)?\.ts$/, '');
  return LAYERS.findIndex((layer) => layer.includes(name));
}

function upwardImports(house: House): string[] {
  const homeless = [...house.keys()].filter((file) => layerOf(file) < 0).map((file) => `${file} is in no layer`);
  const upward = [...house.keys()].flatMap((file) =>
    valueImports(house, file)
      .filter((target) => layerOf(target) > layerOf(file))
      .map((target) => `${file} imports ${target}`),
  );
  return [...homeless, ...upward];
}

function cycles(house: House): string[] {
  const found: string[] = [];
  const done = new Set<string>();
  const visit = (file: string, path: readonly string[]): void => {
    const start = path.indexOf(file);
    if (start >= 0) {
      found.push([...path.slice(start), file].join(' -> '));
    } else if (house.has(file) && !done.has(file)) {
      for (const target of valueImports(house, file)) {
        visit(target, [...path, file]);
      }
      done.add(file);
    }
  };
  for (const file of house.keys()) {
    visit(file, []);
  }
  return found;
}

/** The rooms within a folder, each as one file that imports what those in it do of the others. */
function roomsOf(house: House, folder: string): House {
  const roomOf = (file: string) =>
    file.startsWith(folder) ? /^\w+(?=\/)/.exec(file.slice(folder.length))?.[0] : undefined;
  const rooms = new Map<string, string>();
  for (const file of house.keys()) {
    const room = roomOf(file);
    const others = valueImports(house, file).map(roomOf);
    if (room !== undefined) {
      const lines = others
        .filter((other) => other !== undefined && other !== room)
        .map((other) => `import './${other}.js';\n`);
      rooms.set(`${room}.ts`, [rooms.get(`${room}.ts`) ?? '', ...lines].join(''));
    }
  }
  return rooms;
}

/** What is made as a module is loaded stays in bundles that do not use it, unless it is marked as pure. */
function unmarked(house: House): string[] {
  const made = /^(?:export )?(?:const|let) (\w+)\b.*?=.*?(?<!abstract |@__PURE__ \*\/ )\bnew [A-Z]/gm;
  return [...house].flatMap(([file, source]) => [...source.matchAll(made)].map(([, name]) => `${file}: ${name}`));
}

function readHouse(): House {
  const src = join(import.meta.dirname, '../../src');
  const files = readdirSync(src, { recursive: true, encoding: 'utf8' }).filter((name) => name.endsWith('.ts'));
  return new Map(files.map((name) => [name.replaceAll('\\', '/'), readFileSync(join(src, name), 'utf8')]));
}

const one = (source: string, file = 'math/a.ts'): House => new Map([[file, source]]);

describe('src', () => {
  const house = readHouse();

  it('is found', () => {
    expect(house.size).toBeGreaterThan(20);
    expect(valueImports(house, 'umd.ts')).toContain('index.ts');
  });

  it('computes with nothing that an engine or a moment decides', () => {
    expect(unreproducible(house)).toEqual([]);
  });

  it('imports values downward only', () => {
    expect(upwardImports(house)).toEqual([]);
  });

  it('has no import cycle', () => {
    expect(cycles(house)).toEqual([]);
  });

  it.each([
    ['solver/', ['contacts.ts', 'impacts.ts', 'joints.ts']],
    ['solver/joints/', ['energy.ts', 'kernels.ts', 'order.ts', 'plan.ts', 'touching.ts']],
  ])('has rooms in %s of which no two import from each other', (folder, names) => {
    const rooms = roomsOf(house, folder);
    expect([...rooms.keys()].sort()).toEqual(names);
    expect(cycles(rooms)).toEqual([]);
  });

  it('has no any', () => {
    expect(anys(house)).toEqual([]);
  });

  it(`has no file longer than ${MAX_LINES} lines`, () => {
    expect(longFiles(house)).toEqual([]);
  });

  it('keeps the files of numbers for hot loops free of imports: with one the bundler looks the numbers up instead', () => {
    const numbers = [...house.keys()].filter((file) => /(?:^|[/-])layout\.ts$|^config(?:-joints)?\.ts$/.test(file));
    expect(numbers.length).toBeGreaterThan(5);
    expect(numbers.flatMap((file) => valueImports(house, file))).toEqual([]);
  });

  it('marks what is made as modules are loaded', () => {
    expect(unmarked(house)).toEqual([]);
  });

  it('imports nothing from outside', () => {
    const outside = [...house].flatMap(([file, source]) =>
      imports(source)
        .filter(({ target }) => !target.startsWith('.'))
        .map(({ target }) => `${file} imports ${target}`),
    );
    expect(outside).toEqual([]);
  });
});

describe('the scan for functions that are not reproducible', () => {
  it.each([
    ['a call', 'x = Math.sin(1);', 'Math.sin'],
    ['a line break', 'x = Math\n  .pow(1, 2);', 'Math\n  .pow'],
    ['an index', "x = Math['cos'](1);", 'Math'],
    ['a pattern', 'const { exp } = Math;', 'Math'],
    ['a function of the future', 'x = Math.sinpi(1);', 'Math.sinpi'],
    ['chance', 'x = Math.random();', 'Math.random'],
    ['a power', 'x = a ** b;', '**'],
    ['a power in place', 'x **= 2;', '**'],
    ['a clock', 'x = Date.now();', 'Date'],
    ['another clock', 'x = performance.now();', 'performance'],
    ['a hole in a template', 'x = `$' + '{Math.log(2)}`;', 'Math.log'],
    ['code after a template', 'x = `a $' + '{ { b: `c` } } d`; y = Math.tan(1);', 'Math.tan'],
    ['code after a regular expression', 'x = /[/\'"`]/; y = Math.tan(1);', 'Math.tan'],
    ['code after a division', 'x = a / b; y = Math.tan(1) / 2;', 'Math.tan'],
  ])('finds %s', (_, source, found) => {
    expect(unreproducible(one(source))).toEqual([expect.stringContaining(found)]);
  });

  it.each([
    ['exact functions', 'x = Math.sqrt(Math.abs(Math.PI));'],
    ['a line comment', '// Math.sin, a ** b'],
    ['a doc comment', '/** Math.sin\n ** Date */'],
    ['a string', "x = 'Math.sin'; y = \"don't Math.cos\";"],
    ['the text of a template', 'x = `Math.sin $' + '{a} ** Date`;'],
    ['a regular expression', 'x = /\\*\\*|Math.sin/;'],
    ['a member of ours', 'x = this.Date; y = trig.Math;'],
  ])('passes %s', (_, source) => {
    expect(unreproducible(one(source))).toEqual([]);
  });

  it('leaves debug drawing alone', () => {
    expect(unreproducible(one('x = Math.sin(1);', 'debug/draw.ts'))).toEqual([]);
  });

  it('names file and line', () => {
    expect(unreproducible(one('\n/*\n*/ x = Math.sin(1);'))).toEqual(['math/a.ts:3 Math.sin']);
  });
});

describe('the scan for what is made as modules are loaded', () => {
  it('finds what is not marked', () => {
    expect(unmarked(one('const box = new Float64Array(4);'))).toEqual(['math/a.ts: box']);
    expect(unmarked(one('export let all: Box[] = [/* @__PURE__ */ new Box(), new Box()];'))).toHaveLength(1);
  });

  it('passes what is marked, made later, or a type', () => {
    expect(unmarked(one('const box = /* @__PURE__ */ new Float64Array(4);\n  const later = new Box();'))).toEqual([]);
    expect(unmarked(one('export const Shape = Base as unknown as abstract new (x: never) => Shape;'))).toEqual([]);
  });
});

describe('the scan of imports', () => {
  it('finds values that come from above', () => {
    expect(upwardImports(one("import { World } from '../world.js';"))).toEqual(['math/a.ts imports world.ts']);
    expect(upwardImports(one("export { World } from '../world.js';"))).toEqual(['math/a.ts imports world.ts']);
    expect(upwardImports(one("import {\n  type A,\n  b,\n} from '../solver/step.js';"))).toHaveLength(1);
    expect(upwardImports(one("import '../world.js';"))).toHaveLength(1);
    expect(upwardImports(one("const world = await import('../world.js');"))).toHaveLength(1);
  });

  it('passes types from above, and values from below or beside', () => {
    expect(upwardImports(one("import type { World } from '../world.js';"))).toEqual([]);
    expect(upwardImports(one("import { b } from './b.js';\nimport { C } from '../config.js';"))).toEqual([]);
    expect(upwardImports(one("// import { World } from '../world.js';"))).toEqual([]);
  });

  it('finds a file without a layer', () => {
    expect(upwardImports(one('', 'attic/a.ts'))).toEqual(['attic/a.ts is in no layer']);
  });

  it('finds a cycle of values', () => {
    const house = new Map([
      ['math/a.ts', "import { b } from './b.js';"],
      ['math/b.ts', "import { c } from '../geometry/c.js';"],
      ['geometry/c.ts', "import { a } from '../math/a.js';"],
    ]);
    expect(cycles(house)).toEqual(['math/a.ts -> math/b.ts -> geometry/c.ts -> math/a.ts']);
  });

  it('finds rooms that import from each other', () => {
    const house = new Map([
      ['solver/step.ts', "import { b } from './left/b.js';"],
      ['solver/left/a.ts', "import { c } from '../right/c.js';"],
      ['solver/left/b.ts', ''],
      ['solver/right/c.ts', "import { b } from '../left/b.js';"],
    ]);
    expect(cycles(house)).toEqual([]);
    expect(cycles(roomsOf(house, 'solver/'))).toEqual(['left.ts -> right.ts -> left.ts']);
  });

  it('passes a cycle that types close', () => {
    const house = new Map([
      ['math/a.ts', "import { b } from './b.js';"],
      ['math/b.ts', "import type { A } from './a.js';"],
    ]);
    expect(cycles(house)).toEqual([]);
  });
});

describe('the scan for any', () => {
  it.each(['let x: any;', 'f(x as any);', 'let x: any[];', 'let x: Map<string, any>;', 'type X = string | any;'])(
    'finds %s',
    (source) => {
      expect(anys(one(source))).toEqual(['math/a.ts:1 any']);
    },
  );

  it.each(['// any', "x = 'any';", 'const many = 1;', 'x = list.any;', 'let x: unknown;'])('passes %s', (source) => {
    expect(anys(one(source))).toEqual([]);
  });
});

it('the scan for long files finds one line too many', () => {
  expect(longFiles(one('x;\n'.repeat(MAX_LINES)))).toEqual([]);
  expect(longFiles(one('x;\n'.repeat(MAX_LINES + 1)))).toEqual(['math/a.ts has 501 lines']);
});
