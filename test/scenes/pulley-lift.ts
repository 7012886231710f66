import type { LineConstraint, Physics2DDevice, PulleyConstraint, RigidBody, World } from '../../src/index.js';

export interface PulleyLift {
  readonly cabin: RigidBody;
  readonly counterweight: RigidBody;
  readonly pulley: PulleyConstraint;
  /** Keep cabin and counterweight in their shafts. */
  readonly guides: readonly LineConstraint[];
}

/** A cabin and a counterweight that hang on one rope over two wheels; the counterweight on a tackle, so it moves half as far. */
export function buildPulleyLift(phys2D: Physics2DDevice, world: World): PulleyLift {
  const roof = phys2D.createRigidBody({ type: 'static', position: [0, -8] });
  const box = (x: number, y: number, mass: number) => {
    const body = phys2D.createRigidBody({
      position: [x, y],
      mass,
      linearDrag: 0,
      shapes: [phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1.6, 2) })],
    });
    world.addRigidBody(body);
    return body;
  };
  const cabin = box(-2, 0, 10);
  const counterweight = box(2, -3, 22);
  const guides = [cabin, counterweight].map((bodyB) => {
    const anchorA: [number, number] = [bodyB.getPosition()[0], 0];
    const guide = phys2D.createLineConstraint({ bodyA: roof, bodyB, anchorA, axis: [0, 1] });
    world.addConstraint(guide);
    world.addConstraint(phys2D.createAngleConstraint({ bodyA: roof, bodyB }));
    return guide;
  });
  const rope = 7 + 2 * 4;
  const pulley = phys2D.createPulleyConstraint({
    bodyA: cabin,
    anchorA: [0, -1],
    bodyB: roof,
    anchorB: [-2, 0],
    bodyC: roof,
    anchorC: [2, 0],
    bodyD: counterweight,
    anchorD: [0, -1],
    ratio: 2,
    lowerBound: rope,
    upperBound: rope,
  });
  world.addConstraint(pulley);
  return { cabin, counterweight, pulley, guides };
}
