import type { Broadphase, BroadphaseHandle, Rect } from '../../src/index.js';
import { phys2D } from '../../src/index.js';

export const BROADPHASES: readonly [string, () => Broadphase][] = [
  ['box tree', () => phys2D.createBoxTreeBroadphase()],
  ['sweep and prune', () => phys2D.createSweepAndPruneBroadphase()],
];

export function overlap(a: ArrayLike<number>, b: ArrayLike<number>): boolean {
  return a[0]! <= b[2]! && a[2]! >= b[0]! && a[1]! <= b[3]! && a[3]! >= b[1]!;
}

/** The reported pairs as sorted `a-b` texts of the data; throws on a pair of one handle with itself. */
export function pairsOf(broadphase: Broadphase): string[] {
  const found: string[] = [];
  broadphase.perform((a, b) => {
    if (a === b) {
      throw new Error('a handle is paired with itself');
    }
    found.push([Number(a.data), Number(b.data)].sort((x, y) => x - y).join('-'));
  });
  return found.sort();
}

/** Notes that a broadphase keeps of pairs, beside those that it was given. */
export class Notes {
  private given = new Map<string, number>();
  private count = 0;

  /** All pairs, those whose note is known among them: each note must be the one that was given for its pair in the call before, and is known if `isKnown`. */
  pairsOf(broadphase: Broadphase, isKnown: () => boolean): string[] {
    const pairs = new Map([...this.given].map(([pair, note]) => [note, pair]));
    const now = new Map<string, number>();
    const self = {};
    const add = (pair: string | undefined, note: number): void => {
      if (pair === undefined || now.has(pair)) {
        throw new Error(`${pair} is reported twice, or was not in the call before: ${note}`);
      }
      now.set(pair, note);
    };
    broadphase.perform(
      (a, b) => {
        this.count += 1;
        add([Number(a.data), Number(b.data)].sort((x, y) => x - y).join('-'), this.count);
        return this.count;
      },
      self,
      function (this: unknown, note) {
        const answer = isKnown();
        if (this !== self) {
          throw new Error('is not called with thisObject');
        }
        if (answer) {
          add(pairs.get(note), note);
        }
        return answer;
      },
    );
    this.given = now;
    return [...now.keys()].sort();
  }
}

export function sampleOf(broadphase: Broadphase, bounds: Rect): number[] {
  const found: number[] = [];
  broadphase.sample(bounds, (handle) => found.push(Number(handle.data)));
  return found.sort((a, b) => a - b);
}

/** A broadphase beside the plainest possible one: a list. */
export class Model {
  readonly entries = new Map<number, { handle: BroadphaseHandle; bounds: Rect; isStatic: boolean; group: unknown }>();
  private next = 0;

  constructor(readonly broadphase: Broadphase) {}

  insert(bounds: Rect, isStatic: boolean, group?: unknown): number {
    const id = this.next;
    this.next += 1;
    this.entries.set(id, { handle: this.broadphase.insert(id, bounds, isStatic, group), bounds, isStatic, group });
    return id;
  }

  update(id: number, bounds: Rect, isStatic?: boolean): void {
    const entry = this.entries.get(id)!;
    entry.bounds = bounds;
    entry.isStatic = isStatic ?? entry.isStatic;
    this.broadphase.update(entry.handle, bounds, ...(isStatic === undefined ? [] : [isStatic]));
  }

  remove(id: number): void {
    this.broadphase.remove(this.entries.get(id)!.handle);
    this.entries.delete(id);
  }

  expectedPairs(): string[] {
    const list = [...this.entries];
    const found: string[] = [];
    list.forEach(([i, a], index) => {
      for (const [j, b] of list.slice(index + 1)) {
        const areApart = (a.isStatic && b.isStatic) || (a.group !== undefined && a.group === b.group);
        if (!areApart && overlap(a.bounds, b.bounds)) {
          found.push([i, j].sort((x, y) => x - y).join('-'));
        }
      }
    });
    return found.sort();
  }

  expectedSample(bounds: Rect): number[] {
    return [...this.entries].filter(([, entry]) => overlap(entry.bounds, bounds)).map(([id]) => id);
  }
}
