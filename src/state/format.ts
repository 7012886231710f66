import { Digest } from './digest.js';

// The format of a snapshot: a header, then numbers of 64 bits, then words of 32.

/** How many words the header has. */
const HEADER = 8;
const MAGIC = 0x32643270;
export const VERSION = 24;
const LENGTH = 2;
const NUMBERS = 3;
const WORDS = 4;
const CHECKSUM = 6;

/** The size of a snapshot of so many numbers and words, bytes: a multiple of 16, as a digest takes four words at a time. */
function lengthOf(numbers: number, words: number): number {
  return 4 * HEADER + 16 * Math.ceil((2 * numbers + words) / 4);
}

/** Makes a snapshot, in `target` if that is large enough, else in a new buffer. */
export function packed(
  numbers: Float64Array,
  words: Int32Array,
  target: ArrayBuffer | undefined,
  digest: Digest,
): ArrayBuffer {
  const length = lengthOf(numbers.length, words.length);
  const buffer =
    target !== undefined && target.byteLength >= length
      ? target
      : new ArrayBuffer(target === undefined ? length : 8 * Math.ceil((length * 5) / 32));
  const all = new Int32Array(buffer, 0, length >> 2);
  all[0] = MAGIC;
  all[1] = VERSION;
  all[LENGTH] = length;
  all[NUMBERS] = numbers.length;
  all[WORDS] = words.length;
  all[5] = 0;
  new Float64Array(buffer, 4 * HEADER, numbers.length).set(numbers);
  all.set(words, HEADER + 2 * numbers.length);
  all.fill(0, HEADER + 2 * numbers.length + words.length);
  seal(buffer, digest);
  return buffer;
}

/** The two tracks of a snapshot. `where` is the function to name in errors. @throws unless it is complete and of this version. */
export function opened(
  where: string,
  buffer: ArrayBuffer,
  digest: Digest,
): { numbers: Float64Array; words: Int32Array } {
  const header = buffer.byteLength >= 4 * HEADER ? new Int32Array(buffer, 0, HEADER) : null;
  if (header === null || header[0] !== MAGIC) {
    throw new RangeError(`${where}: this is no snapshot of a world`);
  }
  if (header[1] !== VERSION) {
    throw new RangeError(`${where}: the snapshot is of version ${header[1]}, this is version ${VERSION}`);
  }
  const length = header[LENGTH]!;
  const numbers = header[NUMBERS]!;
  const words = header[WORDS]!;
  if (numbers < 0 || words < 0 || length !== lengthOf(numbers, words) || length > buffer.byteLength) {
    throw new RangeError(`${where}: the snapshot is damaged: its parts do not fit its length`);
  }
  sum(buffer, length, digest);
  if (digest.low !== header[CHECKSUM] || digest.high !== header[CHECKSUM + 1]) {
    throw new RangeError(`${where}: the snapshot is damaged: its checksum is wrong`);
  }
  return {
    numbers: new Float64Array(buffer, 4 * HEADER, numbers),
    words: new Int32Array(buffer, 4 * HEADER + 8 * numbers, words),
  };
}

/** Writes the checksum of a snapshot into it. */
export function seal(buffer: ArrayBuffer, digest: Digest = new Digest()): void {
  const header = new Int32Array(buffer, 0, HEADER);
  sum(buffer, header[LENGTH]!, digest);
  header[CHECKSUM] = digest.low;
  header[CHECKSUM + 1] = digest.high;
}

/** Computes the checksum of a snapshot: of everything but itself and the first two words, which can have only one value. */
function sum(buffer: ArrayBuffer, length: number, digest: Digest): void {
  const all = new Int32Array(buffer, 0, length >> 2);
  digest.begin();
  digest.add(all, LENGTH, CHECKSUM);
  digest.add(all, HEADER, all.length);
  digest.end();
}
