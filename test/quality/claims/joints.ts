import type { Physics2DDevice, PointConstraint, RigidBody, World } from '../../../src/index.js';
import { buildJointGrid, worstGap } from '../../scenes/joint-grid.js';
import { plainMaterial } from '../../scenes/stacks.js';
import { type Claim, type Figure, run } from './claim.js';

const APART = { group: 2, mask: 1 };
const FREE = { linearDrag: 0, angularDrag: 0 };

/** A chain of links of 1 m, held at the origin; `spacing` from link to link, and a ball at the end if it has a mass. */
function buildChain(phys2D: Physics2DDevice, world: World, count: number, spacing: number, ballMass = 0) {
  const joints: PointConstraint[] = [];
  const bodies: RigidBody[] = [];
  let last = phys2D.createRigidBody({ type: 'static', position: [0, 0] });
  world.addRigidBody(last);
  const append = (body: RigidBody, anchorA: [number, number], anchorB: [number, number]): void => {
    world.addRigidBody(body);
    const joint = phys2D.createPointConstraint({ bodyA: last, bodyB: body, anchorA, anchorB });
    world.addConstraint(joint);
    joints.push(joint);
    bodies.push(body);
    last = body;
  };
  for (let i = 0; i < count; i += 1) {
    const shape = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(1, 0.2), ...APART });
    const link = phys2D.createRigidBody({ position: [(i + 0.5) * spacing, 0], shapes: [shape], ...FREE });
    append(link, i === 0 ? [0, 0] : [0.5, 0], [-0.5, 0]);
  }
  if (ballMass > 0) {
    // Of 1 m radius; links weigh 0.2 kg.
    const material = plainMaterial(phys2D, 0.6, ballMass / Math.PI);
    const ball = phys2D.createCircleShape({ radius: 1, material, ...APART });
    const body = phys2D.createRigidBody({ position: [count * spacing + 1, 0], shapes: [ball], ...FREE });
    append(body, [0.5, 0], [-1, 0]);
  }
  return { joints, bodies };
}

export const heavyChain: Claim = {
  scene: 'chain of ten links with a ball of 100 times the mass of one, falling from level',
  measure(phys2D): Figure[] {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const { joints } = buildChain(phys2D, world, 10, 1, 20);
    let early = 0;
    let late = 0;
    run(world, 10, (step) => {
      const gap = worstGap(joints);
      early = Math.max(early, step <= 300 ? gap : 0);
      late = Math.max(late, step > 300 ? gap : 0);
    });
    return [
      { what: 'widest gap, 5 s to 10 s', value: late, unit: 'm', limit: 0.015 },
      { what: 'widest gap in the first 5 s', value: early, unit: 'm' },
    ];
  },
};

export const stretchedChain: Claim = {
  scene: 'chain of 40 links created at twice its length',
  measure(phys2D): Figure[] {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const { joints, bodies } = buildChain(phys2D, world, 40, 2);
    let first = Infinity;
    run(world, 4, (step) => {
      const [x, y] = bodies.at(-1)!.transformLocalPointToWorld([0.5, 0]);
      const gaps = joints.reduce((sum, { bodyA, bodyB }, i) => {
        const [ax, ay] = bodyA.transformLocalPointToWorld(i === 0 ? [0, 0] : [0.5, 0]);
        const [bx, by] = bodyB.transformLocalPointToWorld([-0.5, 0]);
        return sum + Math.sqrt((bx - ax) ** 2 + (by - ay) ** 2);
      }, 0);
      const isWhole = gaps <= 0.4 && Math.sqrt(x * x + y * y) < 40.4;
      first = Math.min(first, isWhole ? step : Infinity);
    });
    return [{ what: 'time until it is 1 % too long', value: first / 60, unit: 's', limit: 1 }];
  },
};

export const jointGrid: Claim = {
  scene: 'net of 40 × 40 and of 100 × 100 discs, 10 s and 5 s',
  measure(phys2D): Figure[] {
    return [
      [40, 10, 0.01],
      [100, 5, 0.05],
    ].map(([size, seconds, limit]) => {
      const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
      const { joints } = buildJointGrid(phys2D, world, size!);
      let gap = 0;
      run(world, seconds!, () => {
        gap = Math.max(gap, worstGap(joints));
      });
      return { what: `widest gap, ${size} × ${size}`, value: gap, unit: 'm', limit: limit! };
    });
  },
};

export const pendulum: Claim = {
  scene: 'pendulum of 1 m released level, 60 s',
  measure(phys2D): Figure[] {
    const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
    const pivot = phys2D.createRigidBody({ type: 'static', position: [0, 0] });
    world.addRigidBody(pivot);
    const shape = phys2D.createCircleShape({ radius: 0.25, ...APART });
    const bob = phys2D.createRigidBody({ position: [1, 0], shapes: [shape], ...FREE });
    world.addRigidBody(bob);
    world.addConstraint(phys2D.createPointConstraint({ bodyA: pivot, bodyB: bob, anchorA: [0, 0], anchorB: [-1, 0] }));
    let gain = 0;
    let apex = 0;
    run(world, 60, (step) => {
      const height = 1 - Math.max(0, bob.getPosition()[1]);
      gain = Math.max(gain, -bob.getPosition()[1]);
      apex = step > 3600 - 180 ? Math.max(apex, height) : 0;
    });
    return [
      { what: 'apex lower after 60 s', value: 100 * (1 - apex), unit: '%', limit: 0.5 },
      { what: 'ever above the start', value: gain, unit: 'm', limit: 1e-9 },
    ];
  },
};
