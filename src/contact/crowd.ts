import { DYNAMIC } from '../body-kind.js';
import { CROWD } from '../config.js';
import { List } from '../math/list.js';
import { sortFirst } from '../math/sort.js';
import { isOlder, type Shape } from '../shape/shape.js';
import type { Pairs } from './pairs.js';

/**
 * Shapes that lie in the middle of each other, of which there may be thousands at one point: all pairs of them would be millions, and none of
 * them matters much. Each shape is given its first partners, by their ids, until it has enough; two that both have enough wait until they do not lie so deep
 * any more. So it does not depend on the order in which they are reported which pairs are made, and what carries many things counts every one of them.
 */
export class Crowd {
  /** Those that have partners, and what they are put into: the lists are used again in the next step. */
  private readonly shapes = new List<Shape>();
  private readonly lists: List<Shape>[] = [];

  /** Takes two shapes that may interact and have no pair yet. @returns `false` if they are no case for a crowd. */
  take(a: Shape, b: Shape): boolean {
    if (!isCrowding(a, b)) {
      return false;
    }
    this.note(a, b);
    this.note(b, a);
    return true;
  }

  private note(shape: Shape, partner: Shape): void {
    if (shape.arbiters.length >= CROWD) {
      return;
    }
    shape.partners ??= this.enter(shape);
    const { partners } = shape;
    partners.add(partner);
    if (partners.count >= 2 * CROWD) {
      keepFirst(partners, shape);
    }
  }

  private enter(shape: Shape): List<Shape> {
    const at = this.shapes.count;
    this.shapes.add(shape);
    this.lists[at] ??= new List();
    return this.lists[at]!;
  }

  /** Lets go of shapes of earlier steps. */
  release(): void {
    this.shapes.release();
    for (const list of this.lists) {
      list.release();
    }
  }

  /** Tells which pairs are to be made, some twice. */
  drainTo(pairs: Pairs): void {
    for (let i = 0; i < this.shapes.count; i += 1) {
      const shape = this.shapes.items[i]!;
      const partners = this.lists[i]!;
      keepFirst(partners, shape);
      for (let k = 0; k < partners.count; k += 1) {
        pairs.note(shape, partners.items[k]!);
      }
      partners.clear();
      shape.partners = null;
    }
    this.shapes.clear();
  }
}

/** No one listens to them, nothing but each other is in their way, and each reaches over the middle of the other. */
function isCrowding(a: Shape, b: Shape): boolean {
  return (
    reaches(a, b) &&
    reaches(b, a) &&
    a.owner!.kind === DYNAMIC &&
    b.owner!.kind === DYNAMIC &&
    !a.sensor &&
    !b.sensor &&
    (a.listeners.types | b.listeners.types) === 0
  );
}

function reaches({ numbers: a, at: i }: Shape, { numbers: b, at: j }: Shape): boolean {
  const x = 0.5 * (b[j]! + b[j + 2]!);
  const y = 0.5 * (b[j + 1]! + b[j + 3]!);
  return a[i]! <= x && x <= a[i + 2]! && a[i + 1]! <= y && y <= a[i + 3]!;
}

function keepFirst(partners: List<Shape>, { arbiters }: Shape): void {
  sortFirst(partners.items, partners.count, isOlder);
  partners.count = Math.min(partners.count, CROWD - arbiters.length);
}
