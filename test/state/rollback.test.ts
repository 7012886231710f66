import { expect, it } from 'vitest';
import { bot, Match } from '../../examples/rollback/match.js';
import { WINDOW } from '../../examples/rollback/peer.js';

const FRAMES = 2500;

it(`two peers, 100 ms and 5 % loss apart, never differ in ${FRAMES} frames`, () => {
  const match = new Match();
  const bots = [bot(5), bot(6)];
  for (let i = 0; i < FRAMES; i += 1) {
    match.advance(bots.map((act) => act()));
    for (const peer of match.peers) {
      expect(peer.frame - peer.known).toBeLessThanOrEqual(WINDOW);
    }
  }
  const [a, b] = match.peers;
  console.log(
    `${match.compared} frames compared; ${a.rollbacks} and ${b.rollbacks} rollbacks, ${a.waits} and ${b.waits} waits, ` +
      `${a.game.crates.length} crates, ${a.game.numbers[0]} : ${a.game.numbers[1]}`,
  );
  expect(match.diverged).toBe(-1);
  expect(match.compared).toBeGreaterThan(0.9 * FRAMES);
  expect(Math.min(a.rollbacks, b.rollbacks)).toBeGreaterThan(100);
  expect(a.game.crates).toHaveLength(10);
  // Predictions that were never right would show nothing: states that were taken back differ from those that came of it.
  expect(new Set(a.hashes.slice(0, match.compared)).size).toBeGreaterThan(0.9 * match.compared);
}, 60_000);
