import { describe, expect, it } from 'vitest';
import { type Polygon, phys2D, type RigidBody, type RigidBodyParams, type Shape, type World } from '../../src/index.js';
import { add, addFloor, arbiterOf, box, boxBody, disc, near, plainBody, steps, weightless } from './setting.js';

interface Setup {
  readonly wall?: RigidBodyParams;
  readonly wallShape?: Shape;
  readonly shot?: RigidBodyParams;
  /** The wall is made, and added, after what flies at it. */
  readonly wallLast?: boolean;
}

interface Scene {
  readonly world: World;
  readonly wall: RigidBody;
  readonly shot: RigidBody;
  /** What the wall's shape was told, in order. */
  readonly log: string[];
}

/** A thin wall at x = 5, and a disc of radius 0.25 that flies at it with 120 m/s: 2 m a step. */
function range({ wall, wallShape, shot, wallLast = false }: Setup = {}): Scene {
  const world = weightless();
  const makeWall = () =>
    phys2D.createRigidBody({
      type: 'static',
      position: [5, 0],
      shapes: [wallShape ?? box(0.02, 10)],
      linearDrag: 0,
      angularDrag: 0,
      ...wall,
    });
  const makeShot = () => plainBody({ shapes: [disc(0.25)], velocity: [120, 0], ...shot });
  let made: [RigidBody, RigidBody];
  if (wallLast) {
    const flying = makeShot();
    made = [makeWall(), flying];
    add(world, flying, made[0]);
  } else {
    made = [makeWall(), makeShot()];
    add(world, ...made);
  }
  const log: string[] = [];
  for (const type of ['begin', 'end'] as const) {
    made[0].shapes[0]!.addEventListener(type, () => log.push(type));
  }
  return { world, wall: made[0], shot: made[1], log };
}

const POLYGONS: readonly (() => Polygon)[] = [
  () => box(0.5, 0.5),
  () => phys2D.createPolygonShape({ vertices: phys2D.createRegularPolygonVertices(0.5, 0.5, 3) }),
  () => phys2D.createPolygonShape({ vertices: phys2D.createRegularPolygonVertices(0.5, 0.5, 7) }),
  () => box(1, 0.02),
];

/** Steps; the shot's centre never gets to x = 5, nor its surface out of the back of the wall. */
function staysLeft({ world, shot }: Scene, count = 10, reach = 0.25): void {
  for (let i = 0; i < count; i += 1) {
    steps(world, 1);
    expect(shot.getPosition()[0]).toBeLessThan(5);
    expect(shot.getPosition()[0] + reach).toBeLessThan(5.01);
  }
  expect(shot.getPosition()[0]).toBeGreaterThan(-20);
}

describe('continuous collision', () => {
  it('C-167 a fast disc does not pass a thin wall, static or kinematic', () => {
    for (const type of ['static', 'kinematic'] as const) {
      const scene = range({ wall: { type } });
      staysLeft(scene);
      expect(scene.log).toContain('begin');
    }
  });

  it('C-167 whichever of the two was made first', () => {
    for (const type of ['static', 'kinematic'] as const) {
      staysLeft(range({ wall: { type }, wallLast: true }));
    }
  });

  it('C-167 nor do boxes and polygons, turning or not', () => {
    for (const polygon of POLYGONS) {
      for (const angularVelocity of [0, 7, -50]) {
        for (const wallLast of [false, true]) {
          const { world, shot } = range({ shot: { shapes: [polygon()], angularVelocity }, wallLast });
          for (let i = 0; i < 10; i += 1) {
            steps(world, 1);
            expect(shot.getPosition()[0]).toBeLessThan(5);
          }
        }
      }
    }
  });

  it('C-167 at any speed, from any place', () => {
    for (const speed of [20, 31, 65, 120, 250, 400, 1000, 5000]) {
      for (const x of [0, 0.5, 1.7, 3.99, 4.7, 4.735]) {
        staysLeft(range({ shot: { velocity: [speed, 0], position: [x, 0] } }));
        const shot = { velocity: [speed, 0.5 * Math.min(speed, 400)], position: [x, -4.9] } as const;
        staysLeft(range({ wallShape: box(0.02, 2000), shot }));
      }
    }
  });

  it('C-167 from any side, at a wall turned anyhow', () => {
    for (let i = 0; i < 24; i += 1) {
      const angle = (i * Math.PI) / 12 + 0.01;
      const [nx, ny] = [Math.cos(angle), Math.sin(angle)];
      for (const slant of [-1, 0, 0.7]) {
        const velocity: [number, number] = [120 * (nx - slant * ny), 120 * (ny + slant * nx)];
        const { world, shot } = range({ wall: { position: [5 * nx, 5 * ny], rotation: angle }, shot: { velocity } });
        for (let n = 0; n < 4; n += 1) {
          steps(world, 1);
          const [x, y] = shot.getPosition();
          expect(x * nx + y * ny, `wall at ${angle}`).toBeLessThan(4.74 + 0.01);
        }
      }
    }
  });

  it('C-167 nor a kinematic wall that moves or turns', () => {
    for (const speed of [-120, -30, -2, 2, 30, 100]) {
      const { world, wall, shot } = range({ wall: { type: 'kinematic', velocity: [speed, 0] } });
      for (let i = 0; i < 30; i += 1) {
        steps(world, 1);
        expect(shot.getPosition()[0] + 0.25, `wall at ${speed} m/s`).toBeLessThan(wall.getPosition()[0]);
      }
      expect(wall.getVelocity()).toEqual([speed, 0]);
    }
    for (const spin of [-3, 0.5, 6]) {
      const { world, wall, shot } = range({ wall: { type: 'kinematic', angularVelocity: spin } });
      for (let i = 0; i < 6; i += 1) {
        steps(world, 1);
        const [x, y] = shot.getPosition();
        const angle = wall.getRotation();
        expect((x - 5) * Math.cos(angle) + y * Math.sin(angle), `wall at ${spin} rad/s`).toBeLessThan(0);
      }
    }
  });

  it('C-168 it passes a dynamic wall, unless it is a bullet', () => {
    const passing = range({ wall: { type: 'dynamic', mass: 100 } });
    steps(passing.world, 6);
    expect(passing.shot.getPosition()[0]).toBeGreaterThan(10);
    expect(passing.wall.getPosition()).toEqual([5, 0]);
    expect(passing.log).toEqual([]);
    const bullet = range({ wall: { type: 'dynamic', mass: 100 }, shot: { bullet: true } });
    steps(bullet.world, 6);
    expect(bullet.log).toContain('begin');
    expect(bullet.wall.getVelocity()[0]).toBeGreaterThan(1);
    expect(bullet.wall.getPosition()[0]).toBeGreaterThan(5);
    expect(bullet.shot.getPosition()[0]).toBeLessThan(bullet.wall.getPosition()[0]);
  });

  it('C-168 momentum is kept, whatever the mass and the creation order; `bullet` may be set at any time', () => {
    for (const mass of [0.01, 1, 100, 1000]) {
      for (const wallLast of [false, true]) {
        const { world, wall, shot, log } = range({ wall: { type: 'dynamic', mass }, wallLast });
        steps(world, 1);
        shot.bullet = true;
        for (let i = 0; i < 6; i += 1) {
          steps(world, 1);
          expect(shot.getPosition()[0]).toBeLessThan(wall.getPosition()[0]);
          near(shot.getVelocity()[0] + mass * wall.getVelocity()[0], 120);
        }
        expect(log).toContain('begin');
        near(shot.getVelocity()[0], 120 / (1 + mass), 0.01);
      }
    }
  });

  it('C-169 a sensor wall is crossed: one `begin`, one `end`, no change of velocity', () => {
    for (const type of ['static', 'kinematic'] as const) {
      for (const wallLast of [false, true]) {
        for (const [x, vy] of [
          [0, 0],
          [0.9, 60],
        ] as const) {
          const { world, shot, log } = range({
            wall: { type },
            wallShape: box(0.02, 10, { sensor: true }),
            shot: { velocity: [120, vy], position: [x, 0] },
            wallLast,
          });
          steps(world, 10);
          expect(log).toEqual(['begin', 'end']);
          expect(shot.getVelocity()).toEqual([120, vy]);
          near(shot.getPosition(), [x + 20, vy / 6]);
        }
      }
    }
  });

  it('C-169 `begin` comes with the step that crosses it, `end` with the next', () => {
    const { world, log } = range({ wallShape: box(0.02, 10, { sensor: true }) });
    const lengths = [1, 2, 3, 4, 5].map(() => {
      steps(world, 1);
      return log.length;
    });
    expect(lengths).toEqual([0, 0, 1, 2, 2]);
  });

  it('C-170 nor does a disc of radius 0.02 [D-38]', () => {
    for (const type of ['static', 'kinematic'] as const) {
      for (const wallLast of [false, true]) {
        staysLeft(range({ wall: { type }, shot: { shapes: [disc(0.02)] }, wallLast }), 10, 0.02);
      }
    }
  });

  it('C-170 nor smaller ones, at thinner walls', () => {
    for (const radius of [0.02, 0.01, 0.005]) {
      for (const thickness of [0.02, 0.01, 0.002]) {
        for (const speed of [40, 120, 400]) {
          const { world, shot } = range({
            wallShape: box(thickness, 100),
            shot: { shapes: [disc(radius)], velocity: [speed, 0.3 * speed] },
          });
          for (let i = 0; i < 8; i += 1) {
            steps(world, 1);
            expect(shot.getPosition()[0], `${radius} m, ${thickness} m, ${speed} m/s`).toBeLessThan(5);
          }
        }
      }
    }
  });

  it('C-171 elastic, it returns as fast as it came', () => {
    const rubber = phys2D.createMaterial({ elasticity: 1 });
    for (const type of ['static', 'kinematic'] as const) {
      for (const wallLast of [false, true]) {
        for (const x of [0, 0.4, 1.9]) {
          const { world, shot, log } = range({
            wall: { type },
            wallShape: box(0.02, 10, { material: rubber }),
            shot: { shapes: [disc(0.25, { material: rubber })], position: [x, 0] },
            wallLast,
          });
          steps(world, 10);
          near(shot.getVelocity(), [-120, 0], 1.2);
          expect(log).toEqual(['begin', 'end']);
        }
      }
    }
  });

  it('C-171 half elastic, half as fast; from a moving wall, faster', () => {
    const smooth = phys2D.createMaterial({ elasticity: 0.5, staticFriction: 0, dynamicFriction: 0 });
    for (const [wallSpeed, expected] of [
      [0, -60],
      [-40, -40 - 80],
      [40, 40 - 40],
    ] as const) {
      const { world, shot } = range({
        wall: { type: 'kinematic', velocity: [wallSpeed, 0] },
        wallShape: box(0.02, 10, { material: smooth }),
        shot: { shapes: [disc(0.25, { material: smooth })], velocity: [120, 30] },
      });
      steps(world, 10);
      near(shot.getVelocity(), [expected, 30], 0.01 * Math.max(1, Math.abs(expected)));
    }
  });

  it('C-172 it passes if filters or `preSolve` say so', () => {
    const setups: readonly (() => Setup)[] = [
      () => ({ wallShape: box(0.02, 10, { group: 2 }), shot: { shapes: [disc(0.25, { mask: 5 })] } }),
      () => ({ wallShape: box(0.02, 10, { mask: 2 }) }),
    ];
    for (const setup of setups) {
      for (const wallLast of [false, true]) {
        const { world, shot, log } = range({ ...setup(), wallLast });
        steps(world, 10);
        near(shot.getPosition()[0], 20);
        expect([shot.getVelocity(), log]).toEqual([[120, 0], []]);
      }
    }
    for (const owner of ['wall', 'shot'] as const) {
      for (const wallLast of [false, true]) {
        const scene = range({ wallLast });
        scene[owner].shapes[0]!.addEventListener('preSolve', (arbiter) => arbiter.setAcceptedState(false));
        steps(scene.world, 10);
        near(scene.shot.getPosition()[0], 20);
        expect([scene.shot.getVelocity(), scene.log]).toEqual([
          [120, 0],
          ['begin', 'end'],
        ]);
      }
    }
  });

  it('C-173 a box thrown at the floor turns as the reported angular impulse tells [D-36]', () => {
    for (const y of [-5, -5.2, -5.9]) {
      for (const elasticity of [0, 0.5, 1]) {
        for (const rotation of [0.3, -0.3, 1.2]) {
          for (const first of [true, false]) {
            const material = phys2D.createMaterial({ elasticity });
            const world = weightless();
            const still = { linearDrag: 0, angularDrag: 0 };
            const make = () =>
              boxBody(1, 1, { position: [0, y], velocity: [0, 100], rotation, ...still }, { material });
            const early = first ? make() : null;
            const floor = addFloor(world, {}, { material });
            const body = early ?? make();
            add(world, body);
            let began = false;
            body.shapes[0]!.addEventListener('begin', () => {
              began = true;
            });
            for (let i = 0; i < 10 && !began; i += 1) {
              near(body.getVelocity(), [0, 100]);
              steps(world, 1);
            }
            expect(began).toBe(true);
            const [jx, jy, jw] = arbiterOf(world, floor, body)!.getImpulseForBody(body);
            expect(Math.abs(jw)).toBeGreaterThan(1);
            near(body.getAngularVelocity(), jw / body.getInertia(), 1e-6 * Math.abs(jw / body.getInertia()));
            near(body.getVelocity(), [jx / body.getMass(), 100 + jy / body.getMass()], 1e-6 * 100);
          }
        }
      }
    }
  });
});
