import { defineConfig } from 'vitest/config';
import { BaseSequencer } from 'vitest/node';

// Tests of the folder that is mutated: quick ones, as each mutant is tried.
const FOLDERS = {
  geometry: ['geometry', 'shape', 'bad-input/bad-input', 'conformance/04', 'conformance/05', 'conformance/18'],
  collide: [
    'collide',
    'state/golden',
    'solver/continuous',
    'solver/seams',
    'conformance/08',
    'conformance/10',
    'conformance/11',
    'conformance/18',
    'conformance/19',
  ],
  events: [
    'events',
    'constraint/events',
    'world/containment',
    'bad-input/events',
    'conformance/11',
    'conformance/12',
    'conformance/13',
    'conformance/16',
  ],
  solver: [
    'state/golden',
    'solver/continuous',
    'solver/directions',
    'solver/many',
    'solver/meeting-queue',
    'solver/rolling',
    'solver/seams',
    'solver/simd',
    'solver/ways',
    'constraint/constraint',
    'constraint/events',
    'constraint/ignore',
    'constraint/limits',
    'contact/arbiter',
    'events/asleep',
    'events/hit',
    'world/frozen',
    'world/profile',
    'conformance/07',
    'conformance/08',
    'conformance/12',
    'conformance/13',
    'conformance/14',
    'conformance/15',
    'conformance/16',
    'conformance/17',
    'issues',
  ],
};

/** What failed last comes first, as the next mutant is a neighbour; then the quickest. */
class LikelyFirst extends BaseSequencer {
  async sort(files) {
    const { cache } = this.ctx;
    const resultOf = ({ moduleId }) => {
      const key = `:${moduleId.slice(this.ctx.config.root.length + 1)}`;
      return cache.getFileTestResults(key) ?? { failed: false, duration: 0 };
    };
    return [...files].sort((a, b) => {
      const [one, other] = [resultOf(a), resultOf(b)];
      return Number(other.failed) - Number(one.failed) || one.duration - other.duration;
    });
  }
}

export default defineConfig({
  test: {
    include: FOLDERS[process.env.MUTATED].map((name) => `test/${name}{*,/**/*}.test.ts`),
    // Too slow.
    exclude: ['test/geometry/many.test.ts'],
    sequence: { sequencer: LikelyFirst },
    // Files share one process, four times as fast: then what Stryker prepares for each has to be loaded anew, as files of packages are not.
    isolate: false,
    server: { deps: { inline: [/stryker-setup/] } },
    testTimeout: 30_000,
  },
});
