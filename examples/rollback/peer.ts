// Rollback: a peer never waits for the other's input. It guesses, goes on, and when it was wrong goes back and does it again.
import type { RigidBody } from 'phys2d';
import { Game } from './game.js';

/** How far a peer may be ahead of what it knows. */
export const WINDOW = 8;

/** The inputs of a player from a frame on: all that the other may not have yet, as messages get lost. */
export interface Message {
  readonly from: number;
  readonly inputs: readonly number[];
  /** The sender has the receiver's inputs before this frame. */
  readonly known: number;
}

/** What a game is made of at the start of a frame. */
interface Saved {
  world: ArrayBuffer;
  numbers: Float64Array;
  crates: RigidBody[];
}

export class Peer {
  readonly game = new Game();
  /** The frame that comes next. */
  frame = 0;
  rollbacks = 0;
  waits = 0;
  /** Of the state at the start of each frame; final before `known`. */
  readonly hashes: string[] = [];
  /** The other's inputs are known before this frame. */
  known = 0;
  private readonly inputs: [number[], number[]] = [[], []];
  /** The other has this peer's inputs before this frame. */
  private arrived = 0;
  private readonly ring: Saved[] = Array.from({ length: WINDOW + 1 }, () => ({
    world: new ArrayBuffer(32_768),
    numbers: new Float64Array(4),
    crates: [],
  }));

  constructor(readonly player: 0 | 1) {}

  private get own(): number[] {
    return this.inputs[this.player];
  }

  private get others(): number[] {
    return this.inputs[1 - this.player]!;
  }

  /** Takes in a message, and goes back if a guess was wrong. */
  receive({ from, inputs, known }: Message): void {
    this.arrived = Math.max(this.arrived, known);
    let wrong = -1;
    inputs.forEach((input, i) => {
      const frame = from + i;
      if (frame === this.known) {
        this.known += 1;
        if (frame < this.frame && this.others[frame] !== input && wrong < 0) {
          wrong = frame;
        }
        this.others[frame] = input;
      }
    });
    if (wrong >= 0) {
      this.goBack(wrong);
    }
  }

  private goBack(frame: number): void {
    this.rollbacks += 1;
    const { frame: present } = this;
    this.load(frame);
    for (this.frame = frame; this.frame < present; ) {
      this.simulate();
    }
  }

  /** One frame with what this player holds down, if the other is not too far behind. @returns what to send, in any case. */
  advance(held: number): Message {
    if (this.frame - this.known < WINDOW) {
      this.own[this.frame] = held;
      this.simulate();
    } else {
      this.waits += 1;
    }
    return { from: this.arrived, inputs: this.own.slice(this.arrived), known: this.known };
  }

  private simulate(): void {
    const { frame, others } = this;
    this.save(frame);
    this.hashes[frame] = this.game.world.hash();
    if (frame >= this.known) {
      others[frame] = others[this.known - 1] ?? 0;
    }
    this.game.step([this.inputs[0][frame]!, this.inputs[1][frame]!]);
    this.frame += 1;
  }

  private save(frame: number): void {
    const saved = this.ring[frame % this.ring.length]!;
    saved.world = this.game.world.snapshot(saved.world);
    saved.numbers.set(this.game.numbers);
    saved.crates = [...this.game.crates];
  }

  private load(frame: number): void {
    const saved = this.ring[frame % this.ring.length]!;
    this.game.world.restore(saved.world);
    this.game.numbers.set(saved.numbers);
    this.game.crates.splice(0, Infinity, ...saved.crates);
  }
}
