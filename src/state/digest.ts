/** A digest of 64 bits, of words of 32 bits; mixed as by MurmurHash3 (Appleby 2011). */
export class Digest {
  private a = 0;
  private b = 0;
  private c = 0;
  private d = 0;
  low = 0;
  high = 0;

  begin(): void {
    this.a = 0x2f0b4a27;
    this.b = 0x51ed270b;
    this.c = 0x3c6ef372;
    this.d = 0x1f83d9ab;
  }

  /**
   * Adds words from one index up to another, four at a time, in lanes that do not wait for each other. Each step can be undone, so a single
   * wrong word is always noticed.
   */
  add(words: Int32Array, from: number, to: number): void {
    let { a, b, c, d } = this;
    for (let i = from; i < to; i += 4) {
      a = Math.imul(a ^ words[i]!, 0xcc9e2d51);
      b = Math.imul(b ^ words[i + 1]!, 0xcc9e2d51);
      c = Math.imul(c ^ words[i + 2]!, 0xcc9e2d51);
      d = Math.imul(d ^ words[i + 3]!, 0xcc9e2d51);
      a = (a << 15) | (a >>> 17);
      b = (b << 15) | (b >>> 17);
      c = (c << 15) | (c >>> 17);
      d = (d << 15) | (d >>> 17);
    }
    this.a = a;
    this.b = b;
    this.c = c;
    this.d = d;
  }

  end(): void {
    const { a, b, c, d } = this;
    this.low = finish(a ^ finish(b ^ finish(c ^ finish(d))));
    this.high = finish(d ^ finish(c ^ finish(b ^ finish(a))));
  }
}

function finish(word: number): number {
  let h = Math.imul(word ^ (word >>> 16), 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return h ^ (h >>> 16);
}

/** A word as eight hexadecimal digits. */
export function hex(word: number): string {
  return (word >>> 0).toString(16).padStart(8, '0');
}
