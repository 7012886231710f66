// What phys2d aims at: the ratio of its median to that of another engine in the same run, at most.

const JS = { planck: 1, 'phaser-box2d': 1, 'matter-js': 1, 'p2-es': 1 };
/** In scenes of contacts planck is to be four times as slow, or slower. */
const CONTACTS = { ...JS, planck: 0.25 };

const vsBox2D = (simd, scalar) => ({ Box2D: simd, ...(scalar === undefined ? {} : { 'Box2D-scalar': scalar }) });

/** By scene and engine; a scene that is not here is compared with engines in JavaScript only. */
const TARGETS = {
  pyramid: { ...vsBox2D(1.9, 1.2), ...CONTACTS },
  pyramid100: { ...vsBox2D(2, 1.2), ...CONTACTS },
  pyramids: { ...vsBox2D(1.7, 1.1), ...CONTACTS },
  circles: { ...vsBox2D(1.5, 1), ...CONTACTS },
  rain: { ...vsBox2D(1.3, 0.9), ...CONTACTS },
  grid: { ...vsBox2D(1.6), ...JS },
  chains: { ...vsBox2D(1.2), ...JS },
  drum1000: { ...vsBox2D(1.5, 1), ...CONTACTS },
  drum2000: CONTACTS,
  pusher: CONTACTS,
  tiles: { ...vsBox2D(1), ...CONTACTS },
  addRemove: { ...vsBox2D(0.6), ...JS },
  bullets: { ...vsBox2D(2), ...JS },
  rays: { ...vsBox2D(0.6), ...JS },
  renewedRain: CONTACTS,
  tumbler: CONTACTS,
  smash: CONTACTS,
  spinner: CONTACTS,
  ragdolls: CONTACTS,
  barrel: CONTACTS,
  compounds: CONTACTS,
  largeCompounds: CONTACTS,
  largePyramid: CONTACTS,
  manyPyramids: CONTACTS,
};

/** ms. Medians that are aimed at as such. */
const TIMES = { asleep: 0.005 };
/** p99 over the median. */
const WORST = { renewedRain: 3 };

/** Each target of a scene: what, the value in this run, the most it may be, and whether it is met. */
export function judge(scene, cells) {
  const own = cells.phys2d;
  if (own?.median === undefined) {
    return [];
  }
  const against = Object.entries(TARGETS[scene] ?? JS)
    .filter(([engine]) => cells[engine]?.median !== undefined)
    .map(([engine, most]) => ({ what: `phys2d / ${engine}`, engine, value: own.median / cells[engine].median, most }));
  const time = scene in TIMES ? [{ what: 'median, ms', value: own.median, most: TIMES[scene] }] : [];
  const worst = scene in WORST ? [{ what: 'p99 / median', value: own.p99 / own.median, most: WORST[scene] }] : [];
  return [...against, ...time, ...worst].map((target) => ({ ...target, met: target.value <= target.most }));
}
