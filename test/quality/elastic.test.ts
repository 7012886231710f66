import { describe, expect, it } from 'vitest';
import { type Constraint, phys2D, type RigidBody } from '../../src/index.js';
import { plainBody, staticBody, weightless } from '../conformance/setting.js';

// Elastic constraints oscillate freely with their frequency and damping ratio, whatever the masses.

interface Measured {
  /** Hz, of the undamped oscillation. */
  readonly frequency: number;
  readonly damping: number;
}

/**
 * Frequency and damping ratio of what `value` tells from step to step: times of the crossings of 0 give the damped frequency, the
 * extremes between them the logarithmic decrement.
 */
function observe(value: () => number, step: () => void, dt: number, duration: number): Measured {
  const crossings: number[] = [];
  const extremes: number[] = [];
  let before = value();
  let extreme = 0;
  for (let t = dt; t < duration; t += dt) {
    step();
    const now = value();
    if (before > 0 !== now > 0) {
      crossings.push(t - (dt * now) / (now - before));
      extremes.push(extreme);
      extreme = 0;
    }
    extreme = Math.max(extreme, Math.abs(now));
    before = now;
  }
  const last = Math.min(crossings.length - 1, 8);
  const damped = last / 2 / (crossings[last]! - crossings[0]!);
  const decrement = Math.log(extremes[1]! / extremes[last]!) / (last - 1);
  const damping = decrement / Math.sqrt(Math.PI * Math.PI + decrement * decrement);
  return { frequency: damped / Math.sqrt(1 - damping * damping), damping };
}

type Spring = { stiff: false; frequency: number; damping: number };

interface Kind {
  readonly name: string;
  /** Makes the constraint, displaces the body, and tells how far it is displaced. */
  readonly build: (a: RigidBody, b: RigidBody, spring: Spring) => { constraint: Constraint; value: () => number };
}

const KINDS: readonly Kind[] = [
  {
    name: 'distance',
    build: (a, b, spring) => {
      b.setPosition([4.1, 0]);
      const constraint = phys2D.createDistanceConstraint({
        bodyA: a,
        bodyB: b,
        lowerBound: 4,
        upperBound: 4,
        ...spring,
      });
      return { constraint, value: () => b.getPosition()[0] - a.getPosition()[0] - 4 };
    },
  },
  {
    name: 'point',
    build: (a, b, spring) => {
      b.setPosition([0, 0.1]);
      const constraint = phys2D.createPointConstraint({ bodyA: a, bodyB: b, ...spring });
      return { constraint, value: () => b.getPosition()[1] - a.getPosition()[1] };
    },
  },
  {
    name: 'angle',
    build: (a, b, spring) => {
      b.setPosition([4, 0]);
      b.setRotation(0.1);
      const constraint = phys2D.createAngleConstraint({ bodyA: a, bodyB: b, ...spring });
      return { constraint, value: () => b.getRotation() - a.getRotation() };
    },
  },
];

function measure(kind: Kind, massRatio: number, isFree: boolean, spring: Spring, dt: number): Measured {
  const world = weightless({ allowSleeping: false });
  const b = plainBody({ mass: massRatio, inertia: massRatio });
  const a = isFree ? plainBody() : staticBody();
  world.addRigidBody(b);
  world.addRigidBody(a);
  const { constraint, value } = kind.build(a, b, spring);
  constraint.configure({ ignoreInteractions: true });
  world.addConstraint(constraint);
  return observe(value, () => world.step(dt), dt, 6 / spring.frequency);
}

describe('elastic constraints', () => {
  for (const kind of KINDS) {
    it(`a free ${kind.name} has its frequency within 2 % and its damping ratio within 5 % at 1/240 s`, () => {
      let off = { frequency: 0, damping: 0 };
      let coarse = { frequency: 0, damping: 0 };
      for (const frequency of [1, 2, 5]) {
        for (const damping of [0.1, 0.2]) {
          for (const massRatio of [1, 100]) {
            for (const isFree of [false, true]) {
              const spring: Spring = { stiff: false, frequency, damping };
              const error = (dt: number): Measured => {
                const got = measure(kind, massRatio, isFree, spring, dt);
                return {
                  frequency: Math.abs(got.frequency / frequency - 1),
                  damping: Math.abs(got.damping / damping - 1),
                };
              };
              off = worse(off, error(1 / 240));
              coarse = worse(coarse, error(1 / 60));
            }
          }
        }
      }
      const percent = (value: number): string => `${(100 * value).toFixed(2)} %`;
      console.log(
        `elastic ${kind.name}: frequency off by ${percent(off.frequency)} (target 2 %), damping ratio by ` +
          `${percent(off.damping)} (target 5 %); at 1/60 s ${percent(coarse.frequency)}, ${percent(coarse.damping)}`,
      );
      expect(off.frequency).toBeLessThanOrEqual(0.02);
      expect(off.damping).toBeLessThanOrEqual(0.05);
    });
  }
});

function worse(a: Measured, b: Measured): Measured {
  return { frequency: Math.max(a.frequency, b.frequency), damping: Math.max(a.damping, b.damping) };
}
