// How the results of bench/run.mjs are printed, and written as a page.
import { engines } from './engines.mjs';
import { align, grid, number } from './quality-table.mjs';

/** Names of the times in a `World.profile`; the others are counts. */
const PHASES = ['pairs', 'foresight', 'islands', 'prepare', 'velocities', 'positions', 'store', 'continuous', 'events'];

const titleOf = (engine) => engines[engine].title ?? engine;

function time(value) {
  return value >= 100 ? value.toFixed(0) : value.toPrecision(3);
}

/** Median and quality, the latter with a dagger if the engine was too slow to do all steps. */
function text({ failure, median, quality, isCut }) {
  return failure ?? `${time(median)} (${number(quality ?? Number.NaN)}${isCut ? '†' : ''})`;
}

function ratio(cells, engine) {
  const [own, other] = [cells.phys2d?.median, cells[engine].median];
  return own === undefined || other === undefined ? '' : number(own / other);
}

function mark({ met, lost }) {
  return lost ? 'lost' : met ? 'met' : 'MISSED';
}

export function printScene({ name, title, figure, cells, targets }) {
  console.log(`\n${name}: ${title}`);
  align([
    ['', 'median', 'p95', figure, 'phys2d is'],
    ...Object.entries(cells).map(([engine, cell]) =>
      cell.failure === undefined
        ? [
            titleOf(engine),
            `${time(cell.median)} ms`,
            `${time(cell.p95)} ms`,
            `${number(cell.quality ?? Number.NaN)}${cell.isCut ? '†' : ''}`,
            engine === 'phys2d' || ratio(cells, engine) === '' ? '' : `× ${ratio(cells, engine)}`,
          ]
        : [titleOf(engine), cell.failure, '', '', ''],
    ),
  ]);
  printProfile(cells.phys2d?.profile);
  printMarks(targets);
}

/** One line of times, largest first, and one of counts. */
function printProfile(profile) {
  if (profile === undefined) {
    return;
  }
  const entries = Object.entries(profile);
  const times = entries.filter(([name]) => PHASES.includes(name)).sort(([, a], [, b]) => b - a);
  const counts = entries.filter(([name]) => !PHASES.includes(name));
  console.log(`  phys2d, ms: ${times.map(([name, value]) => `${name} ${value.toPrecision(2)}`).join(', ')}`);
  console.log(`  ${counts.map(([name, value]) => `${name} ${Math.round(value)}`).join(', ')}`);
}

export function printPart({ name, title, rows, targets }) {
  console.log(`\n${name}: ${title}`);
  align(rows);
  printMarks(targets);
}

function printMarks(targets) {
  for (const target of targets) {
    console.log(`  ${mark(target).padEnd(8)}${target.what} ${number(target.value)}, target: at most ${target.most}`);
  }
}

/** The tables of the whole run: a row a scene, a column an engine; then what of the targets was met. */
export function printTargets(results) {
  if (results.scenes.length > 0) {
    console.log('\nMedian in ms (quality)');
    align(sceneTable(results));
  }
  const targets = targetsOf(results);
  const missed = targets.filter(({ met }) => !met);
  console.log(
    `\n${targets.length - missed.length} of ${targets.length} targets met${missed.length > 0 ? '; missed:' : ''}`,
  );
  if (missed.length > 0) {
    const rows = missed.map(({ name, what, value, most }) => [`${name}: ${what}`, number(value), `${most}`]);
    align([['', 'value', 'at most'], ...rows]);
  }
}

function sceneTable({ versions, scenes }) {
  const names = Object.keys(versions);
  return [
    ['', ...names.map(titleOf)],
    ...scenes.map(({ name, figure, cells }) => [`${name} (${figure})`, ...names.map((engine) => text(cells[engine]))]),
  ];
}

function p95Table({ versions, scenes }) {
  const names = Object.keys(versions);
  return [
    ['', ...names.map(titleOf)],
    ...scenes.map(({ name, cells }) => [
      name,
      ...names.map((engine) => (cells[engine].p95 === undefined ? '' : time(cells[engine].p95))),
    ]),
  ];
}

function ratioTable({ versions, scenes }) {
  const names = Object.keys(versions).filter((engine) => engine !== 'phys2d');
  const cell = ({ cells, targets }, engine) => {
    const target = targets.find((it) => it.engine === engine);
    const value = ratio(cells, engine);
    return target === undefined ? value : `${value} ${sign(target)} ≤ ${target.most}`;
  };
  return [
    ['', ...names.map(titleOf)],
    ...scenes.map((scene) => [scene.name, ...names.map((engine) => cell(scene, engine))]),
  ];
}

function sign({ met, lost }) {
  return lost ? '○' : met ? '✓' : '✗';
}

/** Those that can be met. */
function targetsOf({ scenes, parts }) {
  const all = [...scenes, ...parts].flatMap(({ name, targets }) => targets.map((target) => ({ name, ...target })));
  return all.filter(({ lost }) => !lost);
}

/** The same as a page. */
export function markdown(results) {
  const { date, command, node, cpu, cores, versions, scenes, parts } = results;
  const targets = targetsOf(results);
  const others = targets.filter(({ engine }) => engine === undefined);
  const failures = scenes.flatMap(({ name, cells }) =>
    Object.entries(cells)
      .filter(([, { reason }]) => reason)
      .map(([engine, { reason }]) => `\n- ${name}, ${titleOf(engine)}: \`${reason}\``),
  );
  return `# Speed of phys2d beside other engines

Written on ${date} by \`node bench/run.mjs ${command}\`, Node ${node}, ${cpu}, ${cores} cores:
${Object.entries(versions)
  .map(([engine, version]) => `${titleOf(engine)} ${version}`)
  .join(', ')}.
How it is measured is told in [README.md](README.md).

${targets.filter(({ met }) => met).length} of ${targets.length} targets are met.

## Median of a step, ms (quality)

† The engine was too slow to do all steps: its figures are those of an earlier moment. – It has no such thing.

${grid(sceneTable(results))}

${scenes.map(({ name, title }) => `- \`${name}\`: ${title}`).join('\n')}
${failures.length > 0 ? `\nWhat failed:\n${failures.join('')}\n` : ''}
## phys2d's median as a ratio to the other engine's

✓ and ✗ are for targets met and missed. ○: the other engine did not keep its quality, something escaped, or sagged, overlapped or gaped by more than the
narrowest body is wide; that is no target then.

${grid(ratioTable(results))}

## 95th percentile of a step, ms

${grid(p95Table(results))}

## Other targets

${grid([['', 'value', 'at most', ''], ...others.map(({ name, what, value, most, met }) => [`${name}: ${what}`, number(value), `${most}`, sign({ met })])])}

${parts.map(({ name, title, rows }) => `## ${name}\n\n${title}.\n\n${grid(rows)}`).join('\n\n')}
`;
}
