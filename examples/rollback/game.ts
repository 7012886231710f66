// A small game for two: each player pushes a disc about, and throws crates. Nothing in it depends on anything but its state and the inputs.
import { phys2D, type RigidBody, type Vec2, type World } from 'phys2d';

/** What a player holds down, as bits. */
export const LEFT = 1;
export const RIGHT = 2;
export const JUMP = 4;
export const THROW = 8;

export const WIDTH = 16;
export const HEIGHT = 9;
const CRATES = 10;
const DT = 1 / 60;

export class Game {
  readonly world: World = phys2D.createWorld({ gravity: [0, 15] });
  readonly players: readonly RigidBody[];
  readonly ball: RigidBody;
  readonly crates: RigidBody[] = [];
  /** State of the game's own, which has to be brought back as well: goals of each player, and steps until each may throw again. */
  readonly numbers = new Float64Array(4);

  constructor() {
    for (const [x, y, width, height] of [
      [WIDTH / 2, HEIGHT + 0.3, WIDTH + 2, 1],
      [WIDTH / 2, -0.5, WIDTH + 2, 1],
      [-0.5, HEIGHT / 2, 1, HEIGHT],
      [WIDTH + 0.5, HEIGHT / 2, 1, HEIGHT],
      [WIDTH / 2, 6.5, 4, 0.2],
    ] as const) {
      const shapes = [phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(width, height) })];
      this.world.addRigidBody(phys2D.createRigidBody({ type: 'static', position: [x, y], shapes }));
    }
    const rubber = phys2D.createMaterial({ elasticity: 0.7 });
    this.players = [3, WIDTH - 3].map((x) => this.addDisc([x, 7], 0.5));
    this.ball = this.addDisc([WIDTH / 2, 4], 0.35);
    this.ball.shapes[0]!.setMaterial(rubber);
    [0.2, WIDTH - 0.2].forEach((x, side) => {
      const goal = phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(0.4, 3), sensor: true });
      this.world.addRigidBody(phys2D.createRigidBody({ type: 'static', position: [x, 7], shapes: [goal] }));
      goal.addEventListener('begin', (_arbiter, other) => {
        if (other.body === this.ball) {
          this.numbers[1 - side]! += 1;
          this.ball.setPosition([WIDTH / 2, 3]);
          this.ball.setVelocity([0, 0]);
        }
      });
    });
  }

  private addDisc(position: Vec2, radius: number): RigidBody {
    const body = phys2D.createRigidBody({ position, shapes: [phys2D.createCircleShape({ radius })] });
    this.world.addRigidBody(body);
    return body;
  }

  /** One step, with what each player holds down. */
  step(inputs: readonly number[]): void {
    this.players.forEach((player, i) => {
      this.control(player, i, inputs[i]!);
    });
    this.world.step(DT);
  }

  private control(player: RigidBody, i: number, held: number): void {
    const [vx, vy] = player.getVelocity();
    const wanted = 6 * ((held & RIGHT ? 1 : 0) - (held & LEFT ? 1 : 0));
    const stands = player.shapes[0]!.arbiters.some((arbiter) => {
      const [, y] = arbiter.getNormal();
      return arbiter.active && (arbiter.bodyA === player ? y : -y) > 0.5;
    });
    player.setVelocity([vx + 0.2 * (wanted - vx), held & JUMP && stands ? -8 : vy]);
    this.numbers[2 + i] = Math.max(0, this.numbers[2 + i]! - 1);
    if (held & THROW && this.numbers[2 + i] === 0) {
      this.numbers[2 + i] = 30;
      this.throwCrate(player, wanted < 0 || (wanted === 0 && i === 1) ? -1 : 1);
    }
  }

  /** Bodies come and go, also in steps that are taken back. */
  private throwCrate(player: RigidBody, side: number): void {
    const [x, y] = player.getPosition();
    const crate = phys2D.createRigidBody({
      position: [x + 0.9 * side, y - 0.4],
      velocity: [9 * side, -4],
      shapes: [phys2D.createPolygonShape({ vertices: phys2D.createBoxVertices(0.5, 0.5) })],
    });
    this.world.addRigidBody(crate);
    this.crates.push(crate);
    if (this.crates.length > CRATES) {
      this.world.removeRigidBody(this.crates.shift()!);
    }
  }
}
