import type { Mover, Movers } from './movers.js';

/**
 * The share of the change of a body's velocity in the step that had happened by the time to which it was moved on its way. How far the body
 * went in the step tells when it happened: a motor, or a stop, may do it all at once. It is assumed to have happened at a constant rate,
 * early or late in the step. Where the change was even, by as much in each sub-step, the speed grows with the root of the way, as that of
 * what falls.
 */
export function shareOfChange(mover: Mover, { duration }: Movers, substeps: number): number {
  const { body, at } = mover;
  const { radius } = body;
  // All three as speeds, m/s: before, after, and on the average.
  const [x, y, w] = [mover.vx, mover.vy, mover.w * radius];
  const [endX, endY, endW] = [body.vx, body.vy, body.w * radius];
  const [wayX, wayY, wayW] = [body.lastDx / duration, body.lastDy / duration, (body.lastTurn * radius) / duration];
  const [dx, dy, dw] = [endX - x, endY - y, endW - w];
  const speed = Math.sqrt(wayX * wayX + wayY * wayY + wayW * wayW);
  const even = ((dx * dx + dy * dy + dw * dw) * (substeps - 1)) / (2 * substeps);
  if (!(even > 0 && speed > 0)) {
    return at;
  }
  // 0: all at the start of the step, 1: evenly, 2: at its end.
  const lag = (dx * (endX - wayX) + dy * (endY - wayY) + dw * (endW - wayW)) / even;
  const span = Math.max(0, lag < 1 ? lag : 2 - lag);
  const start = lag < 1 ? 0 : 1 - span;
  const before = (x * wayX + y * wayY + w * wayW) / speed;
  const gain = (dx * wayX + dy * wayY + dw * wayW) / speed;
  const rest = at * speed - before * start;
  if (rest <= 0 || span === 0) {
    return rest > 0 ? 1 : 0;
  }
  // rest = before · t + gain / span · t² / 2
  const root = Math.sqrt(Math.max(0, before * before + (2 * gain * rest) / span));
  const time = (2 * rest) / (before + root);
  return time >= 0 && time < span ? time / span : 1;
}
