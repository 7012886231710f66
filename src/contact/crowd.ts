import { DYNAMIC } from '../body-kind.js';
import { CROWD } from '../config.js';
import { MAX_X, MAX_Y, MIN_X, MIN_Y } from '../geometry/layout.js';
import { List } from '../math/list.js';
import { sortFirst } from '../math/sort.js';
import { isOlder, type Shape } from '../shape/shape.js';
import type { Pairs } from './pairs.js';

/**
 * Shapes that overlap so much that each covers the other's centre. There may be thousands at one point: all pairs of them would be
 * millions, and none matters much. So each shape gets only a limited number of partners, those with the lowest ids; two shapes that both
 * have enough are not paired until they overlap less. Which pairs are made thus does not depend on the order in which they are reported,
 * and what carries many things meets every one of them.
 */
export class Crowd {
  /** The shapes that have partners in this step, and the lists of these, which are used again in the next one. */
  private readonly shapes = new List<Shape>();
  private readonly lists: List<Shape>[] = [];

  /** Takes two shapes that may interact and have no pair yet. @returns `false`, without effect, if they are no case for a crowd. */
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

  /** Reports the pairs that are to be made, some of them twice. */
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

/** Whether two shapes are both dynamic and solid, without listeners, and each covers the centre of the other's bounds. */
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
  const x = 0.5 * (b[j + MIN_X]! + b[j + MAX_X]!);
  const y = 0.5 * (b[j + MIN_Y]! + b[j + MAX_Y]!);
  return a[i + MIN_X]! <= x && x <= a[i + MAX_X]! && a[i + MIN_Y]! <= y && y <= a[i + MAX_Y]!;
}

function keepFirst(partners: List<Shape>, { arbiters }: Shape): void {
  sortFirst(partners.items, partners.count, isOlder);
  partners.count = Math.min(partners.count, CROWD - arbiters.length);
}
