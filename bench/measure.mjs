// Measurements in processes of their own, and what is made of their times.
import { spawnSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';

export const here = (path) => fileURLToPath(new URL(path, import.meta.url));

/** With a young generation that is large enough, the growth of the heap is what was allocated. */
export const GC_FLAGS = ['--expose-gc', '--min-semi-space-size=64', '--max-semi-space-size=64'];

/** Runs one measurement. @returns its result, or why there is none. */
export function attempt(job, { flags = [], program = 'child.mjs', limit = 300 } = {}) {
  const child = spawnSync(process.execPath, [...flags, here(program), JSON.stringify(job)], {
    encoding: 'utf8',
    stdio: ['ignore', 'pipe', 'pipe'],
    maxBuffer: 2 ** 26,
    timeout: 1000 * limit,
    killSignal: 'SIGKILL',
  });
  if (child.status === 0) {
    return JSON.parse(child.stdout.trim().split('\n').at(-1));
  }
  const reason = child.stderr.split('\n').find((line) => /error|panicked|unreachable|memory/i.test(line)) ?? '';
  return child.signal === 'SIGKILL'
    ? { failure: `> ${limit} s`, reason: '' }
    : { failure: 'crash', reason: reason.trim().slice(0, 160) };
}

/** The same where there must be a result. */
export function measure(job, options) {
  const result = attempt(job, options);
  if (result.failure !== undefined) {
    throw new Error(`bench: ${JSON.stringify(job)}: ${result.failure} ${result.reason}`);
  }
  return result;
}

/** Runs all jobs in turn, several times over, so that a slow moment of the machine hits all alike. */
export function interleave(jobs, rounds) {
  const runs = jobs.map(() => []);
  for (let round = 0; round < rounds; round += 1) {
    for (const [i, job] of jobs.entries()) {
      runs[i].push(measure(job));
    }
  }
  return runs;
}

/** Of the quietest run, as what else the machine does can only add to the times. */
export function summary(runs) {
  const [times] = runs
    .map(({ times }) => times.toSorted((a, b) => a - b))
    .sort((a, b) => percentile(a, 50) - percentile(b, 50));
  return { median: percentile(times, 50), p95: percentile(times, 95), p99: percentile(times, 99) };
}

function percentile(sorted, percent) {
  return sorted[Math.min(sorted.length - 1, Math.floor((percent / 100) * sorted.length))];
}
