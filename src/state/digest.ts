/** Scratch: a number and its bits. */
const scratch = new Float64Array(1);
const words = new Int32Array(scratch.buffer);

/** A digest of 64 bits of what is given to it, 64 bits at a time; mixed as by MurmurHash3 (Appleby 2011). */
export class Digest {
  low = 0;
  high = 0;

  begin(): void {
    this.low = 0x2f0b4a27;
    this.high = 0x51ed270b;
  }

  add(low: number, high: number): void {
    const a = this.low ^ Math.imul(low, 0xcc9e2d51);
    const b = this.high ^ Math.imul(high ^ (a >>> 15), 0x1b873593);
    this.low = (Math.imul((a << 13) | (a >>> 19), 5) + b) | 0;
    this.high = (Math.imul((b << 17) | (b >>> 15), 5) + 0x38b34ae5) | 0;
  }

  addNumber(value: number): void {
    scratch[0] = value;
    this.add(words[0]!, words[1]!);
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
