import type { Physics2DDevice, RigidBody, Vec2, World } from '../../src/index.js';
import { atan2, cos, sin } from '../../src/math/trig.js';
import { Builder, type Controls, friction, type Play } from './play.js';

export interface TopDown extends Play {
  readonly car: RigidBody;
  readonly cones: readonly RigidBody[];
}

/** N. What the engine gives, and what the tyres of an axle bear sideways: beyond that the car drifts. */
const [DRIVE, GRIP] = [26, 18];
/** m, rad. From the middle to an axle, and how far the wheels turn. */
const [AXLE, LOCK] = [0.75, 0.5];
/** N·m. Of the motors of rate 0 that let things come to rest on the ground. */
const [CONE_FRICTION, CAR_FRICTION] = [0.05, 1];

/** A car seen from above, on a round track with cones. It drives by itself until someone steers. */
export function buildTopDown(phys2D: Physics2DDevice, world: World): TopDown {
  const yard = new Builder(phys2D, world);
  const [halfWidth, halfHeight] = [12, 8];
  const rail = { surface: friction(0.2, 0.4) };
  yard.wall(-halfWidth - 0.4, -halfHeight - 0.4, halfWidth + 0.4, -halfHeight, rail);
  yard.wall(-halfWidth - 0.4, halfHeight, halfWidth + 0.4, halfHeight + 0.4, rail);
  yard.wall(-halfWidth - 0.4, -halfHeight, -halfWidth, halfHeight, rail);
  yard.wall(halfWidth, -halfHeight, halfWidth + 0.4, halfHeight, rail);
  for (const x of [-5, 5]) {
    yard.disc(x, 0, 1.6, { type: 'static', ...rail });
  }
  yard.wall(-5, -1.6, 5, 1.6, rail);
  const ground = phys2D.createRigidBody({ type: 'static' });
  const brake = (body: RigidBody, maxForce: number): void => {
    world.addConstraint(phys2D.createMotorConstraint({ bodyA: ground, bodyB: body, maxForce }));
  };
  const cones: RigidBody[] = [];
  for (let i = 0; i < 26; i += 1) {
    const angle = (2 * Math.PI * i) / 26;
    const position: [number, number] = [10.6 * cos(angle), 6.9 * sin(angle)];
    const size = i % 2 === 0 ? 0.4 : 0.5;
    const cone = yard.box(0, 0, size, size, {
      position,
      rotation: angle,
      linearDrag: 0.9,
      surface: friction(0.3, 0.2),
    });
    brake(cone, CONE_FRICTION);
    cones.push(cone);
  }
  const car = yard.box(0, 4.4, 2, 1, { linearDrag: 0.35, angularDrag: 0.6, surface: friction(0.3, 0.2) });
  brake(car, CAR_FRICTION);
  let byHand = false;
  const beforeStep = (controls: Readonly<Controls>): void => {
    byHand ||= controls.left || controls.right || controls.up || controls.down;
    const [throttle, steer] = byHand ? steering(controls) : pilot(car);
    roll(car, 1, steer * LOCK, throttle * DRIVE);
    roll(car, -1, 0, 0);
  };
  return { car, cones, follow: car, beforeStep };
}

function steering({ left, right, up, down }: Readonly<Controls>): Vec2 {
  return [(up ? 1 : 0) - (down ? 0.6 : 0), (right ? 1 : 0) - (left ? 1 : 0)];
}

/** Drives to the right below the island, and around it: towards a point ahead on an ellipse. */
function pilot(car: RigidBody): Vec2 {
  const [x, y] = car.getPosition();
  const ahead = atan2(y / 4.6, x / 8.6) - 0.5;
  const [, side] = car.transformWorldVectorToLocal([8.6 * cos(ahead) - x, 4.6 * sin(ahead) - y]);
  return [0.7, Math.max(-1, Math.min(1, side))];
}

/** An axle: what drives it goes along its wheels; across them it holds as far as its grip goes. */
function roll(car: RigidBody, end: 1 | -1, angle: number, force: number): void {
  const along = car.transformLocalVectorToWorld([cos(angle), sin(angle)]);
  const [ax, ay] = car.transformLocalVectorToWorld([end * AXLE, 0]);
  const [vx, vy] = car.getVelocity();
  const spin = car.getAngularVelocity();
  const across: Vec2 = [-along[1], along[0]];
  const slip = (vx - spin * ay) * across[0] + (vy + spin * ax) * across[1];
  const arm = ax * across[1] - ay * across[0];
  const effective = 1 / (1 / car.getMass() + (arm * arm) / car.getInertia());
  const hold = Math.max(-GRIP / 60, Math.min(GRIP / 60, -0.5 * slip * effective));
  const push = force / 60;
  const impulse: Vec2 = [push * along[0] + hold * across[0], push * along[1] + hold * across[1]];
  const [x, y] = car.getPosition();
  if (impulse[0] !== 0 || impulse[1] !== 0) {
    car.applyImpulse(impulse, [x + ax, y + ay]);
  }
}
