import { JUMP, LEFT, RIGHT, THROW } from './game.js';
import { Line, randomNumbers } from './network.js';
import { Peer } from './peer.js';

/** Two peers and the lines between them. */
export class Match {
  readonly peers = [new Peer(0), new Peer(1)] as const;
  private readonly lines = [new Line(17), new Line(23)] as const;
  private now = 0;
  /** Frames that both know for good, and the first of them in which they differ, or −1. */
  compared = 0;
  diverged = -1;

  /** A frame of both, with what each player holds down. */
  advance(held: readonly number[]): void {
    this.now += 1;
    this.peers.forEach((peer, i) => {
      for (const message of this.lines[1 - i]!.receive(this.now)) {
        peer.receive(message);
      }
      this.lines[i]!.send(peer.advance(held[i]!), this.now);
    });
    this.compare();
  }

  private compare(): void {
    const [a, b] = this.peers;
    const final = Math.min(a.known, b.known, a.frame, b.frame);
    for (; this.compared < final; this.compared += 1) {
      if (a.hashes[this.compared] !== b.hashes[this.compared] && this.diverged < 0) {
        this.diverged = this.compared;
      }
    }
  }
}

/** Someone who does not know what to do, but does it for a while. */
export function bot(seed: number): () => number {
  const random = randomNumbers(seed);
  let held = 0;
  return () => {
    if (random() < 0.1) {
      held = [LEFT, RIGHT, LEFT | JUMP, RIGHT | JUMP, JUMP, 0][Math.floor(6 * random())]!;
      held |= random() < 0.3 ? THROW : 0;
    }
    return held;
  };
}
