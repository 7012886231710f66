import { describe, expect, it } from 'vitest';
import { type Physics2DDevice, phys2D, type RigidBody, type World } from '../../src/index.js';
import { buildBreakableChain } from './breakable-chain.js';
import { buildBridge } from './bridge.js';
import { buildGearTrain } from './gear-train.js';
import { stateHash } from './hash.js';
import { worstGap } from './joint-grid.js';
import { buildPulleyLift } from './pulley-lift.js';
import { buildRagdoll, buildStairs, type Ragdoll } from './ragdoll.js';
import { buildRatchet, hangWeight, TEETH } from './ratchet.js';
import { buildVehicle } from './vehicle.js';

// What must hold at every step of the scenes with joints; how they end is in joints.test.ts.

const DT = 1 / 60;

function run(world: World, seconds: number, each: (time: number) => void = () => {}): void {
  for (let i = 1; i <= Math.round(60 * seconds); i += 1) {
    world.step(DT);
    each(i / 60);
  }
}

const mm = (metres: number): string => `${(1000 * metres).toFixed(2)} mm`;

function isTouching(body: RigidBody): boolean {
  return body.shapes[0]!.arbiters.some(({ active }) => active);
}

function dropRagdoll(device: Physics2DDevice, world: World): Ragdoll {
  buildStairs(device, world);
  const ragdoll = buildRagdoll(device, world, [-3.4, -1.5]);
  ragdoll.parts[0]!.setVelocity([2, 0]);
  return ragdoll;
}

describe('scenes with joints, step by step', () => {
  it('the vehicle goes as fast as its wheels turn, and stands still without its motor', () => {
    const world = phys2D.createWorld();
    const { chassis, wheels } = buildVehicle(phys2D, world);
    let astray = 0;
    let start = 0;
    run(world, 10, (time) => {
      start = time <= 2 ? chassis.getPosition()[0] : start;
      wheels.forEach((wheel, i) => {
        const [x] = chassis.transformWorldPointToLocal(wheel.getPosition());
        astray = Math.max(astray, Math.abs(x - (i === 0 ? -0.9 : 0.9)));
      });
    });
    const [driven] = chassis.getPosition();
    const speed = (driven - start) / 8;
    console.log(
      `vehicle: ${driven.toFixed(1)} m in 10 s, in the end ${speed.toFixed(2)} m/s, guides off ${mm(astray)}`,
    );
    expect(driven).toBeGreaterThan(40);
    expect(speed).toBeGreaterThan(0.9 * 12 * 0.4);
    // The wheels turn at the motor's rate against the chassis, which noses down while they grip, and back in the air.
    expect(speed).toBeLessThan(1.05 * 12 * 0.4);
    expect(astray).toBeLessThan(0.001);

    const parked = phys2D.createWorld();
    const car = buildVehicle(phys2D, parked);
    parked.removeConstraint(car.motor);
    run(parked, 5);
    expect(parked.liveDynamics).toHaveLength(0);
    const lengths = car.wheels.map((wheel) => car.chassis.transformWorldPointToLocal(wheel.getPosition())[1]);
    expect(lengths[0]).toBeCloseTo(lengths[1]!, 4);
    expect(lengths[0]).toBeGreaterThan(0.8);
    expect(lengths[0]).toBeLessThan(0.9);
  });

  it('the bridge holds its load', () => {
    const world = phys2D.createWorld();
    const { planks, joints, load } = buildBridge(phys2D, world);
    const lowest = (): number => Math.max(...planks.map((plank) => plank.getPosition()[1]));
    const empty = lowest();
    let late = 0;
    run(world, 20, (time) => {
      late = time > 10 ? Math.max(late, worstGap(joints)) : 0;
    });
    console.log(`bridge: ${mm(late)} after 10 s; lowest at ${empty.toFixed(2)} m, loaded ${lowest().toFixed(2)} m`);
    expect(late).toBeLessThan(0.005);
    expect(lowest()).toBeGreaterThan(empty);
    expect(lowest()).toBeLessThan(empty + 0.5);
    expect(load.every(isTouching) || world.liveDynamics.length === 0).toBe(true);
  });

  it('the rope of the lift has one length; a heavier cabin sinks', () => {
    const world = phys2D.createWorld();
    const { cabin, counterweight, pulley } = buildPulleyLift(phys2D, world);
    let stretch = 0;
    const watch = (): void => {
      const left = 8 + cabin.getPosition()[1] - 1;
      const right = 8 + counterweight.getPosition()[1] - 1;
      stretch = Math.max(stretch, Math.abs(left + 2 * right - pulley.getUpperBound()));
      expect(cabin.getVelocity()[1]).toBeCloseTo(-2 * counterweight.getVelocity()[1], 6);
    };
    run(world, 1.5, watch);
    expect(cabin.getVelocity()[1]).toBeLessThan(0);
    cabin.setMass(14);
    run(world, 1.5, watch);
    console.log(`lift: rope off by ${mm(stretch)}`);
    expect(cabin.getVelocity()[1]).toBeGreaterThan(0);
    expect(stretch).toBeLessThan(0.001);
  });

  it('the ragdoll keeps its joints and limits after the first second', () => {
    const world = phys2D.createWorld();
    const { joints, limits } = dropRagdoll(phys2D, world);
    let gap = 0;
    let beyond = 0;
    run(world, 20, (time) => {
      if (time > 1) {
        gap = Math.max(gap, worstGap(joints));
        for (const limit of limits) {
          const angle = limit.bodyB.getRotation() - limit.bodyA.getRotation();
          beyond = Math.max(beyond, limit.getLowerBound() - angle, angle - limit.getUpperBound());
        }
      }
    });
    console.log(`ragdoll after 1 s: gaps up to ${mm(gap)}, ${beyond.toFixed(4)} rad beyond its limits`);
    expect(world.liveDynamics).toHaveLength(0);
    // Of 40 other falls half stay below 0.04, nine in ten below 0.065.
    expect(beyond).toBeLessThan(0.06);
    // When a part lands it has stopped before its neighbours know.
    expect(gap).toBeLessThan(0.035);
    expect(worstGap(joints)).toBeLessThan(0.001);
  });

  it('ragdolls come to rest wherever they fall, and then stand still', () => {
    for (let k = 0; k < 12; k += 1) {
      const world = phys2D.createWorld();
      buildStairs(phys2D, world);
      const { parts, joints } = buildRagdoll(phys2D, world, [-3.4 + 0.05 * (k % 4), -1.5 - 0.3 * Math.floor(k / 4)]);
      for (const part of parts) {
        part.setVelocity([1 + (k % 3), 0]);
      }
      run(world, 30);
      expect(world.liveDynamics).toHaveLength(0);
      expect(worstGap(joints)).toBeLessThan(0.001);
    }
  });

  it('the gears never slip', () => {
    const world = phys2D.createWorld();
    const { wheels } = buildGearTrain(phys2D, world);
    let slip = 0;
    run(world, 10, () => {
      const [first, second, third] = wheels.map((wheel) => wheel.getRotation());
      slip = Math.max(slip, Math.abs(first! + 2 * second!), Math.abs(second! + 0.8 * third!));
    });
    console.log(`gears: at most ${slip.toExponential(1)} rad off in ${wheels[0]!.getRotation().toFixed(1)} rad`);
    expect(slip).toBeLessThan(1e-3);
  });

  it('a weight turns the ratchet, a heavier one cannot turn it back', () => {
    const world = phys2D.createWorld();
    const { wheel } = buildRatchet(phys2D, world);
    const tooth = (2 * Math.PI) / TEETH;
    let passed = 0;
    let back = 0;
    let trembles = 0;
    const watch = (): void => {
      passed = Math.max(passed, Math.floor(wheel.getRotation() / tooth));
      back = Math.max(back, passed * tooth - wheel.getRotation());
    };
    hangWeight(phys2D, world, wheel, 1, 2);
    run(world, 5, watch);
    const forth = passed;
    expect(forth).toBeGreaterThanOrEqual(2);
    expect(back).toBeLessThan(0.01);
    hangWeight(phys2D, world, wheel, -1, 10);
    run(world, 10, watch);
    run(world, 1, () => {
      watch();
      trembles = Math.max(trembles, Math.abs(wheel.getAngularVelocity()));
    });
    console.log(
      `ratchet: ${forth} teeth forth, then ${passed}; at most ${back.toFixed(5)} rad behind a tooth, trembles at ${trembles.toFixed(5)} rad/s`,
    );
    expect(passed).toBeGreaterThanOrEqual(forth);
    expect(back).toBeLessThan(0.01);
    // By less than 4e-5 rad in a step, as its row pushes and does not by turns.
    expect(trembles).toBeLessThan(0.002);
  });

  it('the chain breaks in the middle as the ball lands, and what is left hangs on', () => {
    const world = phys2D.createWorld();
    const { joints, ball, broken } = buildBreakableChain(phys2D, world);
    let landed = 0;
    let broke = 0;
    run(world, 3, (time) => {
      landed ||= isTouching(ball) ? time : 0;
      broke ||= broken.length > 0 ? time : 0;
    });
    const count = broken.length;
    run(world, 17);
    const left = joints.filter((joint) => joint.world !== null);
    console.log(`chain: landed at ${landed.toFixed(2)} s, joints ${broken} broke at ${broke.toFixed(2)} s`);
    expect(landed).toBeGreaterThan(0.5);
    expect(broke).toBeGreaterThanOrEqual(landed);
    expect(broke).toBeLessThan(landed + 0.1);
    expect(broken.every((index) => Math.abs(index - 6) <= 2)).toBe(true);
    expect(broken).toHaveLength(count);
    expect(left).toHaveLength(joints.length - count);
    expect(worstGap(left)).toBeLessThan(0.005);
  });

  it('each ends the same twice', () => {
    const builders: Record<string, (world: World) => unknown> = {
      vehicle: (world) => buildVehicle(phys2D, world),
      bridge: (world) => buildBridge(phys2D, world),
      lift: (world) => buildPulleyLift(phys2D, world),
      ragdoll: (world) => dropRagdoll(phys2D, world),
      gears: (world) => buildGearTrain(phys2D, world),
      ratchet: (world) => hangWeight(phys2D, world, buildRatchet(phys2D, world).wheel, 1, 2),
      chain: (world) => buildBreakableChain(phys2D, world),
    };
    for (const [name, build] of Object.entries(builders)) {
      const [first, second] = [0, 1].map(() => {
        const world = phys2D.createWorld();
        build(world);
        run(world, 4);
        return `${name} ${stateHash(world)}`;
      });
      expect(second).toBe(first);
    }
  });
});
