import { Digest, hex } from './digest.js';
import { BYTES, CHECKSUM, HEADER, LENGTH, MAGIC, NUMBERS, seal, sum, VERSION } from './format.js';

/** What a tape is for at the moment. */
const WRITE = 0;
const READ = 1;
const CHECK = 2;
const HASH = 3;

/** Kinds of rows; a field that is the same as in the last row of its kind takes one bit. */
const ROWS = 8;
const FIELDS = 64;

/**
 * The state of a world passes over a tape, field by field: each is replaced by what the tape makes of it. So one list of the fields of a class,
 * `b.x = tape.number(b.x)` and so on, serves to write a snapshot, to read one, to check one before it is read, and for a digest.
 *
 * Layout: a header of eight 32-bit words, all numbers (64 bits), then bytes: for each eight fields of a row which of them differ from those of the
 * last row of that kind, and integers, as differences, seven bits a byte.
 */
export class Tape {
  private mode = WRITE;
  /** Fields are replaced by what is stored. */
  private takes = false;
  private where = '';
  private numbers = new Float64Array(512);
  private bytes = new Uint8Array(2048);
  /** Where the next ones are, and on reading where they end. */
  private atNumber = 0;
  private atByte = 0;
  private endNumber = 0;
  private endByte = 0;
  /** The next field of the row, and the byte that tells about it and its neighbours. */
  private field = 0;
  private mask = 0;
  private readonly lastNumbers = Array.from({ length: ROWS }, () => new Float64Array(FIELDS));
  private readonly lastIntegers = Array.from({ length: ROWS }, () => new Int32Array(FIELDS));
  private row = this.lastNumbers[0]!;
  private integerRow = this.lastIntegers[0]!;
  private place = 0;
  private before: Float64Array | null = null;
  private readonly digest = new Digest();

  /** The stored values are to be taken over. */
  get reads(): boolean {
    return this.mode === READ;
  }

  /** There are stored values: they are read or checked. */
  get holds(): boolean {
    return this.mode === READ || this.mode === CHECK;
  }

  get checks(): boolean {
    return this.mode === CHECK;
  }

  get hashes(): boolean {
    return this.mode === HASH;
  }

  private begin(mode: number): void {
    this.mode = mode;
    this.takes = mode === READ;
    this.atNumber = 0;
    this.atByte = 0;
    this.place = 0;
    this.before = null;
    for (const row of [...this.lastNumbers, ...this.lastIntegers]) {
      row.fill(0);
    }
  }

  write(): void {
    this.begin(WRITE);
  }

  hash(): void {
    this.begin(HASH);
    this.digest.begin();
  }

  /** Ends a digest. @returns 16 hexadecimal digits. */
  hashed(): string {
    const { digest } = this;
    digest.end();
    return this.checksum;
  }

  /** What was written, in `target` if that is large enough, else in a new buffer. */
  written(target: ArrayBuffer | undefined): ArrayBuffer {
    const { atNumber, atByte, digest } = this;
    const length = 4 * HEADER + 8 * atNumber + ((atByte + 7) & ~7);
    const buffer =
      target !== undefined && target.byteLength >= length
        ? target
        : new ArrayBuffer(target === undefined ? length : 8 * Math.ceil((length * 5) / 32));
    const header = new Int32Array(buffer, 0, HEADER);
    header[0] = MAGIC;
    header[1] = VERSION;
    header[LENGTH] = length;
    header[NUMBERS] = atNumber;
    header[BYTES] = atByte;
    header[5] = 0;
    new Float64Array(buffer, 4 * HEADER, atNumber).set(this.numbers.subarray(0, atNumber));
    const bytes = new Uint8Array(buffer, 4 * HEADER + 8 * atNumber, length - 4 * HEADER - 8 * atNumber);
    bytes.set(this.bytes.subarray(0, atByte));
    bytes.fill(0, atByte);
    seal(buffer, digest);
    return buffer;
  }

  /** Of the snapshot that was written or loaded. */
  get checksum(): string {
    return hex(this.digest.high) + hex(this.digest.low);
  }

  /** Takes a snapshot in, to be checked. `where` is the function to name in errors. @throws unless it is whole and of this version. */
  load(where: string, buffer: ArrayBuffer): void {
    this.where = where;
    const { byteLength } = buffer;
    const header = byteLength >= 4 * HEADER ? new Int32Array(buffer, 0, HEADER) : null;
    if (header === null || header[0] !== MAGIC) {
      throw new RangeError(`${where}: this is no snapshot of a world`);
    }
    if (header[1] !== VERSION) {
      throw new RangeError(`${where}: the snapshot is of version ${header[1]}, this is version ${VERSION}`);
    }
    const length = header[LENGTH]!;
    const numbers = header[NUMBERS]!;
    const bytes = header[BYTES]!;
    const needed = 4 * HEADER + 8 * numbers + 8 * Math.ceil(bytes / 8);
    if (numbers < 0 || bytes < 0 || length !== needed || length > byteLength) {
      throw this.damage('its parts do not fit its length');
    }
    sum(buffer, length, this.digest);
    if (this.digest.low !== header[CHECKSUM] || this.digest.high !== header[CHECKSUM + 1]) {
      throw this.damage('its checksum is wrong');
    }
    this.roomFor(numbers, bytes);
    this.numbers.set(new Float64Array(buffer, 4 * HEADER, numbers));
    this.bytes.set(new Uint8Array(buffer, 4 * HEADER + 8 * numbers, bytes));
    this.endNumber = numbers;
    this.endByte = bytes;
    this.begin(CHECK);
  }

  /** Ends a check. */
  finish(): void {
    this.require(this.atNumber === this.endNumber && this.atByte === this.endByte, 'something is left over');
  }

  /** Begins to read what is right. */
  read(): void {
    this.begin(READ);
  }

  /** Within a check: something has to be so. */
  require(holds: boolean, otherwise: string): void {
    if (!holds) {
      throw this.damage(otherwise);
    }
  }

  /** An error that tells why a snapshot, though right, cannot be restored. */
  refusal(why: string): Error {
    return new Error(`${this.where}: the snapshot cannot be restored here: ${why}`);
  }

  private damage(how: string): RangeError {
    return new RangeError(`${this.where}: the snapshot is damaged: ${how}`);
  }

  /** Whether on a check fields are replaced as well: those of objects that are there for that. */
  checksOnto(isScratch: boolean): void {
    this.takes = this.mode === READ || (this.mode === CHECK && isScratch);
  }

  /** Starts a row. */
  begins(kind: number): void {
    this.row = this.lastNumbers[kind]!;
    this.integerRow = this.lastIntegers[kind]!;
    this.field = 0;
  }

  /** A number within bounds. */
  number(value: number, least: number = -Infinity, most: number = Infinity): number {
    const i = this.next();
    const { row } = this;
    if (this.mode === WRITE) {
      if (value !== row[i] || (value === 0 && 1 / value !== 1 / row[i]!)) {
        this.putNumber(i, value);
        row[i] = value;
      }
      return value;
    }
    if (this.mode === HASH) {
      this.digest.addNumber(value);
      return value;
    }
    if (this.isNoted(i)) {
      row[i] = this.takeNumber();
    }
    if (this.mode === CHECK) {
      this.require(row[i]! >= least && row[i]! <= most, 'a number is out of its range');
    }
    return this.takes ? row[i]! : value;
  }

  /** What is stored as the number that was passed last, to be checked. */
  get latest(): number {
    return this.row[this.field - 1]!;
  }

  /** A number that is 0 in many rows, and seldom the same in two. */
  sparse(value: number): number {
    const i = this.next();
    if (this.mode === WRITE) {
      if (value !== 0 || 1 / value < 0) {
        this.putNumber(i, value);
      }
      return value;
    }
    if (this.mode === HASH) {
      this.digest.addNumber(value);
      return value;
    }
    const stored = this.isNoted(i) ? this.takeNumber() : 0;
    return this.takes ? stored : value;
  }

  /** An integer of at most 32 bits, within bounds. */
  integer(value: number, least: number, most: number): number {
    const i = this.next();
    const { integerRow: row } = this;
    if (this.mode === WRITE) {
      if (value !== row[i]) {
        this.note(i);
        this.putInteger(value - row[i]!);
        row[i] = value;
      }
      return value;
    }
    if (this.mode === HASH) {
      this.digest.add(value, i);
      return value;
    }
    if (this.isNoted(i)) {
      row[i] = row[i]! + this.takeInteger();
    }
    if (this.mode === CHECK) {
      this.require(row[i]! >= least && row[i]! <= most, 'an integer is out of its range');
    }
    return this.takes ? row[i]! : value;
  }

  flag(value: boolean): boolean {
    const i = this.next();
    if (this.mode === WRITE) {
      if (value) {
        this.note(i);
      }
      return value;
    }
    if (this.mode === HASH) {
      this.digest.add(value ? 1 : 0, i);
      return value;
    }
    const stored = this.isNoted(i);
    return this.takes ? stored : value;
  }

  /** All numbers of an array, as `sparse`. */
  list(values: Float64Array): void {
    this.span(values, 0, values.length);
  }

  /** The numbers of an array from one index up to another, as `sparse`; straight-line, as most of what there is passes here. */
  span(values: Float64Array, from: number, to: number): void {
    const { mode, takes } = this;
    if (mode === HASH) {
      for (let i = from; i < to; i += 1) {
        this.digest.addNumber(values[i]!);
      }
      return;
    }
    for (let start = from; start < to; start += 8) {
      this.field = 0;
      this.next();
      const { mask, numbers, bytes } = this;
      const end = start + 8 < to ? start + 8 : to;
      let noted = mode === WRITE ? 0 : bytes[mask]!;
      let at = this.atNumber;
      for (let i = start; i < end; i += 1) {
        const bit = 1 << (i - start);
        if (mode === WRITE) {
          const value = values[i]!;
          if (value !== 0 || 1 / value < 0) {
            noted |= bit;
            numbers[at] = value;
            at += 1;
          }
        } else if ((noted & bit) === 0) {
          values[i] = takes ? 0 : values[i]!;
        } else {
          values[i] = takes ? numbers[at]! : values[i]!;
          this.require(mode !== CHECK || !Number.isNaN(numbers[at]), 'a number is none');
          at += 1;
        }
      }
      bytes[mask] = noted;
      this.atNumber = at;
      this.require(mode !== CHECK || at <= this.endNumber, 'it ends too early');
    }
    this.field = 0;
  }

  /**
   * Numbers within ±`most` of which there may have been another count, and which the last such array may have in common with this one. @returns this one,
   * or one with what is stored.
   */
  shared(values: Float64Array, most: number): Float64Array {
    const { before } = this;
    if (!this.holds) {
      const isSame = before !== null && this.mode === WRITE && areEqual(values, before);
      this.count(isSame ? 0 : values.length);
      this.before = values;
      if (!isSame) {
        this.list(values);
      }
      return values;
    }
    const length = this.count(0);
    this.require(length > 0 || before !== null, 'there is no array before the first');
    this.require(length <= 8 * (this.endByte - this.atByte), 'it ends too early');
    let stored = before!;
    if (length > 0) {
      const { takes } = this;
      stored = new Float64Array(length);
      this.takes = true;
      this.list(stored);
      this.takes = takes;
    }
    this.before = stored;
    this.require(
      this.mode !== CHECK || stored.every((value) => Math.abs(value) <= most),
      'a number is out of its range',
    );
    return !this.takes || areEqual(values, stored) ? values : stored.slice();
  }

  /** How many there are of something. @returns what is stored, also on a check. */
  count(value: number, most: number = 0x7fffffff): number {
    if (this.mode === WRITE) {
      this.roomFor(this.atNumber, this.atByte + 8);
      this.putInteger(value);
      return value;
    }
    if (this.mode === HASH) {
      this.digest.add(value, 0);
      return value;
    }
    const stored = this.takeInteger();
    if (this.mode === CHECK) {
      this.require(stored >= 0 && stored <= most, 'a count is out of its range');
    }
    return stored;
  }

  /** Which of `count` things. @returns what is stored, also on a check. */
  index(value: number, count: number): number {
    const before = this.place;
    if (this.mode === WRITE) {
      this.roomFor(this.atNumber, this.atByte + 8);
      this.putInteger(value - before);
      this.place = value;
      return value;
    }
    if (this.mode === HASH) {
      this.digest.add(value, 1);
      return value;
    }
    const stored = before + this.takeInteger();
    this.place = stored;
    if (this.mode === CHECK) {
      this.require(stored >= 0 && stored < count, 'an index is out of its range');
    }
    return stored;
  }

  /** Integers in a list of any length. @returns what is stored, also on a check. */
  integers(values: number[]): number[] {
    const list = this.holds ? [] : values;
    const count = this.count(values.length, this.endByte);
    for (let i = 0; i < count; i += 1) {
      list[i] = this.index(list[i] ?? 0, 0x7fffffff);
    }
    return list;
  }

  private next(): number {
    const i = this.field;
    this.field = i + 1;
    if ((i & 7) === 0 && this.mode !== HASH) {
      this.mask = this.atByte;
      this.atByte += 1;
      if (this.mode === WRITE) {
        this.roomFor(this.atNumber + 8, this.atByte + 64);
        this.bytes[this.mask] = 0;
      } else if (this.mode === CHECK) {
        this.require(this.mask < this.endByte, 'it ends too early');
      }
    }
    return i;
  }

  private note(i: number): void {
    this.bytes[this.mask] = this.bytes[this.mask]! | (1 << (i & 7));
  }

  private isNoted(i: number): boolean {
    return (this.bytes[this.mask]! & (1 << (i & 7))) !== 0;
  }

  private putNumber(i: number, value: number): void {
    this.note(i);
    this.numbers[this.atNumber] = value;
    this.atNumber += 1;
  }

  private takeNumber(): number {
    const stored = this.numbers[this.atNumber]!;
    this.atNumber += 1;
    if (this.mode === CHECK) {
      this.require(this.atNumber <= this.endNumber, 'it ends too early');
      this.require(!Number.isNaN(stored), 'a number is none');
    }
    return stored;
  }

  /** Small ones of either sign take few bytes. */
  private putInteger(value: number): void {
    const { bytes } = this;
    let left = ((value << 1) ^ (value >> 31)) >>> 0;
    let at = this.atByte;
    for (; left > 127; left >>>= 7) {
      bytes[at] = left | 128;
      at += 1;
    }
    bytes[at] = left;
    this.atByte = at + 1;
  }

  private takeInteger(): number {
    const { bytes } = this;
    let value = 0;
    let at = this.atByte;
    let byte = 128;
    for (let shift = 0; byte > 127 && shift < 35; shift += 7) {
      byte = bytes[at]!;
      at += 1;
      value |= (byte & 127) << shift;
    }
    this.atByte = at;
    if (this.mode === CHECK) {
      this.require(at <= this.endByte, 'it ends too early');
    }
    return (value >>> 1) ^ -(value & 1);
  }

  private roomFor(numbers: number, bytes: number): void {
    if (numbers > this.numbers.length) {
      const wider = new Float64Array(2 * numbers);
      wider.set(this.numbers);
      this.numbers = wider;
    }
    if (bytes > this.bytes.length) {
      const wider = new Uint8Array(2 * bytes);
      wider.set(this.bytes);
      this.bytes = wider;
    }
  }
}

/** To the bit. */
function areEqual(a: Float64Array, b: Float64Array): boolean {
  return a.length === b.length && a.every((value, i) => Object.is(value, b[i]));
}
