import type { Physics2DDevice, RigidBody, World } from '../../src/index.js';

/** m. What the gallery fills, from the origin. */
export const GALLERY: readonly [width: number, height: number] = [15, 10];

/**
 * One constraint of each kind, two rows of four: point, weld, distance, line; angle, motor, pulley, custom. Those that can show a spring are
 * elastic, and begin out of place. Under them a floor with a heap on it, a sensor, a bullet and a kinematic platform.
 */
export function buildGallery(phys2D: Physics2DDevice, world: World): void {
  const box = (width: number, height: number) =>
    phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, height) });
  const add = (x: number, y: number, params: Parameters<Physics2DDevice['createRigidBody']>[0]): RigidBody => {
    const body = phys2D.createRigidBody({ position: [x, y], ...params });
    world.addRigidBody(body);
    return body;
  };
  const peg = (x: number, y: number): RigidBody =>
    add(x, y, { type: 'static', shapes: [phys2D.createCircleShape({ radius: 0.25 })] });
  const crate = (x: number, y: number, rotation = 0): RigidBody => add(x, y, { rotation, shapes: [box(0.9, 0.6)] });
  const wheel = (x: number, y: number, params: { angularVelocity?: number; rotation?: number } = {}): RigidBody =>
    add(x, y, { shapes: [phys2D.createCircleShape({ radius: 0.5 })], ...params });
  const soft = { stiff: false, frequency: 1, damping: 0.1 };

  const point = { bodyA: peg(2, 1), bodyB: crate(2.9, 1.2, 0.3), anchorA: [0.25, 0], anchorB: [-0.45, -0.3] };
  world.addConstraint(phys2D.createPointConstraint({ ...point, ignoreInteractions: true }));

  const weld = { bodyA: peg(5, 1.4), bodyB: crate(6, 2, 0.9), anchorA: [0.25, 0], anchorB: [-0.45, 0] };
  world.addConstraint(phys2D.createWeldConstraint({ ...weld, ...soft, phase: -0.6, ignoreInteractions: true }));

  const rope = { bodyA: peg(8.6, 0.8), bodyB: crate(9.2, 3.4, 0.2), anchorB: [0, -0.3] };
  world.addConstraint(phys2D.createDistanceConstraint({ ...rope, ...soft, lowerBound: 0.8, upperBound: 1.6 }));

  const rail = { bodyA: peg(11.6, 1), bodyB: wheel(13, 2.4), axis: [2, 1] };
  world.addConstraint(phys2D.createLineConstraint({ ...rail, ...soft, lowerBound: 0.5, upperBound: 2.6 }));

  const gear = { bodyA: wheel(1.4, 5), bodyB: wheel(3, 5, { angularVelocity: 3, rotation: 1.6 }) };
  for (const body of [gear.bodyA, gear.bodyB]) {
    world.addConstraint(
      phys2D.createPointConstraint({ bodyA: peg(...body.getPosition()), bodyB: body, ignoreInteractions: true }),
    );
  }
  world.addConstraint(phys2D.createAngleConstraint({ ...gear, ...soft, lowerBound: -1, upperBound: 1, ratio: -1.5 }));

  const turned = wheel(5.6, 5);
  const axle = peg(5.6, 5);
  world.addConstraint(phys2D.createPointConstraint({ bodyA: axle, bodyB: turned, ignoreInteractions: true }));
  world.addConstraint(phys2D.createMotorConstraint({ bodyA: axle, bodyB: turned, rate: 4 }));

  const lift = { bodyA: crate(8.2, 6), bodyB: peg(8.2, 4.2), bodyC: peg(9.6, 4.2), bodyD: crate(9.6, 5.4) };
  const rim = { anchorA: [0, -0.3], anchorB: [-0.25, 0], anchorC: [0.25, 0], anchorD: [0, -0.3] };
  world.addConstraint(phys2D.createPulleyConstraint({ ...lift, ...rim, ...soft, lowerBound: 1.2, upperBound: 2 }));

  const bead = wheel(13, 4.5);
  const parabola = (x: number): number => 5.6 - (x - 12.2) * (x - 12.2);
  world.addConstraint(
    phys2D.createCustomConstraint({
      dimension: 1,
      bodies: [bead],
      position(data, index) {
        const [x, y] = bead.getPosition();
        data[index] = y - parabola(x);
      },
      jacobian(data, index) {
        data[index] = 2 * (bead.getPosition()[0] - 12.2);
        data[index + 1] = 1;
      },
      debugDraw(debug) {
        debug.drawCurve(10.7, parabola(10.7), 12.2, 5.6 + 2.25, 13.7, parabola(13.7), debug.constraintErrorColorC);
      },
    }),
  );

  add(7.5, 9.7, { type: 'static', shapes: [box(14.4, 0.4)] });
  add(2.4, 8.2, { type: 'kinematic', velocity: [0.5, 0], rotation: 0.1, shapes: [box(1.6, 0.3)] });
  const zone = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(2.6, 1.6), sensor: true });
  add(12.4, 8.7, { type: 'static', shapes: [zone] });
  const bullet = phys2D.createPolygonShape({ vertices: phys2D.createRegularPolygonVertices(0.5, 0.5, 6) });
  add(11, 8.4, { bullet: true, velocity: [2, -1], angularVelocity: 2, shapes: [bullet] });
  for (const [x, y] of [
    [5.6, 9.2],
    [6.7, 9.2],
    [6.1, 8.6],
    [9.2, 9.2],
  ] as const) {
    crate(x, y);
  }
}
