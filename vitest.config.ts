import { configDefaults, defineConfig } from 'vitest/config';
import { compiledSource } from './test/compiled-source.js';

/** What counts frames, or waits for a browser that is slow where another process keeps the machine busy. */
const ALONE = ['test/{browser,examples}/**/*.test.ts'];

export default defineConfig({
  plugins: [compiledSource()],
  test: {
    projects: [
      {
        extends: true,
        test: {
          name: 'side by side',
          include: ['test/**/*.test.ts'],
          exclude: [...configDefaults.exclude, ...ALONE],
          maxWorkers: '100%',
          sequence: { groupOrder: 0 },
        },
      },
      { extends: true, test: { name: 'alone', include: ALONE, maxWorkers: 1, sequence: { groupOrder: 1 } } },
    ],
    // Against tests that hang. How fast things go is for `bench`.
    testTimeout: 120_000,
    coverage: {
      provider: 'v8',
      include: ['src/**/*.ts'],
      // Types and names only.
      exclude: ['src/umd.ts', 'src/**/index.ts'],
      reporter: ['text', 'text-summary'],
      reportOnFailure: true,
      thresholds: { lines: 95, branches: 90 },
    },
  },
});
