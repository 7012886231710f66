import { Digest } from './digest.js';

/** Int32 words before the numbers. */
export const HEADER = 8;
export const MAGIC = 0x32643270;
export const VERSION = 1;
export const LENGTH = 2;
export const NUMBERS = 3;
export const BYTES = 4;
export const CHECKSUM = 6;

/** Writes the checksum of a snapshot into it. */
export function seal(buffer: ArrayBuffer, digest: Digest = new Digest()): void {
  const header = new Int32Array(buffer, 0, HEADER);
  sum(buffer, header[LENGTH]!, digest);
  header[CHECKSUM] = digest.low;
  header[CHECKSUM + 1] = digest.high;
}

/** The checksum of a snapshot: of all but itself. */
export function sum(buffer: ArrayBuffer, length: number, digest: Digest): void {
  const all = new Int32Array(buffer, 0, length >> 2);
  digest.begin();
  for (let i = 0; i < all.length; i += 2) {
    if (i !== CHECKSUM) {
      digest.add(all[i]!, all[i + 1]!);
    }
  }
  digest.end();
}
