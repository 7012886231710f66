import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import { describe, expect, it } from 'vitest';
import { type Constraint, phys2D, type RigidBody, type RigidBodyParams, type World } from '../../src/index.js';
import { addFloor, boxBody, plainBody, steps, weightless } from '../conformance/setting.js';
import { phys2D as built } from './built.js';

function pile(count: number): World {
  const world = phys2D.createWorld();
  addFloor(world);
  for (let i = 0; i < count; i += 1) {
    world.addRigidBody(boxBody(1, 1, { position: [1.02 * (i % 10) - 5, -0.1 - 1.01 * Math.floor(i / 10)] }));
  }
  return world;
}

/** The bytes of a snapshot, without what it knows of its objects. */
function copyOf(snapshot: ArrayBuffer): ArrayBuffer {
  return snapshot.slice(0);
}

describe('World.restore', () => {
  it('takes away what was added since, and brings back what was removed, as the same objects', () => {
    const world = pile(20);
    steps(world, 30);
    const [, first, second] = world.rigidBodies as [RigidBody, RigidBody, RigidBody];
    const constraint = phys2D.createPointConstraint({ bodyA: first, bodyB: second });
    world.addConstraint(constraint);
    steps(world, 10);
    const bodies = [...world.rigidBodies];
    const snapshot = world.snapshot();
    const hash = world.hash();
    world.removeRigidBody(first);
    const added = plainBody({ position: [0, -20] });
    world.addRigidBody(added);
    world.addConstraint(phys2D.createPointConstraint({ bodyA: added, bodyB: second }));
    steps(world, 10);
    world.restore(snapshot);
    expect(world.rigidBodies).toEqual(bodies);
    expect(world.constraints).toEqual([constraint]);
    expect(added.world).toBeNull();
    expect(added.constraints).toEqual([]);
    expect(first.world).toBe(world);
    expect(world.hash()).toBe(hash);
    const store: RigidBody[] = [];
    expect(world.bodyPointQuery(first.getPosition(), store)).toBeGreaterThan(0);
    expect(store).toContain(first);
    expect(world.bodyPointQuery([0, -20], store)).toBe(0);
  });

  it('brings back shapes, their geometry and material, and the type of a body', () => {
    const world = weightless();
    const body = boxBody(1, 1, { position: [3, 4] });
    const [shape] = body.shapes;
    world.addRigidBody(body);
    world.step(1 / 60);
    const snapshot = world.snapshot();
    const hash = world.hash();
    const material = shape!.getMaterial();
    const mass = body.getMass();
    shape!.setMaterial(phys2D.createMaterial({ density: 7 }));
    shape!.scale(3);
    body.addShape(phys2D.createCircleShape({ radius: 1 }));
    body.removeShape(shape!);
    const other = phys2D.createRigidBody({ shapes: [shape!] });
    body.setAsKinematic();
    world.step(1 / 60);
    world.restore(snapshot);
    expect(body.shapes).toEqual([shape]);
    expect(other.shapes).toEqual([]);
    expect(shape!.body).toBe(body);
    expect(shape!.getMaterial()).toBe(material);
    expect(shape!.computeArea()).toBe(1);
    expect(body.isDynamic()).toBe(true);
    expect(body.getMass()).toBe(mass);
    expect(world.hash()).toBe(hash);
  });

  it('tells an `end` that waited', () => {
    const world = phys2D.createWorld();
    addFloor(world);
    const body = boxBody(1, 1, { position: [0, 0] });
    world.addRigidBody(body);
    steps(world, 10);
    const ended: unknown[] = [];
    body.shapes[0]!.addEventListener('end', (_arbiter, other) => void ended.push(other));
    world.removeRigidBody(body);
    const snapshot = world.snapshot();
    world.step(1 / 60);
    expect(ended).toHaveLength(1);
    world.restore(snapshot);
    world.step(1 / 60);
    expect(ended).toHaveLength(2);
    expect(ended[1]).toBe(ended[0]);
  });

  it('wakes what had fallen asleep since, with what it tells', () => {
    const world = pile(10);
    steps(world, 20);
    const snapshot = world.snapshot();
    const hashes = Array.from({ length: 200 }, () => {
      world.step(1 / 60);
      return world.hash();
    });
    expect(world.liveDynamics).toHaveLength(0);
    world.restore(snapshot);
    expect(world.liveDynamics).toHaveLength(10);
    expect(
      hashes.map(() => {
        world.step(1 / 60);
        return world.hash();
      }),
    ).toEqual(hashes);
  });

  it('keeps what a custom constraint remembers', () => {
    const world = weightless();
    const body = plainBody();
    world.addRigidBody(body);
    const state = new Float64Array(1);
    const constraint = phys2D.createCustomConstraint({
      dimension: 1,
      bodies: [body],
      state,
      jacobian(data, index) {
        state[0]! += 1;
        data[index] = state[0]!;
      },
    });
    world.addConstraint(constraint);
    steps(world, 5);
    const snapshot = world.snapshot();
    const hash = world.hash();
    expect(state[0]).toBe(5);
    steps(world, 5);
    expect(state[0]).toBe(10);
    world.restore(snapshot);
    expect(state[0]).toBe(5);
    expect(world.hash()).toBe(hash);
    expect(() => phys2D.createCustomConstraint({ ...constraint.callbacks, state: [1] as never })).toThrow(
      'createCustomConstraint: state must be a Float64Array, got an array of length 1',
    );
  });

  it.each([
    ['another dimension', [2, 2, 1], 'a custom constraint of it has another dimension'],
    ['another body', [1, 3, 1], 'a custom constraint of it has more or fewer bodies'],
    ['a longer state', [1, 2, 2], 'the state of a custom constraint of it has another length'],
  ] as const)('tells a custom constraint with %s, and is not put into it', (_, [dimension, count, length], why) => {
    const tied = (rows: number, members: number, remembered: number): World => {
      const world = weightless();
      const bodies = Array.from({ length: 2 }, () => plainBody());
      bodies.forEach((body) => void world.addRigidBody(body));
      world.addConstraint(
        phys2D.createCustomConstraint({
          dimension: rows,
          bodies: [...bodies, ...bodies].slice(0, members),
          state: new Float64Array(remembered),
          jacobian: () => undefined,
        }),
      );
      return world;
    };
    const world = tied(1, 2, 1);
    const other = tied(dimension, count, length);
    const before = other.hash();
    expect(tied(1, 2, 1).hash()).toBe(world.hash());
    expect(before).not.toBe(world.hash());
    expect(() => other.restore(world.snapshot().slice(0))).toThrow(
      new Error(`World.restore: the snapshot cannot be restored here: ${why}`),
    );
    expect(other.hash()).toBe(before);
  });

  it('takes what is held before what has the same number in the world by now', () => {
    const world = phys2D.createWorld();
    const add = () => {
      const body = phys2D.createRigidBody({ shapes: [phys2D.createCircleShape({ radius: 0.5 })] });
      world.addRigidBody(body);
      return body;
    };
    const before = world.snapshot();
    const held = add();
    const copy = world.snapshot().slice(0);
    world.restore(before);
    const other = add();
    world.restore(copy, [held]);
    expect(world.rigidBodies).toEqual([held]);
    expect(other.world).toBeNull();
  });

  it('does not mind what is held and never was in a world', () => {
    const world = phys2D.createWorld();
    const bodyA = phys2D.createRigidBody({ type: 'static' });
    const bodyB = phys2D.createRigidBody({ position: [0, 1], shapes: [phys2D.createCircleShape({ radius: 0.3 })] });
    world.addRigidBody(bodyB);
    world.addConstraint(phys2D.createPointConstraint({ bodyA, bodyB, anchorB: [0, -1] }));
    world.step(1 / 60);
    const hash = world.hash();
    const copy = new Uint8Array(world.snapshot()).slice();
    world.step(1 / 60);
    world.restore(copy, [bodyA, phys2D.createRigidBody()]);
    expect(world.hash()).toBe(hash);
    expect(world.rigidBodies).toEqual([bodyB]);
  });

  it('finds the objects of a copy in the world or among those that are held', () => {
    const world = pile(6);
    steps(world, 10);
    const body = world.rigidBodies[2]!;
    const [bodyA, bodyB] = [world.rigidBodies[3]!, world.rigidBodies[4]!];
    const constraint: Constraint = phys2D.createPointConstraint({ bodyA, bodyB });
    world.addConstraint(constraint);
    const snapshot = world.snapshot();
    const hash = world.hash();
    const copy = copyOf(snapshot);
    steps(world, 5);
    world.restore(copy);
    expect(world.hash()).toBe(hash);
    world.removeRigidBody(body);
    world.removeConstraint(constraint);
    const gone = world.hash();
    expect(() => world.restore(copy)).toThrow(/World.restore: the snapshot cannot be restored here: a body of it/);
    expect(() => world.restore(copy, [body])).toThrow(/a constraint of it, number \d+, is neither in the world nor/);
    expect(world.hash()).toBe(gone);
    world.restore(copy, [body, constraint]);
    expect(world.hash()).toBe(hash);
    world.removeRigidBody(body);
    const other = phys2D.createWorld();
    other.addRigidBody(body);
    expect(() => world.restore(snapshot)).toThrow('an object of it is in another world now');
    expect(body.world).toBe(other);
  });

  it('restores a copy of the bytes in another program: an equal world goes on alike', () => {
    const [one, two] = [pile(20), pile(20)];
    steps(one, 50);
    two.restore(copyOf(one.snapshot()));
    expect(two.hash()).toBe(one.hash());
    steps(one, 50);
    steps(two, 50);
    expect(two.hash()).toBe(one.hash());
  });

  it('restores bytes in part of another buffer, as those of a file that Node has read', () => {
    const world = pile(20);
    const snapshot = world.snapshot();
    const before = world.hash();
    const pool = new Uint8Array(snapshot.byteLength + 100);
    pool.set(new Uint8Array(snapshot), 52);
    steps(world, 30);
    world.restore(pool.subarray(52, 52 + snapshot.byteLength));
    expect(world.hash()).toBe(before);
    steps(world, 30);
    world.restore(new DataView(pool.buffer, 52, snapshot.byteLength));
    expect(world.hash()).toBe(before);
    expect(() => {
      world.restore(pool);
    }).toThrow(RangeError);
  });

  it('tells what is wrong where the copy of another world does not fit', () => {
    const circle = (radius: number): RigidBody => plainBody({ shapes: [phys2D.createCircleShape({ radius })] });
    const [one, two, three] = [weightless(), weightless(), weightless()];
    one.addRigidBody(circle(1));
    one.addRigidBody(circle(2));
    two.addRigidBody(boxBody(1, 1));
    two.addRigidBody(boxBody(1, 1));
    const [late, early] = [circle(1), circle(2)].reverse();
    three.addRigidBody(late!);
    three.addRigidBody(early!);
    const copy = copyOf(one.snapshot());
    const refused = 'World.restore: the snapshot cannot be restored here: ';
    const hashes = [two, three].map((world) => world.hash());
    expect(() => two.restore(copy)).toThrow(`${refused}a shape of it is of another kind`);
    expect(() => three.restore(copy)).toThrow(`${refused}its shapes were created in another order`);
    expect([two, three].map((world) => world.hash())).toEqual(hashes);
  });

  it('is refused within handlers and callbacks, as are hash and snapshot', () => {
    const world = weightless();
    const body = plainBody();
    world.addRigidBody(body);
    world.addRigidBody(plainBody({ position: [0.5, 0] }));
    const snapshot = world.snapshot();
    const errors: string[] = [];
    const attempt = (): void => {
      for (const act of [() => world.restore(snapshot), () => world.snapshot(), () => world.hash()]) {
        expect(act).toThrow(/^World\.\w+: must not be called from a handler or callback of the same world$/);
        errors.push('refused');
      }
    };
    body.shapes[0]!.addEventListener('preSolve', attempt);
    body.shapes[0]!.addEventListener('begin', attempt);
    world.step(1 / 60);
    expect(errors).toHaveLength(6);
  });

  it('refuses what is no snapshot', () => {
    const world = pile(1);
    for (const wrong of [undefined, null, 'snapshot', [1, 2], {}]) {
      expect(() => world.restore(wrong as never)).toThrow(TypeError);
    }
    expect(() => world.snapshot([] as never)).toThrow(
      'World.snapshot: target must be an ArrayBuffer, got an array of length 0',
    );
    expect(() => world.restore(new ArrayBuffer(0))).toThrow('World.restore: this is no snapshot of a world');
    expect(() => world.restore(new Uint8Array(100))).toThrow('World.restore: this is no snapshot of a world');
    expect(() => world.restore(new ArrayBuffer(4096))).toThrow('World.restore: this is no snapshot of a world');
    const foreign = world.snapshot();
    new Int32Array(foreign)[1] = 9;
    expect(() => world.restore(foreign)).toThrow('World.restore: the snapshot is of version 9, this is version 24');
  });
});

describe('cost', () => {
  it('a snapshot of 1,000 piled boxes is at most 0.5 MB', () => {
    const world = built.createWorld({ allowSleeping: false });
    const add = (width: number, height: number, params: RigidBodyParams): void => {
      const shapes = [built.createPolygonShape({ vertices: built.createBoxVertices(width, height) })];
      world.addRigidBody(built.createRigidBody({ ...params, shapes }));
    };
    add(100, 1, { type: 'static', position: [0, 0.5] });
    for (let i = 0; i < 1000; i += 1) {
      add(1, 1, { position: [1.02 * (i % 40) - 20, -0.5 - 1.01 * Math.floor(i / 40)] });
    }
    steps(world, 60);
    const { byteLength } = world.snapshot();
    console.log(`1,000 piled boxes: ${byteLength} bytes, ${world.dynamicArbiters.length} arbiters`);
    expect(byteLength).toBeLessThanOrEqual(500_000);
  });

  it('a target is used again, and one that is too small replaced', () => {
    const world = pile(10);
    const large = new ArrayBuffer(100_000);
    expect(world.snapshot(large)).toBe(large);
    const small = new ArrayBuffer(64);
    const other = world.snapshot(small);
    expect(other).not.toBe(small);
    expect(world.snapshot(other)).toBe(other);
    steps(world, 10);
    world.restore(large);
    expect(world.timeStamp).toBe(0);
  });

  it('a rollback of 8 steps in each of 2,500 frames leaves nothing behind', () => {
    const child = [join(import.meta.dirname, 'heap.mjs')];
    const { sizes, frames, handles, found, bodies } = JSON.parse(
      execFileSync(process.execPath, child, { encoding: 'utf8' }),
    ) as Record<'frames' | 'handles' | 'found' | 'bodies', number> & { sizes: number[] };
    // The first frames fill pools.
    const [, first, ...more] = sizes;
    const growth = more.at(-1)! - first!;
    console.log(
      `rollback: ${growth} bytes more after ${more.length * frames} frames; ${found} of ${bodies} bodies found`,
    );
    expect(growth).toBeLessThan(0.1 * more.length * frames);
    expect([handles, found]).toEqual([bodies, bodies]);
  }, 120_000);

  it('a hash is the same when it is asked for again, whatever room it takes', () => {
    const world = phys2D.createWorld();
    for (let i = 0; i < 1500; i += 1) {
      const shapes = i % 2 === 0 ? [] : [phys2D.createCircleShape({ radius: 1 })];
      const velocity: [number, number] = i % 3 === 0 ? [0.5, 0] : [0, 0];
      world.addRigidBody(phys2D.createRigidBody({ position: [3 * i, 0], velocity, shapes }));
      expect(world.hash(), `${i + 1} bodies`).toBe(world.hash());
    }
  });

  it.each(['velocityIterations', 'positionIterations', 'substeps'] as const)(
    'the most %s there may be come back',
    (name) => {
      const world = phys2D.createWorld({ [name]: 1e9 });
      const snapshot = world.snapshot();
      world[name] = 8;
      world.restore(snapshot);
      expect(world[name]).toBe(1e9);
    },
  );
});
