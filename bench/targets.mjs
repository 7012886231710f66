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

/** mm. How wide the narrowest body of a scene is, by scene; in those that are not here 1 m. */
const WIDTHS = {
  circles: 600,
  rain: 300,
  renewedRain: 300,
  pusher: 580,
  grid: 800,
  grid100: 800,
  chains: 100,
  ragdolls: 140,
  smash: 400,
  barrel: 300,
  compounds: 500,
};

/** Figures that may be as large as a body is wide. Those of other scenes are counts, of which none may differ from what it should be. */
const LENGTHS = ['worst sag, mm', 'deepest overlap, mm', 'widest gap, mm'];
/** Counts that should be 0. */
const LOSSES = ['escaped', 'bodies left'];

/**
 * Whether an engine keeps its quality: nothing escapes or is left behind, and nothing sags, overlaps or gapes by more than the narrowest body of the scene is
 * wide. What does not do that saves the time that the scene is about.
 */
export function keepsQuality(scene, figure, quality) {
  if (LOSSES.includes(figure)) {
    return quality === 0;
  }
  return !LENGTHS.includes(figure) || quality <= (WIDTHS[scene] ?? 1000);
}

/**
 * Each target of a scene: what, the value in this run, the most it may be, and whether it is met. Beside an engine that does not keep its quality
 * there is nothing to meet or miss: it is `lost`. If phys2d does not, none is met.
 */
export function judge(scene, figure, cells) {
  const own = cells.phys2d;
  if (own?.median === undefined) {
    return [];
  }
  const keeps = ({ quality }) => keepsQuality(scene, figure, quality);
  const against = Object.entries(TARGETS[scene] ?? JS)
    .filter(([engine]) => cells[engine]?.median !== undefined)
    .map(([engine, most]) => {
      const { median } = cells[engine];
      return { what: `phys2d / ${engine}`, engine, value: own.median / median, most, lost: !keeps(cells[engine]) };
    });
  const time = scene in TIMES ? [{ what: 'median, ms', value: own.median, most: TIMES[scene] }] : [];
  const worst = scene in WORST ? [{ what: 'p99 / median', value: own.p99 / own.median, most: WORST[scene] }] : [];
  return [...against, ...time, ...worst].map((target) => ({
    ...target,
    met: keeps(own) && target.value <= target.most,
  }));
}
