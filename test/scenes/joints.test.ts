import { describe, expect, it } from 'vitest';
import { phys2D, type RigidBody, type World } from '../../src/index.js';
import { buildBreakableChain } from './breakable-chain.js';
import { buildBridge } from './bridge.js';
import { buildGearTrain } from './gear-train.js';
import { stateHash } from './hash.js';
import { worstGap } from './joint-grid.js';
import { buildPulleyLift } from './pulley-lift.js';
import { buildRagdoll, buildStairs } from './ragdoll.js';
import { buildRatchet, TEETH } from './ratchet.js';
import { buildVehicle } from './vehicle.js';

// What the scenes with joints promise.

const DT = 1 / 60;

function run(world: World, seconds: number, each: (i: number) => void = () => {}): void {
  for (let i = 0; i < Math.round(60 * seconds); i += 1) {
    world.step(DT);
    each(i);
  }
}

function local(body: RigidBody, of: RigidBody): [number, number] {
  return body.transformWorldPointToLocal(of.getPosition());
}

describe('scenes with joints', () => {
  it('the vehicle drives over the bumps, its wheels in their guides, its chassis off the ground', () => {
    const world = phys2D.createWorld();
    const { chassis, wheels } = buildVehicle(phys2D, world);
    let astray = 0;
    run(world, 8, () => {
      for (const [i, wheel] of wheels.entries()) {
        const [x, y] = local(chassis, wheel);
        astray = Math.max(astray, Math.abs(x - (i === 0 ? -0.9 : 0.9)), 0.5 - y, y - 1);
      }
      expect(chassis.shapes[0]!.arbiters.filter(({ active }) => active)).toEqual([]);
    });
    const driven = chassis.getPosition()[0];
    console.log(`vehicle: ${driven.toFixed(1)} m in 8 s, wheels ${(1000 * astray).toFixed(2)} mm off their guides`);
    expect(driven).toBeGreaterThan(15);
    expect(Math.abs(chassis.getRotation())).toBeLessThan(1);
    expect(astray).toBeLessThan(0.005);
  });

  it('the bridge sags under its load and comes to rest', () => {
    const world = phys2D.createWorld();
    const { planks, joints, load } = buildBridge(phys2D, world);
    let gap = 0;
    run(world, 30, () => {
      gap = Math.max(gap, worstGap(joints));
    });
    const sag = Math.max(...planks.map((plank) => plank.getPosition()[1]));
    const awake = world.liveDynamics.length;
    console.log(`bridge: widest gap ${(1000 * gap).toFixed(2)} mm, sag ${sag.toFixed(2)} m, ${awake} bodies awake`);
    expect(gap).toBeLessThan(0.02);
    expect(worstGap(joints)).toBeLessThan(0.002);
    expect(sag).toBeLessThan(1.5);
    expect(load.every((body) => body.getPosition()[1] < sag)).toBe(true);
    expect(awake).toBe(0);
  });

  it('the heavier side of the lift sinks, half as fast as the other rises', () => {
    const world = phys2D.createWorld();
    const { cabin, counterweight } = buildPulleyLift(phys2D, world);
    run(world, 1);
    const [, up] = cabin.getVelocity();
    const [, down] = counterweight.getVelocity();
    // Newton for both, with the rope's pull T on the cabin and 2 T on the weight: (2·10 − 22)·10 / (2·10 + 22 / 2)
    const expected = ((2 * 10 - 22) * 10) / (2 * 10 + 22 / 2);
    console.log(`lift: cabin at ${up.toFixed(4)} m/s after 1 s, by Newton ${expected.toFixed(4)}`);
    expect(up).toBeCloseTo(expected, 3);
    expect(down).toBeCloseTo(-up / 2, 6);
    run(world, 1);
    expect(Math.abs(cabin.getPosition()[0] + 2)).toBeLessThan(1e-4);
    expect(6 + cabin.getPosition()[1] + 1 + 2 * (7 + counterweight.getPosition()[1])).toBeCloseTo(15, 4);
  });

  it('the ragdoll falls down the stairs in one piece and comes to rest', () => {
    const world = phys2D.createWorld();
    buildStairs(phys2D, world);
    const { parts, joints, limits } = buildRagdoll(phys2D, world, [-3.4, -1.5]);
    parts[0]!.setVelocity([2, 0]);
    let gap = 0;
    let beyond = 0;
    run(world, 20, () => {
      gap = Math.max(gap, worstGap(joints));
      for (const limit of limits) {
        const angle = limit.bodyB.getRotation() - limit.bodyA.getRotation();
        beyond = Math.max(beyond, limit.getLowerBound() - angle, angle - limit.getUpperBound());
      }
    });
    const awake = world.liveDynamics.length;
    console.log(
      `ragdoll: widest gap ${(1000 * gap).toFixed(2)} mm, ${beyond.toFixed(4)} rad beyond its limits, ${awake} parts awake`,
    );
    expect(gap).toBeLessThan(0.04);
    expect(worstGap(joints)).toBeLessThan(0.001);
    expect(beyond).toBeLessThan(0.1);
    expect(awake).toBe(0);
  });

  it('the gears turn in their ratios', () => {
    const world = phys2D.createWorld();
    const { wheels } = buildGearTrain(phys2D, world);
    run(world, 10);
    const [first, second, third] = wheels.map((wheel) => wheel.getRotation());
    expect(wheels[0]!.getAngularVelocity()).toBeCloseTo(4, 3);
    expect(first).toBeGreaterThan(38);
    expect(second! / first!).toBeCloseTo(-1 / 2, 6);
    expect(third! / second!).toBeCloseTo(-1 / 0.8, 6);
  });

  it('the ratchet turns one way only', () => {
    const world = phys2D.createWorld();
    const { wheel } = buildRatchet(phys2D, world);
    wheel.setTorque(4);
    run(world, 2);
    const forth = wheel.getRotation();
    expect(forth).toBeGreaterThan(2);
    wheel.setTorque(-20);
    run(world, 5);
    const back = forth - wheel.getRotation();
    const tooth = (2 * Math.PI) / TEETH;
    console.log(`ratchet: ${forth.toFixed(3)} rad forth, ${back.toFixed(3)} back, of ${tooth.toFixed(3)} to a tooth`);
    expect(wheel.getAngularVelocity()).toBeCloseTo(0, 3);
    expect((wheel.getRotation() / tooth) % 1).toBeCloseTo(0, 2);
  });

  it('the chain breaks when the ball lands on it, not before', () => {
    const world = phys2D.createWorld();
    const { ball, broken, joints } = buildBreakableChain(phys2D, world);
    run(world, 0.5);
    expect(broken).toEqual([]);
    run(world, 3);
    console.log(`breakable chain: joints ${broken.join(', ')} of ${joints.length} broke`);
    expect(broken.length).toBeGreaterThan(0);
    expect(broken.length).toBeLessThan(5);
    expect(ball.getPosition()[1]).toBeGreaterThan(5);
    expect(world.constraints).toHaveLength(joints.length - broken.length);
  });

  it('all of them end the same twice', () => {
    const hash = (build: (world: World) => unknown): string => {
      const world = phys2D.createWorld();
      build(world);
      run(world, 3);
      return stateHash(world);
    };
    for (const build of [
      buildVehicle,
      buildBridge,
      buildPulleyLift,
      buildGearTrain,
      buildRatchet,
      buildBreakableChain,
    ]) {
      expect(hash((world) => build(phys2D, world))).toBe(hash((world) => build(phys2D, world)));
    }
  });
});
