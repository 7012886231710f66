import { expect, it } from 'vitest';
import { bot, Match } from '../../examples/rollback/match.js';
import { WINDOW } from '../../examples/rollback/peer.js';
import { phys2D } from '../../src/index.js';

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

it('shapes that are changed before they are added give the same hash after a rollback', () => {
  const corners = phys2D.createBoxVertices(1, 1);
  for (const shape of [phys2D.createPolygonShape({ vertices: corners }), phys2D.createCircleShape({ radius: 0.5 })]) {
    const world = phys2D.createWorld();
    world.addRigidBody(
      phys2D.createRigidBody({
        type: 'static',
        position: [0, 1],
        shapes: [phys2D.createPolygonShape({ vertices: corners })],
      }),
    );
    const body = phys2D.createRigidBody({ shapes: [shape] });
    const play = () => {
      if (shape.type === 'POLYGON') shape.setVertices(corners);
      shape.translate([0.1, 0]);
      shape.translate([-0.1, 0]);
      body.setPosition([0, 0]);
      body.setVelocity([0, 0]);
      world.addRigidBody(body);
      for (let i = 0; i < 10; i += 1) world.step(1 / 60);
      return world.hash();
    };
    const before = world.snapshot();
    const hash = play();
    world.restore(before);
    expect(play()).toBe(hash);
  }
});
