import type { CustomConstraint, Physics2DDevice, RigidBody, World } from '../../src/index.js';

export interface Ratchet {
  readonly wheel: RigidBody;
  readonly pawl: CustomConstraint;
}

/** Teeth around the wheel. */
export const TEETH = 12;

/**
 * A wheel that turns clockwise only, to the next of its teeth at least: a custom constraint of one row. Its error is how far the wheel has
 * turned back behind the last tooth that it passed, and its impulse only ever pushes forward.
 */
export function buildRatchet(phys2D: Physics2DDevice, world: World): Ratchet {
  const frame = phys2D.createRigidBody({ type: 'static' });
  const wheel = phys2D.createRigidBody({ shapes: [phys2D.createCircleShape({ radius: 1 })] });
  world.addRigidBody(wheel);
  world.addConstraint(phys2D.createPointConstraint({ bodyA: frame, bodyB: wheel }));
  const tooth = (2 * Math.PI) / TEETH;
  let passed = 0;
  const forward = (data: { [index: number]: number }, index: number): void => {
    data[index] = Math.max(0, data[index]!);
  };
  const pawl = phys2D.createCustomConstraint({
    dimension: 1,
    bodies: [wheel],
    positionConstants() {
      passed = Math.max(passed, Math.floor(wheel.getRotation() / tooth));
    },
    position(data, index) {
      data[index] = Math.min(0, wheel.getRotation() - passed * tooth);
    },
    jacobian(data, index) {
      data[index + 2] = wheel.getRotation() <= passed * tooth ? 1 : 0;
    },
    velocityClamp: forward,
    positionClamp: forward,
  });
  world.addConstraint(pawl);
  return { wheel, pawl };
}

/** Hangs a weight on a rope from the rim of the wheel, on the right (1), which turns it clockwise, or on the left (−1). @returns the weight. */
export function hangWeight(
  phys2D: Physics2DDevice,
  world: World,
  wheel: RigidBody,
  side: 1 | -1,
  mass: number,
): RigidBody {
  const [x, y] = wheel.getPosition();
  const shapes = [phys2D.createCircleShape({ radius: 0.2 })];
  const weight = phys2D.createRigidBody({ position: [x + side, y + 1.5], mass, shapes });
  world.addRigidBody(weight);
  world.addConstraint(
    phys2D.createDistanceConstraint({
      bodyA: wheel,
      bodyB: weight,
      anchorA: wheel.transformWorldPointToLocal([x + side, y]),
      upperBound: 1.5,
      ignoreInteractions: true,
    }),
  );
  return weight;
}
