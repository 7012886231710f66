import type { Arbiter } from '../contact/arbiter.js';
import type { Circle } from '../shape/circle.js';
import type { Polygon } from '../shape/polygon.js';
import type { SolverData } from '../solver/data.js';
import type { Mover } from '../solver/impacts/movers.js';
import type { Start, Sweep } from '../solver/loops.js';
import type { World } from '../world.js';
import type { RayTest } from './rays.js';
import type { Round } from './round.js';
import type { Kernel } from './table.js';

/** Everything that only polygons need, from their collision kernels to contacts of two points; `solver/polygons.ts` implements it. */
export interface PolygonWorks {
  readonly collideCirclePolygon: Kernel<Circle, Polygon>;
  readonly collidePolygonCircle: Kernel<Polygon, Circle>;
  readonly collidePolygons: Kernel<Polygon, Polygon>;
  readonly collidePolygonsAlong: (a: Polygon, b: Polygon, n: Float64Array, o: number) => void;
  readonly polygonsIntersect: (a: Polygon, b: Polygon, n: Float64Array, o: number) => boolean;
  readonly findCorner: (round: Round, shape: Polygon, x: number, y: number) => boolean;
  readonly polygonContains: (shape: Polygon, point: Float64Array, tolerance: number) => boolean;
  readonly rayPolygon: (shape: Polygon, ray: RayTest) => boolean;
  readonly rememberFeatures: (pair: Arbiter) => void;
  readonly matchPoints: (pair: Arbiter) => void;
  readonly hasEdge: (shape: Polygon, nx: number, ny: number, angle: number) => boolean;
  readonly isBeyondEdge: (mover: Mover, shape: Polygon, bounds: Float64Array) => boolean;
  readonly smoothSeams: (world: World) => void;
  readonly smoothMeeting: (world: World, pair: Arbiter) => void;
  readonly putGroundsBack: (world: World, pair: Arbiter) => void;
  readonly packTwo: (data: SolverData, index: number) => void;
  readonly warmStartTwo: Start;
  readonly solveVelocityTwo: Sweep;
  readonly solvePositionTwo: Sweep;
  readonly storeTwo: (data: SolverData, index: number, stamp: number) => void;
}

/** `null` until the first polygon is made. */
export let works: PolygonWorks | null = null;

/** Called before a polygon is made. So a bundle without polygons has no code for them. */
export function bringPolygons(brought: PolygonWorks): void {
  works = brought;
}
