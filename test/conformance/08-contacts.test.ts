import { describe, expect, it } from 'vitest';
import { type MaterialParams, phys2D, type RigidBody } from '../../src/index.js';
import {
  add,
  addFloor,
  arbiterOf,
  box,
  boxBody,
  DT,
  disc,
  heavy,
  near,
  plainBody,
  speed,
  steps,
  weightless,
} from './setting.js';

const material = (params: MaterialParams) => phys2D.createMaterial(params);
const smooth = (elasticity: number) =>
  material({ elasticity, staticFriction: 0, dynamicFriction: 0, rollingFriction: 0 });

describe('contacts: basic physics', () => {
  it('C-084 a box dropped on the floor comes to rest', () => {
    const world = heavy();
    addFloor(world);
    const body = boxBody(1, 1, { position: [0, -2] });
    add(world, body);
    steps(world, 120);
    expect(speed(body)).toBeLessThan(0.01);
    const [x, y] = body.getPosition();
    expect(y).toBeGreaterThan(-0.005);
    expect(y).toBeLessThan(0.011);
    near([x, body.getRotation()], [0, 0], 1e-3);
  });

  it('C-085 a stack of three boxes stands and sleeps', () => {
    const world = heavy();
    addFloor(world);
    const bodies = [0, -1, -2].map((y) => boxBody(1, 1, { position: [0, y] }));
    add(world, ...bodies);
    steps(world, 300);
    near(
      bodies.map((body) => body.getPosition()[1]),
      [0, -1, -2],
      0.03,
    );
    expect(bodies.every((body) => body.sleeping)).toBe(true);
  });

  it('C-086 equal bodies share or exchange their velocity', () => {
    for (const [elasticity, first, second] of [
      [0, 1, 1],
      [1, 0, 2],
    ] as const) {
      const world = weightless();
      const surface = elasticity === 1 ? smooth(1) : material({ elasticity });
      const a = plainBody({ shapes: [disc(0.5, { material: surface })], velocity: [2, 0] });
      const b = plainBody({ shapes: [disc(0.5, { material: surface })], position: [1.5, 0] });
      add(world, a, b);
      steps(world, 60);
      near([a.getVelocity()[0], b.getVelocity()[0]], [first, second], 0.02);
    }
  });

  it('C-087 a ball leaves with its elasticity times the impact speed, unless that is slow', () => {
    const drop = (impact: number): RigidBody => {
      const world = weightless();
      const surface = material({ elasticity: 0.5 });
      addFloor(world, {}, { material: surface });
      const ball = plainBody({
        shapes: [disc(0.5, { material: surface })],
        position: [0, -0.5],
        velocity: [0, impact],
      });
      add(world, ball);
      steps(world, Math.ceil(0.5 / impact / DT) + 10);
      return ball;
    };
    near(drop(5).getVelocity()[1], -2.5, 0.01);
    expect(speed(drop(0.4))).toBeLessThan(0.01);
  });

  /** The arbiter of two overlapping bodies of these materials. */
  function contact(a: MaterialParams, b: MaterialParams) {
    const world = weightless();
    const first = plainBody({ shapes: [disc(0.5, { material: material(a) })] });
    const second = plainBody({ shapes: [disc(0.5, { material: material(b) })], position: [0.9, 0] });
    add(world, first, second);
    steps(world, 1);
    return arbiterOf(world, first, second)!;
  }

  it('C-088 elasticities are averaged, with infinities as overrides', () => {
    for (const [a, b, expected] of [
      [1, 0, 0.5],
      [3, 1, 1],
      [-4, 1, 0],
      [Infinity, 0, 1],
      [Infinity, -Infinity, 0],
    ] as const) {
      expect(contact({ elasticity: a }, { elasticity: b }).getElasticity()).toBe(expected);
    }
  });

  it('C-089 frictions are geometric means', () => {
    const arbiter = contact(
      { staticFriction: 4, dynamicFriction: 1, rollingFriction: 0.01 },
      { staticFriction: 9, dynamicFriction: 4, rollingFriction: 0.04 },
    );
    near([arbiter.getStaticFriction()!, arbiter.getDynamicFriction()!, arbiter.getRollingFriction()!], [6, 2, 0.02]);
  });

  it('C-090 a sliding box is slowed by friction times gravity', () => {
    const world = heavy();
    const surface = material({ staticFriction: 0.4, dynamicFriction: 0.4 });
    addFloor(world, {}, { material: surface });
    const body = boxBody(
      1,
      1,
      { position: [-5, 0], velocity: [5, 0], linearDrag: 0, angularDrag: 0 },
      { material: surface },
    );
    add(world, body);
    steps(world, 15);
    const before = body.getVelocity()[0];
    steps(world, 30);
    near(before - body.getVelocity()[0], 2, 0.1);
  });

  it('C-091 a box holds on a slope with much friction and slides with little', () => {
    const slide = (staticFriction: number, dynamicFriction: number, settle: number): number => {
      const world = heavy();
      const surface = material({ staticFriction, dynamicFriction });
      const rotation = Math.PI / 6;
      addFloor(world, { rotation }, { material: surface });
      const up = [Math.sin(rotation), -Math.cos(rotation)] as const;
      const body = boxBody(1, 1, { position: [up[0], 1 + up[1]], rotation }, { material: surface });
      add(world, body);
      steps(world, settle);
      const [x0, y0] = body.getPosition();
      steps(world, 120 - settle);
      const [x, y] = body.getPosition();
      return Math.sqrt((x - x0) ** 2 + (y - y0) ** 2);
    };
    expect(slide(1, 0.9, 10)).toBeLessThan(0.02);
    expect(slide(0.1, 0.1, 10)).toBeGreaterThan(1);
  });

  it('C-092 rolling friction slows a rolling disc', () => {
    const roll = (rollingFriction: number): number => {
      const world = heavy();
      const surface = material({ rollingFriction });
      add(
        world,
        phys2D.createRigidBody({ type: 'static', position: [0, 1], shapes: [box(400, 1, { material: surface })] }),
      );
      const body = phys2D.createRigidBody({
        shapes: [disc(0.5, { material: surface })],
        velocity: [5, 0],
        angularVelocity: 10,
        linearDrag: 0,
        angularDrag: 0,
      });
      add(world, body);
      steps(world, 120);
      return body.getVelocity()[0];
    };
    expect(roll(0) - roll(0.2)).toBeGreaterThan(0.2);
    near(roll(0), 5, 0.05);
  });

  /** Velocity of a box on a body with a surface velocity, whichever shape is older. */
  function conveyor(surfaceVelocity: [number, number], floorFirst: boolean, count: number): [number, number] {
    const world = heavy();
    const older = box(20, 1);
    const body = boxBody(1, 1);
    const younger = box(20, 1);
    const shapes = [floorFirst ? older : younger];
    add(world, phys2D.createRigidBody({ type: 'static', position: [0, 1], shapes, surfaceVelocity }), body);
    steps(world, count);
    return body.getVelocity();
  }

  it('C-093 a floor with surface velocity carries a box to the right', () => {
    near(conveyor([2, 0], true, 120), [2, 0], 0.02);
  });

  it('C-094 the same if the floor has the younger shape', () => {
    near(conveyor([2, 0], false, 120), [2, 0], 0.02);
  });

  it('C-095 the underside carries to the left', () => {
    const world = heavy({ gravity: [0, -10] });
    const body = boxBody(1, 1, { position: [0, 1] });
    add(world, phys2D.createRigidBody({ type: 'static', shapes: [box(20, 1)], surfaceVelocity: [2, 0] }), body);
    steps(world, 120);
    near(body.getVelocity(), [-2, 0], 0.02);
  });

  it('C-096 a normal surface velocity throws things off', () => {
    expect(conveyor([0, 2], true, 5)[1]).toBeLessThan(-1);
    expect(conveyor([0, 2], false, 5)[1]).toBeLessThan(-1);
  });

  it('C-097 a rising platform lifts a box', () => {
    const world = heavy();
    const platform = phys2D.createRigidBody({
      type: 'kinematic',
      position: [0, 1],
      shapes: [box(4, 1)],
      velocity: [0, -1],
    });
    const body = boxBody(1, 1);
    add(world, platform, body);
    steps(world, 60);
    near(body.getPosition()[1], -1, 0.03);
  });

  it('C-098 a kinematic pusher pushes and is not slowed', () => {
    const world = weightless();
    const pusher = phys2D.createRigidBody({
      type: 'kinematic',
      position: [-2, 0],
      shapes: [box(1, 1)],
      velocity: [2, 0],
    });
    const body = plainBody();
    add(world, pusher, body);
    steps(world, 90);
    expect(body.getVelocity()[0]).toBeGreaterThan(2 - 0.02);
    expect(pusher.getVelocity()).toEqual([2, 0]);
  });

  it('C-099 overlapping bodies are parted gently', () => {
    const world = weightless();
    const a = plainBody();
    const b = plainBody({ position: [0.7, 0] });
    add(world, a, b);
    steps(world, 120);
    expect(1 - (b.getPosition()[0] - a.getPosition()[0])).toBeLessThan(0.015);
    expect(Math.max(speed(a), speed(b))).toBeLessThan(0.01);
  });

  it('C-100 shapes of one body do not meet each other', () => {
    const world = weightless();
    const body = phys2D.createRigidBody({ shapes: [disc(0.5), box(1, 1)] });
    add(world, body);
    steps(world, 10);
    expect([...world.dynamicArbiters, ...world.staticArbiters]).toHaveLength(0);
    expect(body.shapes.every((shape) => shape.arbiters.length === 0)).toBe(true);
    near([...body.getPosition(), body.getRotation()], [0, 0, 0]);
  });
});
