// What the bench measures besides the scenes. Each part returns a title, the rows of its table, and its targets.
import { engines, usual } from './engines.mjs';
import { GC_FLAGS, interleave, measure, summary } from './measure.mjs';

const ms = (value) => `${value.toFixed(3)} ms`;
const kB = (bytes) => `${(bytes / 1000).toFixed(2)} kB`;
const titleOf = (engine) => engines[engine].title ?? engine;

/** Steps until what they run is compiled: this many, and as long. Then so many are measured, or those that fit into the same time. */
const GARBAGE = { task: 'garbage', warmUp: 1_000, seconds: 15, steps: 500 };

/** A target that is met if the value is at most that. */
function target(what, value, most) {
  return { what, value, most, met: value <= most };
}

function crowd({ rounds }) {
  const job = { task: 'crowd', warmUp: 300, steps: 1200 };
  const jobs = [0, 10_000].map((idle) => ({ ...job, idle }));
  const runs = interleave(jobs, rounds);
  for (const { awake } of runs.flat()) {
    if (awake !== 50) {
      throw new Error(`bench: 50 boxes should be awake, not ${awake}`);
    }
  }
  const [alone, amid] = runs.map(summary);
  return {
    title: '50 awake boxes, alone and among 5,000 static and 5,000 sleeping ones',
    rows: [
      ['', 'median', 'p95'],
      ['alone', ms(alone.median), ms(alone.p95)],
      ['with 10,000 idle', ms(amid.median), ms(amid.p95)],
    ],
    targets: [target('with / alone', amid.median / alone.median, 1.5)],
    alone,
    amid,
  };
}

function events({ rounds }) {
  const job = { task: 'events', base: 32, warmUp: 120, steps: 480 };
  const [silentRuns, heardRuns] = interleave([job, { ...job, listening: true }], rounds);
  const { pairs, callsPerStep } = heardRuns[0];
  const [silent, heard] = [summary(silentRuns), summary(heardRuns)];
  const warm = { ...GARBAGE, engine: 'phys2d', base: job.base };
  const [bytes, heardBytes] = [false, true].map(
    (listening) => measure({ ...warm, listening }, { flags: GC_FLAGS }).bytesPerStep,
  );
  return {
    title: `Handlers for progress: a pyramid with ${pairs} touching pairs`,
    rows: [
      ['', 'median', 'p95', 'garbage per step'],
      ['none', ms(silent.median), ms(silent.p95), kB(bytes)],
      [`${callsPerStep.toFixed(0)} calls a step`, ms(heard.median), ms(heard.p95), kB(heardBytes)],
    ],
    targets: [target('with / without', heard.median / silent.median, 1.15)],
    silent,
    heard,
    pairs,
    callsPerStep,
    bytes: { silent: bytes, heard: heardBytes },
  };
}

function continuous({ rounds }) {
  const job = { task: 'continuous', base: 40, warmUp: 120, steps: 2000 };
  const shares = interleave([job], rounds)[0].map(({ share }) => 100 * share);
  const share = shares.sort((a, b) => a - b)[Math.floor(shares.length / 2)];
  return {
    title: 'Continuous collision in the pyramid, where nothing is fast',
    rows: [
      ['', 'of a step'],
      ['share', `${share.toFixed(2)} %`],
    ],
    targets: [target('share, %', share, 3)],
    share,
  };
}

/** Bytes allocated per warm step: of phys2d in all scenes, of planck in one. */
function garbage({ scenes }) {
  const small = { ...GARBAGE, base: 15 };
  const bytes = Object.fromEntries(
    ['phys2d', 'planck'].map((engine) => [
      `120 awake boxes, ${engine}`,
      measure({ ...small, engine }, { flags: GC_FLAGS }).bytesPerStep,
    ]),
  );
  const targets = [target('120 awake boxes, kB', bytes['120 awake boxes, phys2d'] / 1000, 1)];
  for (const [scene, { renews }] of Object.entries(scenes)) {
    const job = { ...GARBAGE, engine: 'phys2d', scene };
    bytes[scene] = measure(job, { flags: GC_FLAGS }).bytesPerStep;
    if (!renews) {
      targets.push(target(`${scene}, kB`, bytes[scene] / 1000, 1));
    }
  }
  return {
    title: `Garbage: bytes allocated per step, after ${GARBAGE.warmUp} steps and ${GARBAGE.seconds} s`,
    rows: [['', 'per step'], ...Object.entries(bytes).map(([name, each]) => [name, kB(each)])],
    targets,
    bytes,
  };
}

/** Time per contact of pyramids: touching pairs of one of base n are n². */
function growth({ rounds }) {
  const bases = [20, 40, 80, 160];
  const names = ['phys2d', 'Box2D', 'Box2D-scalar'];
  const jobs = bases.flatMap((base) => names.map((engine) => ({ task: 'speed', engine, base, seconds: 4 })));
  const medians = interleave(jobs, rounds).map((runs) => summary(runs).median);
  const perPair = bases.map((base, i) => names.map((_, k) => (1e6 * medians[names.length * i + k]) / base ** 2));
  const [least, most] = [perPair[0][0], perPair.at(-1)[0]];
  return {
    title: 'Growth: time per touching pair of a pyramid',
    rows: [
      ['base', ...names.map(titleOf)],
      ...perPair.map((row, i) => [`${bases[i]}`, ...row.map((each) => `${each.toFixed(0)} ns`)]),
    ],
    targets: [target('phys2d, base 160 / base 20', most / least, 1.3)],
    bases,
    perPair: Object.fromEntries(names.map((name, k) => [name, perPair.map((row) => row[k])])),
  };
}

/** Engines in WebAssembly keep their bodies where the heap does not show. */
function memory() {
  const names = ['phys2d', 'planck', 'phaser-box2d', 'matter-js', 'p2-es'];
  const bytes = names.map(
    (engine) => measure({ task: 'memory', engine, count: 10_000 }, { flags: GC_FLAGS }).bytesPerBody,
  );
  return {
    title: 'Memory of a sleeping body with one box',
    rows: [['', 'per body'], ...names.map((engine, i) => [engine, kB(bytes[i])])],
    targets: [target('phys2d, kB', bytes[0] / 1000, 1.2)],
    bytes: Object.fromEntries(names.map((engine, i) => [engine, bytes[i]])),
  };
}

/** New processes, several for each round, as they are short: from before the import to after the first step of 100 boxes. */
function cold({ rounds }) {
  const names = usual;
  const times = names.map(() => []);
  const starts = 9 * rounds;
  for (let start = 0; start < starts; start += 1) {
    names.forEach((engine, i) => {
      times[i].push(measure({ engine }, { program: 'cold.mjs' }).total);
    });
  }
  const medians = times.map((each) => each.sort((a, b) => a - b)[Math.floor(each.length / 2)]);
  return {
    title: `Cold: from the import to the end of the first step of 100 boxes, median of ${starts}`,
    rows: [['', 'time'], ...names.map((engine, i) => [titleOf(engine), `${medians[i].toFixed(1)} ms`])],
    targets: [target('phys2d, ms', medians[0], 30)],
    medians: Object.fromEntries(names.map((engine, i) => [engine, medians[i]])),
  };
}

function hash() {
  const hashes = measure({ task: 'hash', base: 40, steps: 600 });
  const different = new Set(Object.values(hashes)).size - 1;
  return {
    title: 'State hash of the pyramid of 820 boxes, awake, after 600 steps',
    rows: [
      ['', 'hash'],
      ['box tree', hashes.boxTree],
      ['sweep and prune', hashes.sweepAndPrune],
      ['in a second world', hashes.secondWorld],
    ],
    targets: [target('hashes that differ', different, 0)],
    hashes,
    equal: different === 0,
  };
}

/** The quickest tenth counts: a step before each leaves little of a time slice, and what else the machine does can only add to the times. */
function snapshot({ rounds }) {
  const names = ['phys2d', 'Rapier', 'Rapier-SIMD'];
  const jobs = names.map((engine) => ({ task: 'snapshot', engine, warmUp: 100, times: 200 }));
  const cells = interleave(jobs, rounds).map((runs) => {
    const quick = (what) => runs.flatMap((run) => run[what]).sort((a, b) => a - b)[rounds * 20];
    return { bytes: runs[0].bytes, take: quick('take'), restore: quick('restore') };
  });
  const [own, rapier] = cells;
  return {
    title: 'A snapshot of 1,000 piled boxes that are awake',
    rows: [
      ['', 'size', 'take', 'restore'],
      ...cells.map(({ bytes, take, restore }, i) => [titleOf(names[i]), kB(bytes), ms(take), ms(restore)]),
    ],
    targets: [
      target('phys2d, kB', own.bytes / 1000, 500),
      target('take: phys2d / Rapier', own.take / rapier.take, 0.3),
      target('restore: phys2d / Rapier', own.restore / rapier.restore, 0.1),
    ],
    cells: Object.fromEntries(names.map((name, i) => [name, cells[i]])),
  };
}

export const parts = { crowd, events, continuous, garbage, growth, memory, cold, hash, snapshot };
