// Tables of bench/quality.mjs: which value is the best of a row, and how a row is printed.

/** m. A scene in which something has moved farther than this has fallen down: most are of boxes of 1 m. */
const FELL = 0.9;

/**
 * Whether what a figure tells of has fallen down: then it tells little, as the ruins of a tower lie very still. That is so where
 * the claim counts something that fell, where another figure of the same thing is infinite, and where something moved far.
 */
export function collapsed(figures, i) {
  const head = ({ what }) => what.split(':')[0];
  return figures.some((figure, k) => {
    const isInfinite = k !== i && head(figure) === head(figures[i]) && figure.value === 'Infinity';
    const hasFallen = k !== i && /that fell/.test(figure.what) && figure.value > 0;
    return isInfinite || hasFallen || (k !== i && figure.what === 'farthest move' && figure.value > FELL);
  });
}

/** Three digits. */
export function number(value) {
  if (typeof value !== 'number') {
    return value === 'Infinity' ? '∞' : value;
  }
  if (value === 0 || Number.isInteger(value)) {
    return `${value + 0}`;
  }
  const digits = Math.abs(value) >= 0.001 && Math.abs(value) < 10_000 ? value.toPrecision(3) : value.toExponential(1);
  return digits.replace('e+', 'e');
}

/** Nought is best for all figures. Values that print alike, or that are both below a thousandth of the target, are as good. */
export function best({ limit, cells }) {
  const size = ({ value }) => (Math.abs(value) <= (limit ?? 0) / 1000 ? 0 : Number(Math.abs(value).toPrecision(3)));
  const fit = cells.filter(({ value, fell }) => typeof value === 'number' && !fell);
  const least = Math.min(...fit.map(size));
  return fit.filter((cell) => size(cell) === least).map(({ engine }) => engine);
}

function meets({ limit }, { value, fell }) {
  return typeof value === 'number' && !fell && value <= limit;
}

/** Of each engine in how many rows it leads, alone or not, and how many targets it meets. */
export function summarize(engines, tables) {
  const rows = tables.flatMap((table) => table.rows);
  return engines.map((engine) => {
    const leads = rows.map(best).filter((names) => names.includes(engine));
    const cells = rows.map((row) => [row, row.cells.find((cell) => cell.engine === engine)]);
    return {
      engine,
      led: leads.length,
      alone: leads.filter((names) => names.length === 1).length,
      rows: rows.length,
      met: cells.filter(([row, cell]) => row.limit !== undefined && meets(row, cell)).length,
      targets: rows.filter(({ limit }) => limit !== undefined).length,
    };
  });
}

/** Texts of a row: figure, cells, target. A star is for the best, a dagger for what has fallen. */
function texts(row, strong) {
  const leaders = best(row);
  const cells = row.cells.map((cell) => {
    const text = `${number(cell.value)}${cell.fell ? ' †' : ''}`;
    return leaders.includes(cell.engine) ? strong(text) : text;
  });
  const unit = row.unit === '' ? '' : `, ${row.unit}`;
  return [`${row.what}${unit}`, ...cells, row.limit === undefined ? '' : `≤ ${number(row.limit)}`];
}

const SUMMARY = ['', 'rows led', 'of them alone', 'targets met'];

function summaryRow({ engine, led, alone, rows, met, targets }) {
  return [engine, `${led} / ${rows}`, `${alone}`, `${met} / ${targets}`];
}

export function print({ versions, cpu, node, summary, tables }) {
  const engines = summary.map(({ engine }) => engine);
  console.log(`phys2d quality: Node ${node}, ${cpu}`);
  console.log(engines.map((engine) => `${engine} ${versions[engine]}`).join(', '));
  for (const { claim, scene, rows, failures } of tables) {
    console.log(`\n${claim}: ${scene}`);
    align([['', ...engines, 'target'], ...rows.map((row) => texts(row, (text) => `* ${text}`))]);
    for (const { engine, failure, reason } of failures) {
      console.log(`  ${engine}: ${failure} ${reason}`.trimEnd());
    }
  }
  console.log('\n* the best; † of a scene that has fallen down, does not count\n');
  align([SUMMARY, ...summary.map(summaryRow)]);
}

/** Prints lines of cells in columns, the first to the left. */
export function align(lines) {
  const widths = lines[0].map((_, i) => Math.max(...lines.map((line) => line[i].length)));
  for (const line of lines) {
    const cells = line.map((text, i) => (i === 0 ? text.padEnd(widths[i]) : text.padStart(widths[i] + 2)));
    console.log(`  ${cells.join('')}`.trimEnd());
  }
}

/** A table of a page, as biome formats it. */
export function grid(lines) {
  const widths = lines[0].map((_, i) => Math.max(3, ...lines.map((line) => line[i].length)));
  const pad = (text, i) => (i === 0 ? text.padEnd(widths[i]) : text.padStart(widths[i]));
  const rule = widths.map((width, i) => (i === 0 ? '-'.repeat(width) : `${'-'.repeat(width - 1)}:`));
  const [head, ...body] = lines.map((line) => line.map(pad));
  return [head, rule, ...body].map((line) => `| ${line.join(' | ')} |`).join('\n');
}

/** The same as a page. */
export function markdown({ date, versions, cpu, node, timeout, summary, tables }) {
  const engines = summary.map(({ engine }) => engine);
  const parts = tables.map(({ claim, scene, rows, failures }) => {
    const table = grid([['', ...engines, 'target'], ...rows.map((row) => texts(row, (text) => `**${text}**`))]);
    const notes = failures.map(
      ({ engine, failure, reason }) => `\n\n${engine}: ${failure}${reason ? ` (\`${reason}\`)` : ''}.`,
    );
    return `## ${claim}\n\n${scene[0].toUpperCase()}${scene.slice(1)}.\n\n${table}${notes.join('')}`;
  });
  return `# Quality of phys2d beside other engines

Written on ${date} by \`node bench/quality.mjs --write --limit=${timeout}\`, Node ${node}, ${cpu}:
${engines.map((engine) => `${engine} ${versions[engine]}`).join(', ')}.
How it is measured is told in [README.md](README.md#quality).

The best of a row is bold: the nearest to nought. Values that print alike, or are both below a thousandth of the target, are as
good. † marks figures of a scene that has fallen down in this engine: they do not count, as ruins lie still.

${grid([SUMMARY, ...summary.map(summaryRow)])}

${parts.join('\n\n')}
`;
}
