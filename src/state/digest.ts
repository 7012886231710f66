/** A digest of 64 bits of what is given to it, 64 bits at a time; mixed as by MurmurHash3 (Appleby 2011). */
export class Digest {
  low = 0;
  high = 0;

  begin(): void {
    this.low = 0x2f0b4a27;
    this.high = 0x51ed270b;
  }

  /** Words from one index up to another, two at a time. */
  add(words: Int32Array, from: number, to: number): void {
    let { low, high } = this;
    for (let i = from; i < to; i += 2) {
      const a = low ^ Math.imul(words[i]!, 0xcc9e2d51);
      const b = high ^ Math.imul((i + 1 < to ? words[i + 1]! : 0) ^ (a >>> 15), 0x1b873593);
      low = (Math.imul((a << 13) | (a >>> 19), 5) + b) | 0;
      high = (Math.imul((b << 17) | (b >>> 15), 5) + 0x38b34ae5) | 0;
    }
    this.low = low;
    this.high = high;
  }

  end(): void {
    this.low = finish(this.low ^ this.high);
    this.high = finish(this.high ^ this.low);
  }
}

function finish(word: number): number {
  let h = Math.imul(word ^ (word >>> 16), 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return h ^ (h >>> 16);
}

/** Eight hexadecimal digits. */
export function hex(word: number): string {
  return (word >>> 0).toString(16).padStart(8, '0');
}
