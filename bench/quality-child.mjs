// One claim, or the checks of an adapter, with one engine: node quality-child.mjs '{"engine":"planck","claim":"tower"}' prints one
// line of JSON at the end.
import { writeSync } from 'node:fs';
import { engines } from './engines.mjs';
import { checks } from './quality-checks.mjs';

const { ...claims } = await import('../dist/bench/claims.js');
const { engine, claim } = JSON.parse(process.argv[2]);
const device = await engines[engine].load();
const result = claim === undefined ? checks(device) : measure(claims[claim]);
// At once, as Box2D's threads would keep the process.
writeSync(1, `\n${JSON.stringify(result)}\n`);
process.exit(0);

/** The figures of a claim. Those that are no finite numbers come as strings, as JSON has none. */
function measure(claim) {
  const worlds = [];
  const createWorld = (params) => {
    const world = device.createWorld(params);
    worlds.push(world);
    return world;
  };
  const watched = Object.create(device, { createWorld: { value: createWorld } });
  const figures = claim.measure(watched);
  const isLost = (body) => ![...body.getPosition(), body.getRotation()].every(Number.isFinite);
  const lost = worlds.reduce((sum, { rigidBodies }) => sum + [...rigidBodies].filter(isLost).length, 0);
  return {
    figures: figures.map(({ value, ...figure }) => ({ ...figure, value: lost > 0 ? 'NaN' : text(value) })),
    lost,
  };
}

function text(value) {
  return Number.isFinite(value) ? value : String(value);
}
