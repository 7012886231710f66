import { describe, expect, it } from 'vitest';
import { sceneOf, scenes } from '../../playground/scenes.js';
import { type PointConstraint, phys2D, type RigidBody, type World } from '../../src/index.js';
import { buildCallbacks, DECKS } from './callbacks.js';
import { buildCradle, STRING } from './cradle.js';
import { buildCrowd, CROWD_SIDE } from './crowd.js';
import { stateHash } from './hash.js';
import { buildHills } from './hills.js';
import { worstGap } from './joint-grid.js';
import { buildLoadedRopes } from './loaded-ropes.js';
import { buildMaterials } from './materials.js';
import { buildPinball, TABLE } from './pinball.js';
import { buildPlatformer } from './platformer.js';
import { type Controls, HANDS_OFF, type Play } from './play.js';
import { buildSoftBodies } from './soft-body.js';
import { buildArch, buildCardHouse, buildDominoes } from './standing.js';
import { buildThinWalls } from './thin-walls.js';
import { buildTileRun, RUN_SPEED } from './tile-run.js';
import { buildTopDown } from './top-down.js';
import { buildBreakableWall } from './wall.js';
import { buildWreckingBall } from './wrecking-ball.js';

// What the scenes of the playground promise, beyond what scenes.test.ts and joints.test.ts check of those with joints.

const DT = 1 / 60;

/** Runs a scene for so many seconds. `hold` says which keys are down. */
function run(
  world: World,
  seconds: number,
  play: Play = {},
  each: (time: number) => void = () => {},
  hold: Partial<Controls> | ((time: number) => Partial<Controls>) = {},
): void {
  for (let i = 1; i <= Math.round(60 * seconds); i += 1) {
    play.beforeStep?.({ ...HANDS_OFF, ...(typeof hold === 'function' ? hold(i / 60) : hold) });
    world.step(DT);
    each(i / 60);
  }
}

const xs = (bodies: readonly RigidBody[]): number[] => bodies.map((body) => body.getPosition()[0]);
const ys = (bodies: readonly RigidBody[]): number[] => bodies.map((body) => body.getPosition()[1]);

describe('every scene of the playground', { timeout: 120_000 }, () => {
  it('has a name of its own', () => {
    expect(scenes.length).toBeGreaterThanOrEqual(24);
    expect(new Set(scenes.map(({ id }) => id)).size).toBe(scenes.length);
    expect(new Set(scenes.map(({ title }) => title)).size).toBe(scenes.length);
    expect(sceneOf('arch').title).toBe('Arch');
    expect(sceneOf('no such scene')).toBe(scenes[0]);
  });

  it.each(scenes.map(({ id }) => id))('%s: starts in view, moves, and ends the same twice', (id) => {
    const scene = sceneOf(id);
    const ends = [0, 1].map(() => {
      const world = phys2D.createWorld({ gravity: scene.gravity ?? [0, 10] });
      const play = scene.build(phys2D, world);
      const [minX, minY, maxX, maxY] = scene.view;
      const moving = world.rigidBodies.filter((body) => !body.isStatic());
      const seen = moving.filter((body) => {
        const [x, y] = body.getPosition();
        return x > minX && x < maxX && y > minY && y < maxY;
      });
      expect(seen.length).toBeGreaterThan(0);
      const before = stateHash(world);
      run(world, moving.length > 150 ? 0.25 : 2, play);
      expect(stateHash(world)).not.toBe(before);
      for (const body of moving) {
        expect(body.getPosition().every(Number.isFinite)).toBe(true);
      }
      return stateHash(world);
    });
    expect(ends[1]).toBe(ends[0]);
  });
});

describe('classics', () => {
  it('materials go round, and nothing is crushed or lost', () => {
    const world = phys2D.createWorld();
    const scene = buildMaterials(phys2D, world);
    const above = new Set<RigidBody>();
    let back = 0;
    run(world, 40, scene, () => {
      for (const body of scene.goods) {
        const [x, y] = body.getPosition();
        if (y < -6 && x < 5) {
          above.add(body);
        } else if (y > -3 && x < 0 && above.has(body)) {
          above.delete(body);
          back += 1;
        }
      }
    });
    console.log(`materials: ${back} rounds in 40 s`);
    expect(back).toBeGreaterThan(5);
    expect(Math.max(...ys(scene.goods))).toBeLessThan(0);
    expect(Math.min(...ys(scene.goods))).toBeGreaterThan(-9);
    expect(Math.max(...xs(scene.goods).map(Math.abs))).toBeLessThan(10);
  });

  it('one-way platforms let through from below only, and the sensor throws', () => {
    const world = phys2D.createWorld();
    const scene = buildCallbacks(phys2D, world);
    let up = 0;
    let down = 0;
    let stood = new Set<RigidBody>();
    const all = new Set<RigidBody>();
    let last = scene.travellers.map((body) => body.getPosition());
    run(world, 30, scene, () => {
      stood = new Set();
      scene.platforms.forEach((deck, i) => {
        const [x1, , x2] = deck.computeWorldBounds();
        const top = DECKS[i]!;
        scene.travellers.forEach((body, k) => {
          const [x, y] = body.getPosition();
          const before = last[k]![1];
          if (x > x1! && x < x2!) {
            up += before > top && y <= top ? 1 : 0;
            down += before < top - 0.1 && y >= top + 0.1 ? 1 : 0;
          }
        });
        const held = deck.shapes[0]!.arbiters.filter(({ active }) => active);
        if (held.some(({ contacts }) => contacts.length > 0)) {
          stood.add(deck);
          all.add(deck);
        }
      });
      last = scene.travellers.map((body) => body.getPosition());
    });
    console.log(`callbacks: ${scene.launches()} launches, ${up} passes upward`);
    expect(scene.launches()).toBeGreaterThan(15);
    expect(up).toBeGreaterThan(15);
    expect(down).toBe(0);
    expect(all.size).toBe(DECKS.length);
    expect(Math.max(...ys(scene.travellers))).toBeLessThan(0.4);
  });
});

describe('stacks', () => {
  it('the pyramid and the tower stand still', () => {
    for (const id of ['pyramid', 'tower']) {
      const world = phys2D.createWorld();
      sceneOf(id).build(phys2D, world);
      const boxes = world.rigidBodies.filter((body) => body.isDynamic());
      const before = boxes.map((body) => body.getPosition());
      run(world, 5);
      const moved = boxes.map((body, i) => {
        const [x, y] = body.getPosition();
        return Math.abs(x - before[i]![0]) + Math.abs(y - before[i]![1]);
      });
      expect(world.liveDynamics).toHaveLength(0);
      expect(Math.max(...moved)).toBeLessThan(0.05);
    }
  });

  it('all dominoes fall, from left to right', () => {
    const world = phys2D.createWorld();
    const dominoes = buildDominoes(phys2D, world);
    const fell: number[] = [];
    run(world, 10, {}, () => {
      dominoes.forEach((body, i) => {
        if (Math.abs(body.getRotation()) > 0.5 && !fell.includes(i)) {
          fell.push(i);
        }
      });
    });
    expect(fell).toEqual(dominoes.map((_, i) => i));
  });

  it('the arch and the house of cards stand', () => {
    for (const build of [buildArch, buildCardHouse]) {
      const world = phys2D.createWorld();
      const bodies = build(phys2D, world);
      const before = bodies.map((body) => body.getPosition());
      const size = -Math.min(...ys(bodies));
      run(world, 5);
      const sunk = bodies.map((body, i) => body.getPosition()[1] - before[i]![1]);
      expect(Math.max(...sunk)).toBeLessThan(0.02 * size);
      expect(world.liveDynamics).toHaveLength(0);
    }
  });

  it('the wall holds by itself, and breaks where it is hit', () => {
    const world = phys2D.createWorld();
    const { balls, welds, bricks, broken } = buildBreakableWall(phys2D, world);
    const start = xs(bricks);
    let first = Infinity;
    let hit = Infinity;
    run(world, 6, {}, (time) => {
      const touches = balls.some(({ shapes }) => shapes[0]!.arbiters.some(({ active }) => active));
      hit = Math.min(hit, touches ? time : Infinity);
      first = Math.min(first, broken() > 0 ? time : Infinity);
    });
    console.log(`wall: ${broken()} of ${welds.length} welds broke, the first at ${first.toFixed(2)} s`);
    expect(hit).toBeLessThan(2);
    expect(first).toBeGreaterThanOrEqual(hit - DT / 2);
    expect(broken()).toBeGreaterThan(5);
    expect(broken()).toBeLessThan(welds.length);
    expect(xs(bricks).filter((x, i) => x - start[i]! > 0.5).length).toBeGreaterThan(5);
  });
});

describe('joints', () => {
  it('the wrecking ball tears the crates down, its chain holds', () => {
    const world = phys2D.createWorld();
    const { joints, crates, ball } = buildWreckingBall(phys2D, world);
    const start = xs(crates);
    let gap = 0;
    let fastest = 0;
    run(world, 8, {}, () => {
      gap = Math.max(gap, worstGap(joints as PointConstraint[]));
      fastest = Math.max(fastest, ball.getVelocity()[0]);
    });
    const moved = xs(crates).filter((x, i) => x - start[i]! > 0.5).length;
    console.log(`wrecking ball: ${moved} crates moved, gaps up to ${(1000 * gap).toFixed(1)} mm`);
    expect(moved).toBeGreaterThan(crates.length / 2);
    expect(fastest).toBeGreaterThan(8);
    expect(gap).toBeLessThan(0.03);
  });

  it('ropes are held by the friction of a drum, slide off one without, and turn a wheel', () => {
    const world = phys2D.createWorld();
    const ropes = buildLoadedRopes(phys2D, world);
    const heights = () => ropes.map(({ loads }) => loads[1]!.getPosition()[1]);
    const start = heights();
    let gap = 0;
    run(world, 1.5, {}, () => {
      gap = Math.max(gap, ...ropes.map(({ joints }) => worstGap(joints)));
    });
    const [held, slid, turned] = heights().map((y, i) => y - start[i]!);
    console.log(
      `ropes: fell ${held!.toFixed(2)}, ${slid!.toFixed(2)}, ${turned!.toFixed(2)} m, gaps up to ${(1000 * gap).toFixed(1)} mm`,
    );
    expect(held).toBeLessThan(0.15);
    expect(slid).toBeGreaterThan(0.5);
    expect(turned).toBeGreaterThan(0.3);
    expect(gap).toBeLessThan(0.03);
  });

  it("Newton's cradle passes the swing on", () => {
    const world = phys2D.createWorld();
    const balls = buildCradle(phys2D, world);
    const start = ys(balls);
    let [right, inner] = [0, 0];
    let stretch = 0;
    run(world, 2.3, {}, () => {
      right = Math.max(right, start[4]! - balls[4]!.getPosition()[1]);
      inner = Math.max(inner, ...balls.slice(1, 4).map((ball, i) => start[i + 1]! - ball.getPosition()[1]));
      balls.forEach((ball, i) => {
        const [x, y] = ball.getPosition();
        stretch = Math.max(stretch, Math.abs(Math.hypot(x - 1.002 * (i - 2), y + STRING) - STRING));
      });
    });
    const height = start[4]! - start[0]!;
    console.log(`cradle: the last rises to ${((100 * right) / height).toFixed(0)} % of the first`);
    expect(right).toBeGreaterThan(0.95 * height);
    expect(right).toBeLessThan(1.02 * height);
    expect(inner).toBeLessThan(0.01 * height);
    expect(stretch).toBeLessThan(0.005);
  });

  it('soft bodies give way and get back their size', () => {
    const world = phys2D.createWorld();
    const bodies = buildSoftBodies(phys2D, world);
    const whole = bodies[0]!.area();
    const least = bodies.map(() => whole);
    run(world, 12, {}, () => {
      bodies.forEach((body, i) => {
        least[i] = Math.min(least[i]!, body.area());
      });
    });
    const ends = bodies.map((body) => body.area() / whole);
    console.log(
      `soft: down to ${least.map((area) => (area / whole).toFixed(2))}, in the end ${ends.map((x) => x.toFixed(2))}`,
    );
    for (const area of least) {
      expect(area).toBeLessThan(0.95 * whole);
      expect(area).toBeGreaterThan(0.5 * whole);
    }
    for (const end of ends) {
      expect(end).toBeGreaterThan(0.9);
      expect(end).toBeLessThan(1.02);
    }
  });

  it('the net hangs together', () => {
    const world = phys2D.createWorld();
    sceneOf('grid').build(phys2D, world);
    run(world, 4);
    expect(world.constraints.length).toBe(2 * 20 * 19);
    expect(worstGap(world.constraints as PointConstraint[])).toBeLessThan(0.01);
  });
});

describe('play', () => {
  it('the car climbs its hills, and obeys', () => {
    const world = phys2D.createWorld();
    const play = buildHills(phys2D, world);
    const car = play.chassis;
    const [, start] = car.getPosition();
    let highest = start;
    run(world, 8, play, () => {
      highest = Math.min(highest, car.getPosition()[1]);
    });
    const [x] = car.getPosition();
    expect(x).toBeGreaterThan(20);
    expect(highest).toBeLessThan(start - 1);
    run(world, 5, play, undefined, { left: true });
    expect(car.getVelocity()[0]).toBeLessThan(-2);
    let farthest = x;
    run(world, 24, play, () => {
      farthest = Math.max(farthest, car.getPosition()[0]);
    });
    expect(farthest).toBeGreaterThan(45);
    expect(farthest).toBeLessThan(54);
    expect(car.getPosition()[0]).toBeLessThan(farthest - 5);
    expect(Math.abs(car.getRotation())).toBeLessThan(0.7);
  });

  it('the player runs, jumps, rides on platforms, stands on ledges, takes coins', () => {
    const world = phys2D.createWorld();
    const scene = buildPlatformer(phys2D, world);
    const { player, platforms } = scene;
    run(world, 1, scene);
    const ground = player.getPosition()[1];
    expect(ground).toBeCloseTo(-0.7, 2);
    let top = ground;
    run(
      world,
      2.2,
      scene,
      () => {
        top = Math.min(top, player.getPosition()[1]);
      },
      (time) => ({ up: time < 0.1 }),
    );
    // v² / 2g
    expect(ground - top).toBeGreaterThan(0.9 * (81 / 20));
    expect(ground - top).toBeLessThan(1.02 * (81 / 20));
    expect(player.getPosition()[1]).toBeCloseTo(ground, 2);
    const [before] = player.getPosition();
    run(world, 0.5, scene, undefined, { right: true });
    expect(player.getPosition()[0] - before).toBeGreaterThan(0.8 * 6 * 0.5);
    expect(player.getVelocity()[0]).toBeCloseTo(6, 1);

    const [lift] = platforms;
    player.setPosition([lift!.getPosition()[0], lift!.getPosition()[1] - 0.9]);
    player.setVelocity([0, 0]);
    run(world, 0.5, scene);
    const offset = player.getPosition()[0] - lift!.getPosition()[0];
    let ridden = 0;
    let slip = 0;
    let last = lift!.getPosition()[0];
    run(world, 6, scene, () => {
      const [x] = lift!.getPosition();
      ridden += Math.abs(x - last);
      last = x;
      slip = Math.max(slip, Math.abs(player.getPosition()[0] - x - offset));
    });
    expect(ridden).toBeGreaterThan(6);
    expect(slip).toBeLessThan(0.1);

    player.setPosition([-1.5, -0.7]);
    player.setVelocity([0, 0]);
    run(world, 2, scene, undefined, (time) => ({ up: time < 0.1 }));
    expect(player.getPosition()[1]).toBeCloseTo(-1.8 - 0.7, 1);
    expect(scene.coins()).toBeGreaterThanOrEqual(1);
  });

  it('the car seen from above goes round by itself, turns where it is steered, and stops', () => {
    const world = phys2D.createWorld({ gravity: [0, 0] });
    const scene = buildTopDown(phys2D, world);
    const { car, cones } = scene;
    const sides = new Set<string>();
    run(world, 20, scene, () => {
      const [x, y] = car.getPosition();
      sides.add(`${x > 0} ${y > 0}`);
    });
    expect(sides.size).toBe(4);
    run(world, 8, scene, undefined, (time) => ({ up: time < 0.1 }));
    expect(Math.hypot(...car.getVelocity())).toBeLessThan(0.5);
    expect(world.rigidBodies).toHaveLength(cones.length + 8);
    car.setPosition([0, 4.4]);
    car.setRotation(0);
    car.setVelocity([0, 0]);
    car.setAngularVelocity(0);
    run(world, 1, scene, undefined, { up: true });
    expect(car.getRotation()).toBeCloseTo(0, 2);
    expect(car.getPosition()[0]).toBeGreaterThan(2);
    run(world, 0.7, scene, undefined, { up: true, right: true });
    expect(car.getRotation()).toBeGreaterThan(0.3);
  });

  it('the ball stays on the table, hits bumpers, comes back; flippers obey', () => {
    const world = phys2D.createWorld({ gravity: [0, 5] });
    const scene = buildPinball(phys2D, world);
    const { ball, flippers } = scene;
    run(world, 30, scene, () => {
      const [x, y] = ball.getPosition();
      expect(Math.abs(x)).toBeLessThan(TABLE[0]);
      expect(y).toBeGreaterThan(-TABLE[1]);
      expect(y).toBeLessThan(2.5);
    });
    console.log(`pinball: ${scene.score()} bumpers in 30 s`);
    expect(scene.score()).toBeGreaterThan(10);
    run(world, 0.5, scene, undefined, { left: true });
    expect(flippers[0]!.getRotation()).toBeCloseTo(-0.5, 1);
    expect(flippers[1]!.getRotation()).toBeCloseTo(-0.5, 1);
    run(world, 0.5, scene, undefined, { right: true });
    expect(flippers[0]!.getRotation()).toBeCloseTo(0.5, 1);
    expect(flippers[1]!.getRotation()).toBeCloseTo(0.5, 1);
  });
});

describe('speed and size', { timeout: 120_000 }, () => {
  it('no bullet leaves its cell', () => {
    const world = phys2D.createWorld({ gravity: [0, 0] });
    const { bullets, escaped } = buildThinWalls(phys2D, world);
    run(world, 10);
    expect(escaped()).toBe(0);
    expect(Math.min(...bullets.map((body) => Math.hypot(...body.getVelocity())))).toBeGreaterThan(100);
  });

  it('nothing catches on the joints of tiles', () => {
    const world = phys2D.createWorld();
    const riders = buildTileRun(phys2D, world);
    const heights = ys(riders);
    let [lifted, slow, turned] = [0, Infinity, 0];
    run(world, 20, {}, () => {
      riders.forEach((body, i) => {
        lifted = Math.max(lifted, Math.abs(body.getPosition()[1] - heights[i]!));
        turned = Math.max(turned, Math.abs(body.getRotation()));
        slow = Math.min(slow, Math.abs(body.getVelocity()[0]));
      });
    });
    console.log(`tiles: ${(1000 * lifted).toFixed(2)} mm, ${turned.toExponential(1)} rad, ${slow.toFixed(2)} m/s`);
    expect(lifted).toBeLessThan(0.01);
    expect(turned).toBeLessThan(0.01);
    expect(slow).toBeGreaterThan(0.98 * RUN_SPEED);
  });

  it('drum and rain keep what they hold', () => {
    const drum = phys2D.createWorld();
    sceneOf('drum').build(phys2D, drum);
    run(drum, 3);
    const radius = Math.max(...drum.rigidBodies.map((body) => Math.hypot(...body.getPosition())));
    expect(radius).toBeLessThan(0.5 * Math.max(...drum.rigidBodies[0]!.computeWorldBounds()) * 2);
    const rain = phys2D.createWorld();
    sceneOf('rain').build(phys2D, rain);
    run(rain, 2);
    const bodies = rain.rigidBodies.filter((body) => body.isDynamic());
    expect(bodies).toHaveLength(1000);
    expect(Math.max(...xs(bodies).map(Math.abs))).toBeLessThan(10);
    expect(Math.max(...ys(bodies))).toBeLessThan(0);
  });

  it('5,000 bodies fall over the pegs and stay in the bucket', () => {
    const world = phys2D.createWorld();
    const bodies = buildCrowd(phys2D, world);
    expect(bodies).toHaveLength(5000);
    const before = ys(bodies);
    run(world, 2);
    expect(Math.max(...ys(bodies))).toBeLessThan(0);
    expect(Math.max(...xs(bodies).map(Math.abs))).toBeLessThan(CROWD_SIDE / 2);
    expect(ys(bodies).filter((y, i) => y > before[i]! + 5).length).toBeGreaterThan(4000);
  });
});
