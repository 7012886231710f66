/** ms. How long something takes at best, of several times. */
export function bestTime(action: () => void): number {
  let best = Infinity;
  for (let round = 0; round < 8; round += 1) {
    const start = performance.now();
    action();
    best = Math.min(best, performance.now() - start);
  }
  return best;
}
