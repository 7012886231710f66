import { collideCirclePolygon, collidePolygonCircle } from '../collide/circles.js';
import { collidePolygons, polygonsIntersect } from '../collide/polygons.js';
import type { PolygonWorks } from '../collide/table.js';
import { putGroundsBack, smoothMeeting, smoothSeams } from './contacts/seams.js';

/** What polygons bring along: their kernels, and what keeps things from catching on the joints of tiles. */
export const polygonWorks: PolygonWorks = {
  collideCirclePolygon,
  collidePolygonCircle,
  collidePolygons,
  polygonsIntersect,
  smoothSeams,
  smoothMeeting,
  putGroundsBack,
};
