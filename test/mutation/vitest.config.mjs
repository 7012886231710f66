import { defineConfig } from 'vitest/config';

// Tests of the folder that is mutated: quick ones, as each mutant is tried.
const FOLDERS = {
  geometry: [
    'geometry',
    'collide',
    'query',
    'bad-input/bad-input',
    'conformance/04',
    'conformance/05',
    'conformance/19',
  ],
  collide: ['geometry', 'collide', 'query', 'conformance/08', 'conformance/10', 'conformance/18', 'conformance/19'],
  events: [
    'events',
    'constraint/events',
    'bad-input/events',
    'conformance/11',
    'conformance/12',
    'conformance/13',
    'conformance/16',
  ],
  solver: ['solver', 'constraint', 'conformance', 'scenes/scenes', 'contact'],
};

export default defineConfig({
  test: {
    include: FOLDERS[process.env.MUTATED].map((name) => `test/${name}{*,/**/*}.test.ts`),
    testTimeout: 30_000,
  },
});
