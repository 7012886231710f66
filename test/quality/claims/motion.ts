import type { Physics2DDevice, RigidBody, World } from '../../../src/index.js';
import { buildPyramid } from '../../scenes/pyramid.js';
import { add, buildTower, plainMaterial } from '../../scenes/stacks.js';
import { type Claim, DT, type Figure, run } from './claim.js';

export const spinningBox: Claim = {
  scene: 'box that flies and spins freely, 60 s',
  measure(phys2D): Figure[] {
    const world = phys2D.createWorld({ gravity: [0, 0], allowSleeping: false });
    const material = plainMaterial(phys2D, 0.6);
    const shape = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(2, 1), material });
    const body = add(phys2D, world, shape, [0, 0], { velocity: [3, -2], angularVelocity: 7 });
    const energy = (): number => {
      const [vx, vy] = body.getVelocity();
      return 0.5 * 2 * (vx * vx + vy * vy) + 0.5 * (10 / 12) * body.getAngularVelocity() ** 2;
    };
    const start = energy();
    let most = 0;
    run(world, 60, () => {
      most = Math.max(most, energy() / start - 1);
    });
    return [{ what: 'energy above the start', value: most, unit: '', limit: 1e-12 }];
  },
};

/** Heights of the apexes of a ball that falls 4 m, as shares of that of the one before. */
function apexRatios(phys2D: Physics2DDevice, elasticity: number, bounces: number): number[] {
  const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
  const material = phys2D.createMaterial({ elasticity, staticFriction: 0, dynamicFriction: 0, rollingFriction: 0 });
  const ground = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(20, 2), material });
  add(phys2D, world, ground, [0, 1], { type: 'static' });
  const ball = add(phys2D, world, phys2D.createCircleShape({ radius: 0.25, material }), [0, -4.25]);
  const heights = [4];
  let rose = false;
  let highest = 0;
  for (let i = 0; i < 6000 && heights.length <= bounces; i += 1) {
    world.step(DT);
    const [, vy] = ball.getVelocity();
    const height = -0.25 - ball.getPosition()[1];
    if (vy < 0) {
      highest = rose ? Math.max(highest, height) : height;
      rose = true;
    } else if (rose) {
      heights.push(highest);
      rose = false;
    }
  }
  return heights.slice(1).map((height, i) => height / heights[i]!);
}

export const bounce: Claim = {
  scene: 'ball that falls 4 m',
  measure(phys2D): Figure[] {
    const off = (elasticity: number, bounces: number): number => {
      const ratios = apexRatios(phys2D, elasticity, bounces);
      const missing = ratios.length < bounces ? Infinity : 0;
      return Math.max(missing, ...ratios.map((ratio) => Math.abs(ratio - elasticity * elasticity)));
    };
    return [
      { what: 'elasticity 1, ten bounces: apex ratio off', value: off(1, 10), unit: '', limit: 0.005 },
      // After the third its impacts are slower than what bounces at all.
      { what: 'elasticity 0.5, three bounces: apex ratio off', value: off(0.5, 3), unit: '', limit: 0.01 },
    ];
  },
};

const SLOPE = (20 * Math.PI) / 180;

/** A 1 m box on a slope of 20°. @returns it. */
function onRamp(phys2D: Physics2DDevice, world: World, friction: number): RigidBody {
  const material = plainMaterial(phys2D, friction);
  const ramp = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(400, 2), material });
  const [c, s] = [Math.cos(SLOPE), Math.sin(SLOPE)];
  add(phys2D, world, ramp, [-s, c], { type: 'static', rotation: SLOPE });
  const box = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1, 1), material });
  return add(phys2D, world, box, [0.5 * s, -0.5 * c], { rotation: SLOPE });
}

/** How far it has slid down the slope, m. */
function slid(body: RigidBody): number {
  const [x, y] = body.getPosition();
  return x * Math.cos(SLOPE) + y * Math.sin(SLOPE);
}

export const ramp: Claim = {
  scene: 'box on a slope of 20°',
  measure(phys2D): Figure[] {
    const sliding = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const box = onRamp(phys2D, sliding, 0.2);
    run(sliding, 3);
    const expected = 0.5 * 10 * (Math.sin(SLOPE) - 0.2 * Math.cos(SLOPE)) * 9;
    const holding = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const held = onRamp(phys2D, holding, 0.5);
    run(holding, 1);
    const start = slid(held);
    run(holding, 60);
    return [
      {
        what: 'friction 0.2: distance off in 3 s',
        value: 100 * Math.abs(slid(box) / expected - 1),
        unit: '%',
        limit: 0.15,
      },
      { what: 'friction 0.5: creep in 60 s', value: Math.abs(slid(held) - start), unit: 'm', limit: 1e-6 },
    ];
  },
};

/** A box at 5 m/s over 60 tiles. @returns its least speed and highest hop. */
function overTiles(phys2D: Physics2DDevice, offset: number, oneBody: boolean): { speed: number; hop: number } {
  const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
  const material = plainMaterial(phys2D, 0);
  const tile = (x: number) =>
    phys2D.createPolygonShape({ vertices: phys2D.createRectangleVertices(x, 0, x + 1, 1), material });
  const shapes = Array.from({ length: 60 }, (_, i) => tile(i));
  for (const group of oneBody ? [shapes] : shapes.map((shape) => [shape])) {
    world.addRigidBody(phys2D.createRigidBody({ type: 'static', position: [0, 0], shapes: group }));
  }
  const box = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1, 1), material });
  const body = add(phys2D, world, box, [1 + offset, -0.5], { velocity: [5, 0] });
  let speed = 5;
  let hop = 0;
  run(world, 11, () => {
    speed = Math.min(speed, body.getVelocity()[0]);
    hop = Math.max(hop, -0.5 - body.getPosition()[1]);
  });
  return { speed: speed / 5, hop };
}

export const seams: Claim = {
  scene: 'box at 5 m/s over 60 flush tiles, 20 offsets, friction 0',
  measure(phys2D): Figure[] {
    return [false, true].flatMap((oneBody) => {
      const runs = Array.from({ length: 20 }, (_, i) => overTiles(phys2D, i / 20, oneBody));
      const what = oneBody ? 'shapes of one body' : 'bodies of their own';
      return [
        { what: `${what}: runs that snag`, value: runs.filter(({ speed }) => speed < 0.9).length, unit: '', limit: 0 },
        { what: `${what}: speed lost`, value: 1 - Math.min(...runs.map(({ speed }) => speed)), unit: '', limit: 0.001 },
        { what: `${what}: highest hop`, value: Math.max(...runs.map(({ hop }) => hop)), unit: 'm', limit: 0.001 },
      ];
    });
  },
};

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
