import {
  barrel,
  compounds,
  largeCompounds,
  largePyramid,
  manyPyramids,
  ragdolls,
  smash,
  spinner,
  tumbler,
} from './box2d.js';
import { chains, gridOf } from './jointed.js';
import { circlesOf, pusher, pyramidsOf, rain, renewedRain } from './piles.js';
import type { SpeedScene } from './scene.js';
import { addRemove, asleep, bullets, drumOf, tiles } from './worlds.js';

export { stateHash } from '../hash.js';
export { generator } from '../mixed.js';
export { buildPyramid } from '../pyramid.js';
export { pyramidsOf } from './piles.js';
export { DT, type SpeedRun, type SpeedScene } from './scene.js';

/** The scenes of the bench, by the names that its command line takes. */
export const scenes: Readonly<Record<string, SpeedScene>> = {
  pyramid: pyramidsOf(40, 1),
  pyramid100: pyramidsOf(100, 1),
  pyramids: pyramidsOf(10, 25),
  circles: circlesOf(32, 62.5),
  circles8000: circlesOf(64, 125),
  rain,
  grid: gridOf(40),
  grid100: gridOf(100),
  chains,
  drum1000: drumOf(1000),
  drum2000: drumOf(2000),
  pusher,
  tiles,
  asleep,
  addRemove,
  bullets,
  renewedRain,
  largePyramid,
  manyPyramids,
  tumbler,
  smash,
  spinner,
  ragdolls,
  barrel,
  compounds,
  largeCompounds,
};
