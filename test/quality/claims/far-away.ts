import type { Physics2DDevice, RigidBody, World } from '../../../src/index.js';
import { buildPyramid } from '../../scenes/pyramid.js';
import { buildTower } from '../../scenes/stacks.js';
import { type Claim, DT, type Figure } from './claim.js';

/** The steps until each of the bodies sleeps, and where they are then, relative to `at`. */
function settle(phys2D: Physics2DDevice, at: number, build: (world: World) => RigidBody[]) {
  const world = phys2D.createWorld({ gravity: [0, 10] });
  const bodies = build(world);
  let step = 0;
  while (step < 3000 && !bodies.every(({ sleeping }) => sleeping)) {
    world.step(DT);
    step += 1;
  }
  return { step, places: bodies.flatMap((body) => [body.getPosition()[0] - at, body.getPosition()[1]]) };
}

export const farAway: Claim = {
  scene: 'tower of 15 and pyramid of base 10, 1e5 m and 1e7 m away from the origin',
  measure(phys2D): Figure[] {
    const tower = (at: number) => (world: World) =>
      buildTower(phys2D, world, { count: 15, offset: 2 ** -7, friction: 0.5, at: [at, 0] });
    const pyramid = (at: number) => (world: World) => buildPyramid(phys2D, world, 10, at);
    return [
      { what: 'tower', build: tower },
      { what: 'pyramid', build: pyramid },
    ].flatMap(({ what, build }) => {
      const here = settle(phys2D, 0, build(0));
      return [1e5, 1e7].flatMap((at) => {
        const there = settle(phys2D, at, build(at));
        const off = Math.max(...there.places.map((place, i) => Math.abs(place - here.places[i]!)));
        return [
          {
            what: `${what}, ${at.toExponential(0)} m: steps until asleep differ by`,
            value: Math.abs(there.step - here.step),
            unit: '',
            limit: 0,
          },
          { what: `${what}, ${at.toExponential(0)} m: places differ by`, value: off, unit: 'm', limit: 1e-6 },
        ];
      });
    });
  },
};
