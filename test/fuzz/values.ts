import { generator } from '../scenes/mixed.js';

/** Random arguments, as source text: mostly ordinary ones, some at the edges of what the engine is made for. */
export class Values {
  private readonly random: () => number;
  /** The share of numbers that are out of the ordinary, and where things are, m: the same for a whole program. */
  private readonly extremes: number;
  private readonly centre: number;

  constructor(seed: number) {
    this.random = generator(seed);
    this.extremes = this.pick([0, 0.02, 0.05, 0.3]);
    this.centre = this.pick([0, 0, 0, 0, 1e3, -1e6]);
  }

  private isExtreme(): boolean {
    return this.chance(this.extremes);
  }

  chance(share: number): boolean {
    return this.random() < share;
  }

  pick<T>(list: readonly T[]): T {
    return list[Math.floor(this.random() * list.length)]!;
  }

  /** An integer from 0 to less than `count`. */
  below(count: number): number {
    return Math.floor(this.random() * count);
  }

  /** Short numbers make reproductions that can be read. */
  span(from: number, to: number): number {
    return Number((from + (to - from) * this.random()).toPrecision(3));
  }

  /** Evenly over orders of magnitude. */
  private scale(from: number, to: number): number {
    return Number(Math.exp(Math.log(from) + Math.log(to / from) * this.random()).toPrecision(2));
  }

  private signed(value: number): number {
    return this.chance(0.5) ? value : -value;
  }

  /** m. */
  place(): number {
    return this.isExtreme() ? this.pick([0, 0, 1e3, -1e6]) : this.centre + this.span(-2.5, 2.5);
  }

  /** m. */
  size(): number {
    return this.isExtreme() ? this.scale(1e-3, 1e6) : this.span(0.2, 1.5);
  }

  /** m/s, rad/s. */
  speed(): number {
    return this.isExtreme() ? this.signed(this.scale(1e-3, 1e5)) : this.chance(0.2) ? 0 : this.span(-6, 6);
  }

  /** N, N·s, N·m. */
  force(): number {
    return this.isExtreme() ? this.signed(this.scale(1e-3, 1e6)) : this.chance(0.2) ? 0 : this.span(-50, 50);
  }

  /** kg, kg·m². */
  mass(): string {
    return this.isExtreme() ? `${this.scale(1e-6, 1e9)}` : this.chance(0.1) ? 'Infinity' : `${this.span(0.1, 20)}`;
  }

  angle(): number {
    return this.isExtreme()
      ? this.pick([1e3, -1e6])
      : this.chance(0.3)
        ? this.pick([0, Math.PI / 2])
        : this.span(-7, 7);
  }

  /** s. */
  time(): string {
    return this.isExtreme()
      ? this.pick(['1', '1e-5', `${this.scale(1e-5, 1)}`])
      : this.pick(['1 / 60', '1 / 60', '1 / 60', '1 / 30']);
  }

  /** >= 0. */
  share(): number {
    return this.isExtreme() ? this.pick([2, 10, 100]) : this.chance(0.2) ? 0 : this.span(0, 1);
  }

  limit(): string {
    return this.chance(0.4) ? 'Infinity' : this.chance(0.1) ? '0' : `${this.scale(1e-3, 1e4)}`;
  }

  /** Two numbers of a kind. */
  pair(kind: 'place' | 'speed' | 'force' | 'size' | 'share'): string {
    return `[${this[kind]()}, ${this[kind]()}]`;
  }

  flag(share = 0.5): string {
    return `${this.chance(share)}`;
  }

  elasticity(): string {
    return this.isExtreme()
      ? this.pick(['-1', '2', 'Infinity', '-Infinity'])
      : this.pick(['0', '0', '0.3', '0.8', '1']);
  }

  group(): string {
    return this.pick(['1', '1', '1', '2', '3', '3', '0']);
  }

  mask(): string {
    return this.pick(['0xffffffff', '0xffffffff', '0xffffffff', '1', '2', '0']);
  }

  ratio(): number {
    return this.isExtreme() ? this.pick([10, 1e-3, 1e3]) : this.pick([1, -1, 2, 0.5, -0.3]);
  }

  vertices(): string {
    const kind = this.below(3);
    if (kind === 0) {
      return `phys2D.createBoxVertices(${this.size()}, ${this.size()})`;
    }
    if (kind === 1) {
      const [x, y] = [this.span(-1, 1), this.span(-1, 1)];
      return `phys2D.createRectangleVertices(${x}, ${y}, ${x + this.size()}, ${y + this.size()})`;
    }
    return `phys2D.createRegularPolygonVertices(${this.size()}, ${this.size()}, ${3 + this.below(7)})`;
  }

  /** Bounds in order, of which one may be missing. */
  bounds(least: number): string {
    const lower = this.chance(0.3) ? 0 : Math.max(least, this.span(-3, 3));
    const upper = this.chance(0.3) ? lower : lower + this.span(0, 3);
    const lowerBound = least < 0 && this.chance(0.2) ? '-Infinity' : lower;
    return `lowerBound: ${lowerBound}, upperBound: ${this.chance(0.2) ? 'Infinity' : upper}`;
  }
}
