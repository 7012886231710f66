import type { Message } from './peer.js';

/** Numbers in [0, 1) by a multiplicative congruential generator (Park & Miller 1988). */
export function randomNumbers(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state * 48271) % 2147483647;
    return state / 2147483647;
  };
}

/** A line between two peers, one way: messages take 100 ms, a frame more or less, overtake each other, and one in twenty is lost. */
export class Line {
  private readonly random: () => number;
  private readonly underway: { readonly message: Message; readonly due: number }[] = [];

  constructor(
    seed: number,
    private readonly latency = 6,
    private readonly loss = 0.05,
  ) {
    this.random = randomNumbers(seed);
  }

  send(message: Message, now: number): void {
    if (this.random() >= this.loss) {
      this.underway.push({ message, due: now + this.latency + Math.round(2 * this.random() - 1) });
    }
  }

  /** What arrives by now. */
  receive(now: number): Message[] {
    const arrived = this.underway.filter(({ due }) => due <= now);
    for (const one of arrived) {
      this.underway.splice(this.underway.indexOf(one), 1);
    }
    return arrived.map(({ message }) => message);
  }
}
