import { DYNAMIC } from '../body-kind.js';
import { CROWD } from '../config.js';
import { List } from '../math/list.js';
import { sortFirst } from '../math/sort.js';
import type { Shape } from '../shape/shape.js';

interface Noting {
  note(shapeA: Shape, shapeB: Shape): void;
}

/**
 * Shapes that lie in the middle of each other, of which there may be thousands at one point: all pairs of them would be millions, and none of
 * them matters much. Each shape is given its first partners, by their ids, until it has enough; two that both have enough wait until they do not lie so deep
 * any more. So it does not depend on the order in which they are reported which pairs are made, and what carries many things counts every one of them.
 */
export class Crowd {
  private readonly shapes = new List<Shape>();

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
    shape.partners ??= [];
    const { partners } = shape;
    if (partners.length === 0) {
      this.shapes.add(shape);
    }
    partners.push(partner);
    if (partners.length >= 2 * CROWD) {
      keepFirst(partners, shape);
    }
  }

  /** Tells which pairs are to be made, some twice; of each the shape with the lower id comes first. */
  drainTo(pairs: Noting): void {
    for (let i = 0; i < this.shapes.count; i += 1) {
      const shape = this.shapes.items[i]!;
      const partners = shape.partners!;
      keepFirst(partners, shape);
      for (const partner of partners) {
        if (shape.id < partner.id) {
          pairs.note(shape, partner);
        } else {
          pairs.note(partner, shape);
        }
      }
      partners.length = 0;
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

function keepFirst(partners: Shape[], { arbiters }: Shape): void {
  sortFirst(partners, partners.length, hasLowerId);
  partners.length = Math.min(partners.length, CROWD - arbiters.length);
}

function hasLowerId(a: Shape, b: Shape): boolean {
  return a.id < b.id;
}
