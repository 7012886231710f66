import { collideCirclePolygon, collidePolygonCircle } from '../collide/circles.js';
import { polygonContains } from '../collide/contains.js';
import type { PolygonWorks } from '../collide/polygon-works.js';
import { collidePolygons, collidePolygonsAlong, polygonsIntersect } from '../collide/polygons.js';
import { rayPolygon } from '../collide/rays.js';
import { findCorner } from '../collide/round.js';
import { hasEdge } from '../contact/at-end.js';
import { matchPoints, rememberFeatures } from '../contact/features.js';
import { putGroundsBack } from './contacts/grounds.js';
import { packTwo } from './contacts/pack-contacts.js';
import { smoothMeeting, smoothSeams } from './contacts/seams.js';
import { storeTwo } from './contacts/store-contacts.js';
import { solvePositionTwo, solveVelocityTwo, warmStartTwo } from './contacts/two-point.js';
import { isBeyondEdge } from './impacts/swept-bounds.js';

/**
 * What polygons bring along: their collision kernels, what keeps things from catching on the seams of tiles, and contacts of two points.
 */
export const polygonWorks: PolygonWorks = {
  collideCirclePolygon,
  collidePolygonCircle,
  collidePolygons,
  collidePolygonsAlong,
  polygonsIntersect,
  findCorner,
  rayPolygon,
  polygonContains,
  hasEdge,
  rememberFeatures,
  matchPoints,
  isBeyondEdge,
  smoothSeams,
  smoothMeeting,
  putGroundsBack,
  packTwo,
  warmStartTwo,
  solveVelocityTwo,
  solvePositionTwo,
  storeTwo,
};
