import { describe, expect, it } from 'vitest';
import { type ConstraintParams, phys2D, type RigidBody } from '../../src/index.js';
import { add, DT, plainBody, steps, tie, weightless } from '../conformance/setting.js';

describe('ignoreInteractions', () => {
  /** Two overlapping bodies, and whether they interact in the next step. */
  function overlapping() {
    const world = weightless();
    const [a, b] = [plainBody(), plainBody({ position: [0.9, 0] })];
    add(world, a, b);
    const events: string[] = [];
    for (const type of ['begin', 'end'] as const) {
      a.shapes[0]!.addEventListener(type, () => events.push(type));
    }
    const meet = (): boolean => {
      world.step(DT);
      return a.shapes[0]!.arbiters.some((arbiter) => arbiter.active);
    };
    return { world, a, b, meet, events };
  }
  const angle = (bodyA: RigidBody, bodyB: RigidBody, params: ConstraintParams = { ignoreInteractions: true }) =>
    phys2D.createAngleConstraint({ bodyA, bodyB, ...params });

  it('follows add, configure, disable, enable and remove, with begin and end', () => {
    const { world, a, b, meet, events } = overlapping();
    const constraint = angle(b, a);
    expect(meet()).toBe(true);
    tie(world, constraint);
    expect(meet()).toBe(false);
    constraint.configure({ ignoreInteractions: false });
    expect(meet()).toBe(true);
    constraint.configure({ ignoreInteractions: true });
    constraint.configure({ damping: 2 });
    expect(meet()).toBe(false);
    constraint.disable();
    expect(meet()).toBe(true);
    constraint.configure({ ignoreInteractions: false });
    constraint.enable();
    expect(meet()).toBe(true);
    constraint.disable();
    constraint.configure({ ignoreInteractions: true });
    expect(meet()).toBe(true);
    constraint.enable();
    expect(meet()).toBe(false);
    world.removeConstraint(constraint);
    expect(meet()).toBe(true);
    expect(events).toEqual(['begin', 'end', 'begin', 'end', 'begin', 'end', 'begin']);
  });

  it('acts while the constraint is asleep, and ends when it breaks', () => {
    const { world, a, b, meet } = overlapping();
    const constraint = angle(a, b, { ignoreInteractions: true, breakUnderError: true, maxError: 0.5 });
    tie(world, constraint);
    constraint.sleep();
    expect(meet()).toBe(false);
    b.setRotation(1);
    constraint.wake();
    expect(meet()).toBe(false);
    expect(constraint.world).toBeNull();
    expect(meet()).toBe(true);
  });

  it('lasts until the last such constraint is gone', () => {
    const { world, a, b, meet } = overlapping();
    const [one, other] = [angle(a, b), angle(b, a)];
    tie(world, one, other);
    world.removeConstraint(one);
    expect(meet()).toBe(false);
    other.disable();
    expect(meet()).toBe(true);
  });

  it('concerns the two bodies alone', () => {
    const { world, a, b, meet } = overlapping();
    const c = plainBody({ position: [0, 9] });
    add(world, c);
    tie(world, angle(a, c), angle(c, b));
    expect(meet()).toBe(true);
  });

  it('concerns every two bodies of a pulley or a custom constraint', () => {
    for (const kind of ['pulley', 'custom']) {
      const { world, a, b, meet } = overlapping();
      const [c, d] = [plainBody({ position: [0, 9] }), plainBody({ position: [0, -9] })];
      add(world, c, d);
      const four = { bodyA: c, bodyB: a, bodyC: d, bodyD: b, upperBound: 100 };
      tie(
        world,
        kind === 'pulley'
          ? phys2D.createPulleyConstraint({ ...four, ignoreInteractions: true })
          : phys2D.createCustomConstraint({
              dimension: 1,
              bodies: [a, c, b, a],
              jacobian() {},
              ignoreInteractions: true,
            }),
      );
      expect(meet(), kind).toBe(false);
    }
  });

  it('is over after clear() and for a constraint that is in no world', () => {
    const { world, a, b, meet } = overlapping();
    const constraint = angle(a, b);
    tie(world, constraint);
    expect(meet()).toBe(false);
    world.clear();
    add(world, a, b);
    expect(meet()).toBe(true);
    constraint.configure({ ignoreInteractions: false });
    constraint.configure({ ignoreInteractions: true });
    constraint.disable();
    constraint.enable();
    expect(meet()).toBe(true);
    tie(world, constraint);
    expect(meet()).toBe(false);
  });

  it('counts a constraint once that is switched off by a callback in the step in which it breaks', () => {
    const world = weightless();
    const a = plainBody({ velocity: [1, 0] });
    const b = plainBody({ position: [0.5, 0] });
    add(world, a, b);
    let isDisabling = true;
    const custom = phys2D.createCustomConstraint({
      dimension: 1,
      bodies: [a, b],
      ignoreInteractions: true,
      breakUnderForce: true,
      removeOnBreak: false,
      maxForce: 0,
      jacobian(data, index) {
        data[index] = 1;
      },
      velocityClamp() {
        if (isDisabling) this.disable();
      },
    });
    tie(world, custom);
    steps(world, 1);
    expect(custom.isDisabled()).toBe(true);
    isDisabling = false;
    custom.configure({ breakUnderForce: false });
    custom.enable();
    steps(world, 2);
    expect(a.shapes[0]!.arbiters.filter(({ active }) => active)).toEqual([]);
  });
});
