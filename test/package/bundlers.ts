import { mkdirSync, mkdtempSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

// Programs that bundlers bundle, each with a part of the package, and how to tell from a bundle which parts are in it.

export const root = join(import.meta.dirname, '../..');

/** What a part says in its errors, or names in its code: the text is in a bundle if and only if the part is. */
export const MARKS = {
  angle: 'createAngleConstraint',
  custom: 'createCustomConstraint',
  distance: 'createDistanceConstraint',
  line: 'createLineConstraint',
  motor: 'createMotorConstraint',
  point: 'createPointConstraint',
  pulley: 'createPulleyConstraint',
  weld: 'createWeldConstraint',
  polygon: 'createPolygonShape',
  utils: 'CollisionUtils.',
  sweep: 'SweepAndPrune',
  debug: 'Physics2DDebugDraw',
  joints: 'solveVelocities:',
  state: 'the snapshot is of version',
} as const;

export type Part = keyof typeof MARKS;

const DROP = `
const world = createWorld({ gravity: [0, 10] });
const body = createRigidBody({ shapes: [createCircleShape({ radius: 0.5 })] });
world.addRigidBody(body);
for (let i = 0; i < 60; i += 1) world.step(1 / 60);
console.log('fell', Math.round(body.getPosition()[1]));
`;

const FREE = 'createWorld, createRigidBody, createCircleShape';
const UNTIED = `${FREE}, createMaterial, createPolygonShape, createCollisionUtils, createSweepAndPruneBroadphase`;
const DEVICE = 'const { createWorld, createRigidBody, createCircleShape } = phys2D;';

/** Parts of the engine itself, in the order of the programs that have more and more of them. */
const TIES: readonly Part[] = ['angle', 'custom', 'distance', 'line', 'motor', 'point', 'pulley', 'weld'];
const REST: readonly Part[] = ['polygon', 'utils', 'sweep'];
const ALL: readonly Part[] = [...TIES, ...REST, 'joints', 'state'];

export interface Program {
  name: string;
  code: string;
  parts: readonly Part[];
  /** Bytes, minified and gzipped, as measured and rounded up. */
  budget: number;
}

/** Each prints `fell 5`. */
export const PROGRAMS: readonly Program[] = [
  {
    name: 'world, circles and a broadphase',
    code: `import { ${FREE} } from 'phys2d';${DROP}`,
    parts: [],
    budget: 58_500,
  },
  {
    name: 'everything but constraints',
    code: `import { ${UNTIED} } from 'phys2d';
globalThis.used = [createMaterial(), createPolygonShape, createCollisionUtils(), createSweepAndPruneBroadphase()];${DROP}`,
    parts: REST,
    budget: 68_600,
  },
  ...TIES.map(
    (kind): Program => ({
      name: `one kind of constraint, ${kind}`,
      code: `import { ${FREE}, ${MARKS[kind]} } from 'phys2d';\nglobalThis.used = ${MARKS[kind]};${DROP}`,
      parts: [kind, 'joints'],
      budget: 89_900,
    }),
  ),
  {
    name: 'a world that can be saved',
    code: `import { ${FREE}, worldState } from 'phys2d';
const saved = createWorld({ state: worldState });
saved.restore(saved.snapshot());${DROP}`,
    // Polygons, as one may have to stand in for a shape that is gone.
    parts: ['state', 'polygon'],
    budget: 81_600,
  },
  {
    name: 'everything',
    code: `import { phys2D } from 'phys2d';\n${DEVICE}${DROP}`,
    parts: ALL,
    budget: 119_900,
  },
  {
    name: 'everything, with debug drawing',
    code: `import { phys2D, Physics2DDebugDraw } from 'phys2d';
import { SVGDebugDevice } from 'phys2d/debug';
const debug = Physics2DDebugDraw.create({ graphicsDevice: SVGDebugDevice.create({ width: 10, height: 10 }) });
debug.begin();
debug.drawWorld(phys2D.createWorld());
debug.end();
${DEVICE}${DROP}`,
    parts: [...ALL, 'debug'],
    budget: 126_800,
  },
];

/** Which of the marked parts a bundle has. */
export function partsOf(bundle: string): Part[] {
  return (Object.keys(MARKS) as Part[]).filter((part) => bundle.includes(MARKS[part]));
}

/** A new folder of a project that has the package, as built, in its node_modules; the programs are `0.js`, `1.js` and so on. */
export function project(): string {
  const folder = mkdtempSync(join(tmpdir(), 'phys2d-bundles-'));
  mkdirSync(join(folder, 'node_modules'));
  symlinkSync(root, join(folder, 'node_modules/phys2d'), 'junction');
  writeFileSync(join(folder, 'package.json'), '{ "type": "module" }');
  PROGRAMS.forEach(({ code }, i) => {
    writeFileSync(join(folder, `${i}.js`), code);
  });
  return folder;
}
