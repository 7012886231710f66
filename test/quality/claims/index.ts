export type { Claim, Figure } from './claim.js';
export { heavyChain, jointGrid, pendulum, stretchedChain } from './joints.js';
export { bounce, farAway, ramp, seams, spinningBox } from './motion.js';
export { ballStack, confinedDiscs, overlappingPyramid, pile } from './overlaps.js';
export { arch, cardHouse, dominoes } from './standing.js';
export { bigOnSmall, heavyPyramids, heavyTop, largePyramid, otherTowers, pyramid, tower } from './towers.js';
