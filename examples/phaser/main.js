// Phaser draws and takes the input, phys2d moves: none of Phaser's own physics is switched on. Drag a crate; it hangs on a spring.
import Phaser from 'phaser';
import { phys2D } from 'phys2d';
import { FixedStepRunner } from 'phys2d/runner';

/** px per m. */
const SCALE = 60;

class Crates extends Phaser.Scene {
  create() {
    this.world = phys2D.createWorld({ gravity: [0, 10] });
    this.runner = FixedStepRunner.create({ world: this.world });
    /** Body → its picture. */
    this.pictures = new Map();
    this.addBox('static', 7.5, 9.5, 15, 1, 0x4a5568);
    for (let i = 0; i < 12; i += 1) {
      this.addBox('dynamic', 4 + 2 * (i % 4) + 0.1 * i, 8 - 1.5 * Math.floor(i / 4), 0.9, 0.9, 0xc98f4e);
    }
    this.input.on('pointerdown', (pointer) => this.grab(pointer));
    this.input.on('pointermove', (pointer) => this.spring?.setAnchorA([pointer.x / SCALE, pointer.y / SCALE]));
    this.input.on('pointerup', () => this.release());
  }

  addBox(type, x, y, width, height, color) {
    const shape = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, height) });
    const body = phys2D.createRigidBody({ type, position: [x, y], shapes: [shape] });
    this.world.addRigidBody(body);
    const picture = this.add.rectangle(x * SCALE, y * SCALE, width * SCALE, height * SCALE, color);
    this.pictures.set(body, picture);
  }

  grab(pointer) {
    const point = [pointer.x / SCALE, pointer.y / SCALE];
    const found = [];
    this.world.bodyPointQuery(point, found);
    const body = found.find((each) => each.isDynamic());
    if (body !== undefined) {
      // A static body is an anchor even if it is in no world.
      this.spring = phys2D.createPointConstraint({
        bodyA: phys2D.createRigidBody({ type: 'static' }),
        bodyB: body,
        anchorA: point,
        anchorB: body.transformWorldPointToLocal(point),
        stiff: false,
        frequency: 5,
        damping: 0.8,
      });
      this.world.addConstraint(this.spring);
    }
  }

  release() {
    if (this.spring) {
      this.world.removeConstraint(this.spring);
      this.spring = null;
    }
  }

  update(_time, delta) {
    this.runner.advance(delta / 1000);
    for (const [body, picture] of this.pictures) {
      const [x, y] = this.runner.getPosition(body);
      picture.setPosition(x * SCALE, y * SCALE).setRotation(this.runner.getRotation(body));
    }
  }
}

// For the console, and the test.
globalThis.game = new Phaser.Game({
  type: Phaser.AUTO,
  width: 900,
  height: 600,
  backgroundColor: '#14181f',
  banner: false,
  scene: Crates,
});
