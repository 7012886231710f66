import { describe, expect, it } from 'vitest';
import { type PointConstraint, phys2D, type RigidBody, type Vec2, type World } from '../../src/index.js';
import { add, boxBody, DT, heavy, staticBody, steps, tie, weightless } from '../conformance/setting.js';
import { generator } from '../scenes/mixed.js';

// What joints hold to two places that are too far apart, or too close, cannot be met. Corrected again and again, with momentum, chains whirled at 500 m/s, and beams that stood were told to turn at 2,900 rad/s.

/** m/s. How fast bodies are told to move, their ends included, and how fast they do, at most in so many steps. */
function fastest(world: World, bodies: readonly RigidBody[], reach: number, count: number) {
  let [told, moves] = [0, 0];
  for (let i = 0; i < count; i += 1) {
    const before = bodies.map((body) => [...body.getPosition(), body.getRotation()] as const);
    steps(world, 1);
    bodies.forEach((body, k) => {
      const [x, y, angle] = before[k]!;
      const [nextX, nextY] = body.getPosition();
      const turned = Math.abs(body.getRotation() - angle) * reach;
      told = Math.max(told, Math.hypot(...body.getVelocity()), Math.abs(body.getAngularVelocity()) * reach);
      moves = Math.max(moves, (Math.hypot(nextX - x, nextY - y) + turned) / DT);
    });
  }
  return { told, moves };
}

function kinematic(position: Vec2): RigidBody {
  return boxBody(0.1, 0.1, { type: 'kinematic', position });
}

/** Holds a point of each of two bodies together; they pass through each other. */
function pin(world: World, bodyA: RigidBody, anchorA: Vec2, bodyB: RigidBody, anchorB: Vec2): PointConstraint {
  const constraint = phys2D.createPointConstraint({ bodyA, bodyB, anchorA, anchorB, ignoreInteractions: true });
  tie(world, constraint);
  return constraint;
}

/** Pins links to each other in a row, end to end, and the first to a hook at the origin. */
function pinInRow(world: World, links: readonly RigidBody[], [x, y]: Vec2): void {
  links.forEach((link, i) => {
    add(world, link);
    pin(world, links[i - 1] ?? staticBody(), i === 0 ? [0, 0] : [x, y], link, [-x, -y]);
  });
}

/** A chain of so many rods from a hook at the origin to a hand, straight along a direction. @returns the rods. */
function addChain(world: World, lengths: readonly number[], angle: number, hand: RigidBody) {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const rods: RigidBody[] = [];
  let last = staticBody();
  let from = 0;
  for (const [i, length] of lengths.entries()) {
    const at = from + length / 2;
    const rod = boxBody(0.9 * length, 0.1, { position: [c * at, s * at], rotation: angle });
    add(world, rod);
    pin(world, last, i === 0 ? [0, 0] : [lengths[i - 1]! / 2, 0], rod, [-length / 2, 0]);
    rods.push(rod);
    last = rod;
    from += length;
  }
  pin(world, last, [lengths.at(-1)! / 2, 0], hand, [0, 0]);
  return rods;
}

/** Pieces of 0.4 m, welded to each other and to what is at either end. */
function addBeam(world: World, count: number, ends: readonly [RigidBody, RigidBody]): RigidBody[] {
  const pieces = Array.from({ length: count }, (_, i) =>
    boxBody(0.36, 0.1, { position: [0.4 * (i + 0.5) - 0.2 * count, 0] }),
  );
  add(world, ...pieces);
  const row = [ends[0], ...pieces, ends[1]];
  for (let i = 0; i <= count; i += 1) {
    const [bodyA, bodyB] = [row[i]!, row[i + 1]!];
    const anchorA: Vec2 = i === 0 ? [0, 0] : [0.2, 0];
    const anchorB: Vec2 = i === count ? [0, 0] : [-0.2, 0];
    tie(world, phys2D.createWeldConstraint({ bodyA, bodyB, anchorA, anchorB, ignoreInteractions: true }));
  }
  return pieces;
}

describe('a chain that a hand draws too far', () => {
  it('comes to rest, in 27 of 30 random ones', () => {
    let restless = 0;
    let worst = { told: 0, moves: 0 };
    for (let seed = 1; seed <= 30; seed += 1) {
      const next = generator(seed);
      const world = heavy();
      const lengths = Array.from({ length: 2 + Math.floor(7 * next()) }, () => 0.2 + 0.4 * next());
      const total = lengths.reduce((sum, length) => sum + length);
      const angle = 6.28 * next();
      const way = total * 0.001 * 50 ** next();
      const hand = kinematic([Math.cos(angle) * total, Math.sin(angle) * total]);
      add(world, hand);
      const rods = addChain(world, lengths, angle, hand);
      hand.setVelocity([Math.cos(angle) * way, Math.sin(angle) * way]);
      steps(world, 60);
      hand.setVelocity([0, 0]);
      steps(world, 300);
      const found = fastest(world, rods, 0.3, 60);
      restless += found.told > 0.5 || found.moves > 0.5 ? 1 : 0;
      worst = { told: Math.max(worst.told, found.told), moves: Math.max(worst.moves, found.moves) };
    }
    console.log(
      `overdrawn chains: ${restless} of 30 restless, told ${worst.told} m/s, moved ${worst.moves} m/s at most`,
    );
    expect(restless).toBeLessThanOrEqual(3);
    expect(Math.max(worst.told, worst.moves)).toBeLessThan(5);
  });

  it('falls as from rest when it is let go', () => {
    for (const way of [0.003, 0.01, 0.03]) {
      const world = heavy();
      const hand = kinematic([0.6, 0]);
      add(world, hand);
      const rods = addChain(world, [0.3, 0.3], 0, hand);
      hand.setVelocity([way, 0]);
      steps(world, 60);
      hand.setVelocity([0, 0]);
      steps(world, 240);
      world.removeConstraint(world.constraints.at(-1)!);
      // From 0.6 m a rod is at 3.5 m/s below.
      expect(fastest(world, rods, 0, 60).told, `${way} m`).toBeLessThan(4.5);
    }
  });
});

describe('what hangs at rest, and a hand takes hold of and draws farther than it reaches', () => {
  const direction: Vec2 = [0.6, 0.8];

  /** A net of 6 × 6 discs, that hangs on its upper corners. @returns the bodies, and where the hand takes hold. */
  function addNet(world: World): { bodies: RigidBody[]; end: RigidBody; anchor: Vec2 } {
    const [count, pitch] = [6, 0.4];
    const ground = staticBody();
    const bodies: RigidBody[] = [];
    const pinAt = (bodyA: RigidBody, bodyB: RigidBody, at: Vec2) =>
      pin(world, bodyA, bodyA.transformWorldPointToLocal(at), bodyB, bodyB.transformWorldPointToLocal(at));
    for (let i = 0; i < count * count; i += 1) {
      const [x, y] = [pitch * (i % count), pitch * Math.floor(i / count)];
      const shapes = [phys2D.createCircleShape({ radius: 0.12 })];
      const disc = phys2D.createRigidBody({ position: [x, y], shapes, linearDrag: 0.4 });
      add(world, disc);
      bodies.push(disc);
      if (i % count > 0) pinAt(bodies[i - 1]!, disc, [x - pitch / 2, y]);
      if (i >= count) pinAt(bodies[i - count]!, disc, [x, y - pitch / 2]);
      if (i === 0 || i === count - 1) pinAt(ground, disc, [x, y]);
    }
    return { bodies, end: bodies.at(-3)!, anchor: [0, 0] };
  }

  function addRope(world: World, ball: number): { bodies: RigidBody[]; end: RigidBody; anchor: Vec2 } {
    const links = Array.from({ length: 10 }, (_, i) =>
      boxBody(0.12, 0.4, { position: [0, 0.2 + 0.4 * i], linearDrag: 0.3 }),
    );
    pinInRow(world, links, [0, 0.2]);
    const last = links.at(-1)!;
    if (ball === 0) {
      return { bodies: links, end: last, anchor: [0, 0.2] };
    }
    const shapes = [phys2D.createCircleShape({ radius: ball })];
    const load = phys2D.createRigidBody({ position: [0, 4 + ball], shapes, linearDrag: 0.4 });
    add(world, load);
    pin(world, last, [0, 0.2], load, [0, -ball]);
    return { bodies: [...links, load], end: load, anchor: [0, 0] };
  }

  function take(world: World, end: RigidBody, anchorB: Vec2, velocity: Vec2): RigidBody {
    const hand = kinematic(end.transformLocalPointToWorld(anchorB) as Vec2);
    add(world, hand);
    pin(world, hand, [0, 0], end, anchorB);
    hand.setVelocity(velocity);
    return hand;
  }

  /** m/s. The fastest body in so many steps. */
  function peak(world: World, bodies: readonly RigidBody[], count: number, dt: number): number {
    let most = 0;
    for (let i = 0; i < count; i += 1) {
      world.step(dt);
      most = Math.max(most, ...bodies.map((body) => Math.hypot(...body.getVelocity())));
    }
    return most;
  }

  describe.each([
    ['a net', addNet],
    ['a rope', (world: World) => addRope(world, 0)],
  ])('%s', (_, build) => {
    it.each([30, 60, 120])(
      'moves as fast as the hand, and is not flung off when that lets go, at %i steps a second',
      (rate) => {
        for (const speed of [2, 6]) {
          const world = heavy();
          const { bodies, end, anchor } = build(world);
          for (let i = 0; i < 15 * rate; i += 1) world.step(1 / rate);
          take(world, end, anchor, [speed * direction[0], speed * direction[1]]);
          // 36 and 110 m/s, and after it up to 53, where what was changed just now is taken for what can be met; in planck 1.1 times the hand's speed.
          expect(peak(world, bodies, 5, 1 / rate), `${speed} m/s`).toBeLessThan(1.3 * speed);
          world.removeConstraint(world.constraints.at(-1)!);
          expect(peak(world, bodies, 12, 1 / rate), `${speed} m/s, let go`).toBeLessThan(1.3 * speed);
        }
      },
    );
  });

  it.each([0.02, 0.1, 0.4, 0.8])(
    'a rope with a ball that was drawn by %f m goes up as from rest when it is let go',
    (way) => {
      const world = heavy();
      const { bodies, end } = addRope(world, 0.4);
      steps(world, 300);
      const hand = take(world, end, [0, 0], [0, 2 * way]);
      steps(world, 30);
      hand.setVelocity([0, 0]);
      steps(world, 30);
      world.removeConstraint(world.constraints.at(-1)!);
      // Drawn by 0.4 m it told of 25 m/s: what its joints gave against the hand they went on giving for a step.
      expect(peak(world, bodies, 20, DT)).toBeLessThan(0.5);
    },
  );

  it('goes on alike from a snapshot, of before, or of between the hand and the next step', () => {
    const world = heavy();
    const { bodies, end } = addRope(world, 0);
    bodies[9]!.setVelocity([3, 0]);
    steps(world, 40);
    const swinging = world.snapshot();
    const hash = world.hash();
    steps(world, 1);
    const next = world.hash();
    const hand = take(world, end, [0, 0.2], [0, 2]);
    steps(world, 30);
    hand.setVelocity([0, 0]);
    steps(world, 30);
    world.removeConstraint(world.constraints.at(-1)!);
    const released = world.snapshot();
    steps(world, 3);
    const flown = world.hash();
    world.restore(released);
    steps(world, 3);
    expect(world.hash()).toBe(flown);
    world.restore(swinging);
    expect(world.hash()).toBe(hash);
    steps(world, 1);
    expect(world.hash()).toBe(next);
  });

  it('bears what it bears when a lamp is taken off it', () => {
    const sag = (removes: boolean) => {
      const world = heavy();
      // Two straight halves, which go down and up.
      const [c, d] = [0.97, Math.sqrt(1 - 0.97 * 0.97)];
      const bodies = Array.from({ length: 8 }, (_, i) => {
        const [along, down] = [0.2 + 0.4 * i, i < 4 ? 0.2 + 0.4 * i : 3 - 0.4 * i];
        return boxBody(0.36, 0.08, {
          position: [c * along, d * down],
          rotation: (i < 4 ? 1 : -1) * Math.acos(c),
        });
      });
      pinInRow(world, bodies, [0.2, 0]);
      pin(world, bodies[7]!, [0.2, 0], staticBody(), [3.2 * c, 0]);
      const hang = (to: RigidBody, size: number, mass: number) => {
        const [x, y] = to.getPosition();
        const load = boxBody(size, size, { position: [x, y + 0.6], mass, inertia: 0.04 * mass });
        add(world, load);
        return pin(world, to, [0, 0], load, [0, -0.6]);
      };
      hang(bodies[4]!, 0.3, 200 * bodies[0]!.getMass());
      const lamp = hang(bodies[2]!, 0.05, 0.0025);
      steps(world, 400);
      if (removes) world.removeConstraint(lamp);
      let lowest = 0;
      for (let i = 0; i < 60; i += 1) {
        steps(world, 1);
        lowest = Math.max(lowest, bodies[4]!.getPosition()[1]);
      }
      return lowest;
    };
    // All joints of the rope forgot what they gave: the load dropped by 7 to 16 cm.
    expect(sag(true) - sag(false)).toBeLessThan(0.02);
  });
});

describe('a chain whose ends go apart and come back', () => {
  // Up to so many times its length, at 1 m/s. As each sub-step corrects with momentum what it cannot close, its links were told 170, 420 and 533 m/s, and 40,000 rad/s.
  it.each([
    [5, 2],
    [12, 1.6],
    [12, 2],
    [20, 2],
    [40, 1.6],
  ])('is not flung about: %i links, to %f of its length', (count, over) => {
    const world = heavy();
    const length = 0.5 * count;
    const hand = kinematic([length, 0]);
    add(world, hand);
    const lengths = Array.from({ length: count }, () => 0.5);
    const rods = addChain(world, lengths, 0, hand);
    const time = Math.ceil(60 * length * (over - 1));
    for (const speed of [1, 0, -1]) {
      hand.setVelocity([speed, 0]);
      expect(fastest(world, rods, 0.02, speed === 0 ? 60 : time).told, `at ${speed} m/s`).toBeLessThan(40);
    }
  });
});

describe('a chain of which a link is frozen and that is drawn too far', () => {
  // Its joints gave more and more against each other, 73 N·s in a step, and flung it off at 33 m/s for each half metre when the link was free again.
  it.each([0.5, 1, 2])('closes when it is let go: by %f m', (way) => {
    const world = weightless();
    const hand = kinematic([6, 0]);
    add(world, hand);
    const lengths = Array.from({ length: 12 }, () => 0.5);
    const rods = addChain(world, lengths, 0, hand);
    rods[5]!.setAsStatic();
    hand.setVelocity([way, 0]);
    steps(world, 60);
    hand.setVelocity([0, 0]);
    steps(world, 30);
    rods[5]!.setAsDynamic();
    expect(fastest(world, rods, 0, 60).told).toBeLessThan(2);
  });
});

describe('a chain that breaks under force', () => {
  it.each([500, 5000, 50_000])('breaks all the same when it is drawn too far: at %f N', (maxForce) => {
    const world = heavy();
    const hand = kinematic([0.5, 0]);
    add(world, hand);
    addChain(world, [0.5], 0, hand);
    for (const constraint of world.constraints) {
      constraint.configure({ breakUnderForce: true, maxForce });
    }
    hand.setVelocity([0.5, 0]);
    steps(world, 120);
    expect(world.constraints.length).toBeLessThan(2);
  });
});

describe('a body with two hinges of which one is moved', () => {
  const HINGES = [-0.8, 0.8] as const;

  /** A door of 1 × 2 m, and its frames. */
  function addDoor(world: World) {
    const frames = HINGES.map(() => staticBody());
    const door = boxBody(1, 2, { position: [0.5, 0] });
    add(world, door);
    const hinges = HINGES.map((y, i) =>
      phys2D.createPointConstraint({ bodyA: frames[i]!, bodyB: door, anchorA: [0, y], anchorB: [-0.5, y] }),
    );
    tie(world, ...hinges);
    steps(world, 60);
    return { door, hinges, frame: frames[1]! };
  }

  // The other one made momentum of what this one asked for: it was told 13 m/s for 5 mm and 95 m/s for 20 mm, and flew off so when it was let go.
  it.each([0.002, 0.005, 0.02, 0.05])('is told to move no faster than it does: by its anchor, %f m', (way) => {
    const world = heavy();
    const { door, hinges } = addDoor(world);
    hinges[1]!.setAnchorA([0, HINGES[1] + way]);
    expect(fastest(world, [door], 1, 5).told).toBeLessThan(Math.max(0.2, 2 * way * 60));
    for (const hinge of hinges) {
      world.removeConstraint(hinge);
    }
    expect(fastest(world, [door], 0, 30).told).toBeLessThan(7);
  });

  it.each([0.005, 0.02, 0.05])('… and by its frame, in four steps, %f m', (way) => {
    const world = heavy();
    const { door, frame } = addDoor(world);
    for (let i = 1; i <= 4; i += 1) {
      frame.setPosition([0, (way * i) / 4]);
      expect(fastest(world, [door], 1, 1).told).toBeLessThan(Math.max(0.3, 2 * way * 60));
    }
  });
});

describe('a beam of welded pieces whose ends go to and fro', () => {
  // It can neither be drawn nor pressed. What it cannot close became momentum: it was told to move at up to 33 km/s.
  it.each([4, 6, 10])('is not flung about: %i pieces', (count) => {
    let most = 0;
    for (let seed = 1; seed <= 8; seed += 1) {
      const next = generator(seed);
      const world = heavy();
      const ends = [kinematic([-0.2 * count, 0]), kinematic([0.2 * count, 0])] as const;
      add(world, ...ends);
      const pieces = addBeam(world, count, ends);
      const pace = 2 * Math.PI * 0.1 * 15 ** next();
      const swing = 0.3 + 1.2 * next();
      for (let i = 0; i < 300; i += 1) {
        const isBack = Math.floor((pace * i * DT) / Math.PI) % 2 === 1;
        const v = (isBack ? -1 : 1) * swing * pace * 0.6;
        ends[0].setVelocity([v, 0]);
        ends[1].setVelocity([-v, 0.4 * v]);
        most = Math.max(most, fastest(world, pieces, 0, 1).told);
      }
    }
    console.log(`beams of ${count} pieces, ends to and fro: told ${most.toFixed(1)} m/s at most`);
    expect(most).toBeLessThan(40);
  });
});

describe('a beam of welded pieces that is pressed together', () => {
  it.each([
    [6, 0.05],
    [6, 0.2],
    [6, 0.4],
    [10, 0.05],
    [10, 0.1],
    [10, 0.4],
  ])('comes to rest: %i pieces, shorter by %f of one', (count, share) => {
    const world = heavy();
    const ends = [kinematic([-0.2 * count, 0]), kinematic([0.2 * count, 0])] as const;
    add(world, ...ends);
    const pieces = addBeam(world, count, ends);
    ends[1].setVelocity([-0.4 * share * count, 0]);
    steps(world, 60);
    ends[1].setVelocity([0, 0]);
    steps(world, 480);
    const { told, moves } = fastest(world, pieces, 0.2, 60);
    expect(Math.max(told, moves)).toBeLessThan(0.1);
  });
});

describe('what is not drawn too far', () => {
  it('bears all the same what weighs 1,000 times its links, though they gape as it swings', () => {
    const world = heavy({ substeps: 1 });
    const crate = boxBody(2.2, 0.4, { position: [0, 2.6] }, { mask: 0 });
    for (const side of [-1, 1]) {
      let last = staticBody();
      for (let i = 0; i < 8; i += 1) {
        const link = boxBody(0.08, 0.28, { position: [side, 0.15 + 0.3 * i] }, { mask: 0 });
        crate.setMass(1000 * link.getMass());
        add(world, link);
        const anchorA: Vec2 = i === 0 ? [side, 0] : [0, 0.15];
        tie(world, phys2D.createPointConstraint({ bodyA: last, bodyB: link, anchorA, anchorB: [0, -0.15] }));
        last = link;
      }
      const ends = { anchorA: [0, 0.15] as Vec2, anchorB: [side, -0.2] as Vec2 };
      tie(world, phys2D.createPointConstraint({ bodyA: last, bodyB: crate, ...ends }));
    }
    crate.setInertia(0.8 * crate.getMass());
    add(world, crate);
    crate.setVelocity([6, 0]);
    crate.setAngularVelocity(3);
    for (let i = 0; i < 600; i += 1) {
      steps(world, 1);
      expect(crate.getPosition()[1]).toBeLessThan(3.5);
    }
  });

  it('goes on turning by more than half a turn in a step when a hinge of its frame is moved', () => {
    const world = heavy();
    const plank = boxBody(2, 0.2, {}, { mask: 0 });
    const fan = boxBody(0.8, 0.1, {}, { mask: 0 });
    add(world, plank, fan);
    const hinges = [-1, 1].map((x) =>
      phys2D.createPointConstraint({ bodyA: staticBody(), bodyB: plank, anchorA: [x, 0], anchorB: [x, 0] }),
    );
    tie(world, ...hinges, phys2D.createPointConstraint({ bodyA: plank, bodyB: fan }));
    fan.setAngularVelocity(300);
    steps(world, 60);
    const before = fan.getAngularVelocity();
    hinges[0]!.setAnchorA([-1.001, 0]);
    steps(world, 1);
    expect(before).toBeGreaterThan(250);
    expect(fan.getAngularVelocity()).toBeGreaterThan(0.99 * before);
  });
});
