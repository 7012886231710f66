import { it } from 'vitest';
import { phys2D, type Shape, type Vec2, type World } from '../src/index.js';
const SMOOTH = { staticFriction: 0, dynamicFriction: 0, rollingFriction: 0, elasticity: 0 };
const mat = () => phys2D.createMaterial(SMOOTH);
const box = (w: number, h: number) => phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(w, h), material: mat() });
const disc = (r: number) => phys2D.createCircleShape({ radius: r, material: mat() });
const FREE = { linearDrag: 0, angularDrag: 0 };
function put(world: World, shape: Shape, position: Vec2, rotation = 0) {
  world.addRigidBody(phys2D.createRigidBody({ type: 'static', position, rotation, shapes: [shape] }));
}
const shapes: Record<string, () => Shape> = { box: () => box(0.4, 0.4), disc: () => disc(0.2), slab: () => box(1, 0.1) };
const E = (b: any) => { const [vx, vy] = b.getVelocity(); const w = b.getAngularVelocity(); return 0.5 * (vx*vx + vy*vy + w*w*b.getInertia()/b.getMass()); };
it('x', () => {
  const out: string[] = [];
  for (const [name, shape] of Object.entries(shapes)) {
    // arc: bowl of overlapping boxes, no gravity
    for (const inside of [true, false]) for (const v of [2, 10, 40]) for (const n of [24, 48]) {
      const world = phys2D.createWorld({ gravity: [0, 0], allowSleeping: false });
      const R = 4;
      for (let i = 0; i < n; i += 1) {
        const a = (2 * Math.PI * (i + 0.5)) / n;
        const L = 2 * R * Math.tan(Math.PI / n);
        const r = R + (inside ? 0.5 : -0.5);
        put(world, box(1, inside ? L * 1.3 : L), [r * Math.cos(a), r * Math.sin(a)], a);
      }
      if (!inside) continue;
      const b = phys2D.createRigidBody({ position: [0, R - 0.25], velocity: [v, 0], shapes: [shape()], ...FREE });
      world.addRigidBody(b);
      const e0 = E(b); let max = 0; let last = e0; let bigdrop = 0;
      for (let i = 0; i < 240; i += 1) { world.step(1 / 60); const e = E(b) / e0; max = Math.max(max, e); bigdrop = Math.max(bigdrop, last / e0 - e); last = E(b); }
      out.push(`bowl ${name} v${v} n${n} e=${(E(b)/e0).toFixed(4)} max=${max.toFixed(4)} drop=${bigdrop.toFixed(4)}`);
    }
    for (const gap of [0, -0.3]) for (const v of [[5, 5], [20, 5], [40, 3], [60, 20]] as const) for (const y of [-0.5, -1, -2]) {
      const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
      for (let i = 0; i < 60; i += 1) put(world, box(1 - gap, 1), [i, 0.5]);
      const b = phys2D.createRigidBody({ position: [1, y], velocity: [v[0], v[1]], shapes: [shape()], ...FREE });
      world.addRigidBody(b);
      let minVy = 0;
      for (let i = 0; i < 60; i += 1) { world.step(1 / 60); if (b.getPosition()[0] < 55) minVy = Math.min(minVy, b.getVelocity()[1]); else break; }
      out.push(`floor ${name} gap${gap} v${v} y${y} vx=${b.getVelocity()[0].toFixed(3)} up=${(-minVy).toFixed(4)} w=${b.getAngularVelocity().toFixed(3)}`);
    }
    for (const a of [0.1, 0.3, 0.6]) for (const v of [3, 12]) for (const sgn of [1, -1]) {
      // hollow or ridge of two slopes, overlapping boxes
      const world = phys2D.createWorld({ gravity: [0, 10], allowSleeping: false });
      const s = Math.sin(a * sgn), c = Math.cos(a);
      // left slope going down to origin (sgn=1: hollow), right slope going up
      for (const side of [-1, 1]) {
        const dx = side * c, dy = -s;
        // surface along from origin; normal up
        const nx = side * s * -1 * -1, ny = c;
        put(world, box(12, 1), [dx * 5.7 + (side === 1 ? s : -s) * 0.5, dy * 5.7 + ny * 0.5], side === 1 ? -a * sgn : a * sgn);
        void nx;
      }
      const b = phys2D.createRigidBody({ position: [-3 * c - 0.21 * -s, -3 * s - 0.21 * c], rotation: a * sgn, velocity: [v * c, v * s], shapes: [shape()], ...FREE });
      world.addRigidBody(b);
      let drop = 0; let max = 0;
      const H = () => E(b) - 10 * b.getPosition()[1];
      const h0 = H(); let last = h0;
      for (let i = 0; i < 60; i += 1) { world.step(1 / 60); max = Math.max(max, H() - h0); drop = Math.max(drop, last - H()); last = H(); }
      out.push(`slopes ${name} a${a} v${v} ${sgn} dE=${(H() - h0).toFixed(3)} max=${max.toFixed(3)} drop=${drop.toFixed(3)} x=${b.getPosition().map((q: number) => q.toFixed(3))}`);
    }
  }
  require('node:fs').writeFileSync(process.env.OUT!, out.join('\n') + '\n');
}, 60000);
