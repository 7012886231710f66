// Puts figures of the last written runs into the README of the project: node bench/readme.mjs
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { here } from './measure.mjs';

/** Which scenes of the bench the README has. */
const SCENES = ['pyramid', 'pyramids', 'circles', 'rain', 'chains', 'drum1000', 'tiles', 'rays'];

const README = here('../README.md');
const MARKED = /(<!-- peers -->\n)[\s\S]*?(<!-- \/peers -->)/;

/** A README with the figures between its marks. */
export function withFigures(readme, quality, speed) {
  if (!MARKED.test(readme)) {
    throw new Error('README.md has no <!-- peers --> and <!-- /peers -->');
  }
  const text = [qualityOf(quality), speed === null ? UNMEASURED : speedOf(speed)].join('\n\n');
  return readme.replace(MARKED, (_, before, after) => `${before}\n${text}\n\n${after}`);
}

const UNMEASURED = 'Speed beside the same engines: `npm run bench -- --write`.';

function qualityOf(page) {
  const rows = tableBelow(page, /^\| +\| rows led /m);
  return `**Quality**, how well scenes with a known answer come out: how many figures an engine is best at, alone or tied, and how many of phys2d's own targets it meets, as measured
on ${dateOf(page)} by \`${commandOf(page)}\`; all rows are in [bench/QUALITY.md](bench/QUALITY.md).

${rows.join('\n')}`;
}

function speedOf(page) {
  const [head, line, ...rows] = tableBelow(page, /^## Median of a step/m);
  const chosen = SCENES.flatMap((scene) => rows.filter((row) => row.startsWith(`| ${scene} (`)));
  if (chosen.length === 0) {
    throw new Error(`bench/RESULTS.md has none of the scenes ${SCENES.join(', ')}`);
  }
  return `**Speed**, the median of a step in ms (in parentheses how well it was solved, less is better; hits, and bodies awake, should be equal), as measured on ${dateOf(page)} by
\`${commandOf(page)}\`. phys2d meets ${metOf(page)} of its targets of speed and garbage; they, more scenes, and how they are measured, are in
[bench/RESULTS.md](bench/RESULTS.md).

${[head, line, ...chosen].join('\n')}

†: too slow to do all steps. –: has no such thing. A negative sag: the engine keeps boxes a little apart.`;
}

function dateOf(page) {
  return /^Written on (\d{4}-\d\d-\d\d)/m.exec(page)[1];
}

/** What was run. */
function commandOf(page) {
  return /^Written on [^`]*`([^`]+)`/m.exec(page)[1];
}

/** How many targets are met, and of how many. */
function metOf(page) {
  const [, met, all] = /^(\d+) of (\d+) targets are met\.$/m.exec(page);
  return `${met} / ${all}`;
}

/** Lines of the first table from a place on. */
function tableBelow(page, place) {
  const lines = page.slice(page.search(place)).split('\n');
  const from = lines.findIndex((line) => line.startsWith('|'));
  const length = lines.slice(from).findIndex((line) => !line.startsWith('|'));
  return lines.slice(from, from + length);
}

/** Writes what the files beside this one say. */
export function writeFigures() {
  const read = (name) => (existsSync(here(name)) ? readFileSync(here(name), 'utf8') : null);
  writeFileSync(README, withFigures(readFileSync(README, 'utf8'), read('QUALITY.md'), read('RESULTS.md')));
  execFileSync(process.execPath, [here('../node_modules/@biomejs/biome/bin/biome'), 'format', '--write', README]);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  writeFigures();
}
