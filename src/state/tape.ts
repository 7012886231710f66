import { widened } from '../math/doubles.js';
import { Digest, hex } from './digest.js';
import { opened, packed } from './format.js';
import { CHECK, HASH, READ, WRITE } from './layout.js';

/** There is always room for so many more numbers, and as many words. */
const ROOM = 64;

/**
 * The fields of one object, 32 of them at most; all objects of a kind pass through the same row. A field with the same value as in the last
 * object takes one bit.
 */
export class Row {
  readonly numbers: Float64Array;
  readonly integers: Int32Array;
  /** @internal */
  readonly bits: Int32Array;
  /** @internal */
  readonly bitsBefore: Int32Array;
  /** @internal */
  readonly integersBefore: Int32Array;

  constructor(integers: number, numbers: number) {
    this.numbers = new Float64Array(numbers);
    this.bits = new Int32Array(this.numbers.buffer);
    this.bitsBefore = new Int32Array(2 * numbers);
    this.integers = new Int32Array(integers);
    this.integersBefore = new Int32Array(integers);
  }

  /** @internal */
  clear(): void {
    for (const list of [this.bits, this.bitsBefore, this.integers, this.integersBefore]) {
      list.fill(0);
    }
  }
}

/**
 * The state of a world passes over a tape, field by field: each field is replaced by what the tape returns for it. So one list of the
 * fields of a class, `b.x = tape.number(b.x)` and so on, serves to write a snapshot, to read one, to check one before it is read, and for a
 * digest.
 *
 * A tape has two tracks: numbers of 64 bits, and words of 32. Objects of which there are thousands pass in rows: all their fields are put
 * into a row, it passes, and all are taken out of it again.
 */
export class Tape {
  private mode = WRITE;
  /** Whether fields are stored, or go into a digest. */
  writes = true;
  /** Whether fields are replaced by the stored values. */
  takes = false;
  private where = '';
  /** The tracks for writing. */
  private ownNumbers: Float64Array = new Float64Array(1024);
  private halves = new Int32Array(this.ownNumbers.buffer);
  private ownWords: Int32Array = new Int32Array(1024);
  /** The tracks: those for writing, or those of a snapshot that was loaded. */
  private numbers = this.ownNumbers;
  private words = this.ownWords;
  /** Where the next number and word are; when reading, where the tracks end. */
  private atNumber = 0;
  private atWord = 0;
  private endNumber = 0;
  private endWord = 0;
  /** The index of the current word of flags, and its next bit. */
  private flags = 0;
  private bit = 0;
  private place = 0;
  private before: Float64Array | null = null;
  private readonly digest = new Digest();

  constructor(private readonly rows: readonly Row[]) {}

  /** Whether the stored values are taken over. */
  get reads(): boolean {
    return this.mode === READ;
  }

  /** Whether there are stored values, to be read or checked. */
  get holds(): boolean {
    return !this.writes;
  }

  get checks(): boolean {
    return this.mode === CHECK;
  }

  get hashes(): boolean {
    return this.mode === HASH;
  }

  private begin(mode: number): void {
    this.mode = mode;
    this.writes = mode === WRITE || mode === HASH;
    this.takes = mode === READ;
    this.atNumber = 0;
    this.atWord = 0;
    this.place = 0;
    this.before = null;
    for (const row of this.rows) {
      row.clear();
    }
  }

  write(): void {
    this.unload();
    this.begin(WRITE);
  }

  hash(): void {
    this.unload();
    this.begin(HASH);
  }

  /** Lets go of the snapshot that was loaded. */
  unload(): void {
    this.numbers = this.ownNumbers;
    this.words = this.ownWords;
  }

  /** Ends a digest. @returns 16 hexadecimal digits. */
  hashed(): string {
    this.word(this.atNumber);
    // Only now, as the call above may have replaced the tracks by longer ones.
    const { digest, halves, words, atNumber, atWord } = this;
    halves.fill(0, 2 * atNumber, 2 * atNumber + 4);
    words.fill(0, atWord, atWord + 4);
    digest.begin();
    digest.add(halves, 0, 2 * atNumber);
    digest.add(words, 0, atWord);
    digest.end();
    return this.checksum;
  }

  /** The snapshot that was written, in `target` if that is large enough, else in a new buffer. */
  written(target: ArrayBuffer | undefined): ArrayBuffer {
    const { numbers, words, atNumber, atWord, digest } = this;
    return packed(numbers.subarray(0, atNumber), words.subarray(0, atWord), target, digest);
  }

  /** The checksum of the snapshot that was written or loaded. */
  get checksum(): string {
    return hex(this.digest.high) + hex(this.digest.low);
  }

  /** Loads a snapshot, to be checked. `where` is the function to name in errors. @throws unless it is complete and of this version. */
  load(where: string, buffer: ArrayBuffer): void {
    this.where = where;
    const { numbers, words } = opened(where, buffer, this.digest);
    this.begin(CHECK);
    this.numbers = numbers;
    this.words = words;
    this.endNumber = numbers.length;
    this.endWord = words.length;
  }

  /** Ends a check: all of the tracks has to be used. */
  finish(): void {
    this.require(this.atNumber === this.endNumber && this.atWord === this.endWord);
  }

  /** How many words have passed. */
  get passed(): number {
    return this.atWord;
  }

  /** Begins to read a checked snapshot, after its first `from` words. */
  read(from: number): void {
    this.begin(READ);
    this.atWord = from;
  }

  /** When checking: @throws unless `holds`. The checksum is right by then, so the snapshot was forged. */
  require(holds: boolean): void {
    if (!holds && this.mode === CHECK) {
      throw this.contradiction();
    }
  }

  private contradiction(): Error {
    return new RangeError(`${this.where}: the snapshot is damaged: it contradicts itself`);
  }

  /** An error that tells why a snapshot that is not damaged cannot be restored. */
  refusal(why: string): Error {
    return new Error(`${this.where}: the snapshot cannot be restored here: ${why}`);
  }

  /** Sets whether checking replaces fields as well, as it does for scratch objects. */
  checksOnto(isScratch: boolean): void {
    this.takes = this.mode === READ || (this.mode === CHECK && isScratch);
  }

  /** Passes a row. */
  pass(row: Row): void {
    if (this.writes) {
      this.put(row);
    } else {
      this.take(row);
    }
  }

  private put({ bits, bitsBefore, integers, integersBefore }: Row): void {
    this.roomForNumbers(this.atNumber);
    this.roomForWords(this.atWord);
    const { words, halves } = this;
    let mask = 0;
    let bit = 1;
    let at = this.atWord + 1;
    for (let i = 0; i < integers.length; i += 1) {
      const word = integers[i]!;
      if (word !== integersBefore[i]) {
        integersBefore[i] = word;
        words[at] = word;
        at += 1;
        mask |= bit;
      }
      bit <<= 1;
    }
    const first = this.atWord;
    this.atWord = at;
    at = 2 * this.atNumber;
    for (let i = 0; i < bits.length; i += 2) {
      const low = bits[i]!;
      const high = bits[i + 1]!;
      if (((low ^ bitsBefore[i]!) | (high ^ bitsBefore[i + 1]!)) !== 0) {
        bitsBefore[i] = low;
        bitsBefore[i + 1] = high;
        halves[at] = low;
        halves[at + 1] = high;
        at += 2;
        mask |= bit;
      }
      bit <<= 1;
    }
    words[first] = mask;
    this.atNumber = at >> 1;
  }

  private take({ numbers, integers }: Row): void {
    const { words, numbers: track } = this;
    let mask = words[this.atWord]!;
    let at = this.atWord + 1;
    for (let i = 0; i < integers.length; i += 1) {
      if ((mask & 1) !== 0) {
        integers[i] = words[at]!;
        at += 1;
      }
      mask >>>= 1;
    }
    this.atWord = at;
    at = this.atNumber;
    for (let i = 0; mask !== 0 && i < numbers.length; i += 1) {
      if ((mask & 1) !== 0) {
        numbers[i] = track[at]!;
        at += 1;
        this.require(this.mode !== CHECK || !Number.isNaN(numbers[i]));
      }
      mask >>>= 1;
    }
    this.atNumber = at;
  }

  /** Passes the numbers of a record from one index up to another; none may be NaN. */
  block(values: Float64Array, from: number, to: number): void {
    const first = this.atNumber;
    const end = first + to - from;
    this.atNumber = end;
    if (this.writes) {
      this.roomForNumbers(end);
      copy(values, from, this.numbers, first, end);
      return;
    }
    if (this.mode === CHECK) {
      this.checkNumbers(first, end);
    }
    if (this.takes) {
      copy(this.numbers, first, values, from, to);
    }
  }

  private checkNumbers(first: number, end: number): void {
    for (let i = first; i < end; i += 1) {
      this.require(!Number.isNaN(this.numbers[i]));
    }
  }

  /** Starts a group of at most 32 flags. */
  begins(): void {
    this.flags = this.atWord;
    this.bit = 0;
    this.word(0);
  }

  flag(value: boolean): boolean {
    const { flags, words, bit } = this;
    this.bit = bit + 1;
    if (this.writes) {
      words[flags]! |= (value ? 1 : 0) << bit;
      return value;
    }
    return this.takes ? ((words[flags]! >>> bit) & 1) !== 0 : value;
  }

  /** Passes a number, not NaN. */
  number(value: number): number {
    const at = this.atNumber;
    this.atNumber = at + 1;
    if (this.writes) {
      this.roomForNumbers(at);
      this.numbers[at] = value;
      return value;
    }
    const stored = this.numbers[at]!;
    this.require(!Number.isNaN(stored));
    return this.takes ? stored : value;
  }

  /** The stored value of the number that passed last, or `before` numbers earlier, to be checked. */
  latest(before = 0): number {
    return this.numbers[this.atNumber - 1 - before]!;
  }

  /** Passes an integer of at most 32 bits, within bounds. */
  integer(value: number, least: number, most: number): number {
    const stored = this.word(value);
    this.require(stored >= least && stored <= most);
    return this.takes ? stored : value;
  }

  /** Passes all numbers of an array; zeros take one bit each. */
  list(values: Float64Array): void {
    for (let first = 0; first < values.length; first += 32) {
      const last = Math.min(first + 32, values.length);
      let bits = 0;
      for (let i = first; i < last && this.writes; i += 1) {
        bits |= values[i] === 0 && 1 / values[i]! > 0 ? 0 : 1 << i;
      }
      bits = this.word(bits);
      for (let i = first; i < last; i += 1) {
        values[i] = (bits & (1 << i)) !== 0 ? this.number(values[i]!) : this.takes ? 0 : values[i]!;
      }
    }
  }

  /**
   * Passes numbers within ±`most`. There may be another count of them in the snapshot; and the array takes no room if it is equal to the
   * last one that passed here. @returns `values`, or a new array with what is stored if that differs, also when checking.
   */
  shared(values: Float64Array, most: number): Float64Array {
    const { before } = this;
    if (this.writes) {
      const isSame = before !== null && areEqual(values, before);
      this.count(isSame ? 0 : values.length);
      this.before = values;
      for (let i = 0; i < values.length && !isSame; i += 1) {
        this.number(values[i]!);
      }
      return values;
    }
    const length = this.count(0);
    this.require(length > 0 || before !== null);
    let stored = before!;
    if (length > 0) {
      stored = this.numbers.slice(this.atNumber, this.atNumber + length);
      this.atNumber += length;
      this.require(stored.length === length && stored.every((value) => Math.abs(value) <= most));
    }
    const isSame = areEqual(values, stored);
    this.before = isSame ? values : stored;
    return isSame ? values : stored.slice();
  }

  /** Passes how many there are of something. @returns what is stored, also when checking. */
  count(value: number, most: number = this.endWord + this.endNumber): number {
    const stored = this.word(value);
    this.require(stored >= 0 && stored <= most);
    return stored;
  }

  /** Passes the size of something that a restore cannot change. @throws if it is not the same. */
  size(value: number, otherwise: string): void {
    if (this.word(value) !== value) {
      throw this.refusal(otherwise);
    }
  }

  /**
   * Passes an index below `count`. It is stored as the difference to the last one, so that one wrong word spoils all that follow. @returns
   * what is stored, also when checking.
   */
  index(value: number, count: number): number {
    const stored = (this.place + this.word(value - this.place)) | 0;
    this.place = stored;
    this.require(stored >= 0 && stored < count);
    return stored;
  }

  /** Passes a word of 32 bits. @returns what is stored, also when checking. */
  word(value: number): number {
    const at = this.atWord;
    this.atWord = at + 1;
    if (this.writes) {
      this.roomForWords(at);
      this.words[at] = value;
      return value;
    }
    return this.words[at]!;
  }

  /** Passes a list of words that is stored after its length. @returns a view into the snapshot itself. */
  integers(): Int32Array {
    const length = this.count(0);
    const first = this.atWord;
    this.atWord += length;
    return this.words.subarray(first, this.atWord);
  }

  /**
   * Makes sure that there is room up to an index, and for a row after it. Short, like all functions that are called for each field, so that
   * engines inline it.
   */
  private roomForNumbers(end: number): void {
    if (end + ROOM > this.numbers.length) {
      this.widenNumbers();
    }
  }

  private roomForWords(end: number): void {
    if (end + ROOM > this.words.length) {
      this.widenWords();
    }
  }

  private widenNumbers(): void {
    const { numbers } = this;
    this.ownNumbers = widened(numbers, new Float64Array(2 * numbers.length + ROOM));
    this.halves = new Int32Array(this.ownNumbers.buffer);
    this.numbers = this.ownNumbers;
  }

  private widenWords(): void {
    const { words } = this;
    this.ownWords = widened(words, new Int32Array(2 * words.length + ROOM));
    this.words = this.ownWords;
  }
}

function copy(values: Float64Array, from: number, into: Float64Array, start: number, end: number): void {
  for (let i = start, k = from; i < end; i += 1, k += 1) {
    into[i] = values[k]!;
  }
}

/** Whether two arrays are equal to the bit. */
function areEqual(a: Float64Array, b: Float64Array): boolean {
  if (a === b) {
    return true;
  }
  let isSame = a.length === b.length;
  for (let i = 0; i < a.length && isSame; i += 1) {
    isSame = areSame(a[i]!, b[i]!);
  }
  return isSame;
}

/**
 * Whether two numbers, neither NaN, are the same, and have the same sign if they are 0. Refused: `Object.is`, which is a call for each
 * number.
 */
export function areSame(a: number, b: number): boolean {
  return a === b && (a !== 0 || 1 / a === 1 / b);
}
