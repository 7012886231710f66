/** How far, in cells, a segment may miss a cell through rounding; rounding errors are far smaller. */
const SLACK = 1e-9;

/**
 * A grid of cells over some points, about as many as there are points, in which things are listed: a search for what is near looks at a few
 * cells, not at all things.
 */
export class Grid<T> {
  private readonly left: number;
  private readonly top: number;
  private readonly width: number;
  private readonly height: number;
  /** The number of rows, and of columns. */
  private readonly size: number;
  private readonly cells: T[][];
  /** Ranges of distances, m: from 0 to about the size of a cell, from there to twice as far, and so on. */
  readonly rings: (readonly [number, number])[] = [];

  constructor(x: readonly number[], y: readonly number[]) {
    const least = (values: readonly number[]) => values.reduce((a, b) => Math.min(a, b));
    const most = (values: readonly number[]) => values.reduce((a, b) => Math.max(a, b));
    this.left = least(x);
    this.top = least(y);
    this.width = most(x) - this.left || 1;
    this.height = most(y) - this.top || 1;
    this.size = Math.ceil(Math.sqrt(x.length));
    this.cells = Array.from({ length: this.size * this.size }, () => []);
    let from = 0;
    for (let parts = this.size; parts >= 1; parts /= 2) {
      const to = Math.max(this.width, this.height) / parts;
      this.rings.push([from, to]);
      from = to;
    }
    this.rings.push([from, Infinity]);
  }

  /** The cell that a point is in. */
  at(x: number, y: number): T[] {
    return this.cells[this.cellAt(this.rowAt(y)) * this.size + this.cellAt(this.columnAt(x))]!;
  }

  /** Visits the cells of a box until a visit returns `true`. @returns whether one did. */
  within(minX: number, minY: number, maxX: number, maxY: number, visit: (cell: T[]) => unknown): boolean {
    const last = this.cellAt(this.rowAt(maxY));
    for (let row = this.cellAt(this.rowAt(minY)); row <= last; row += 1) {
      if (this.inRow(row, this.columnAt(minX), this.columnAt(maxX), visit)) {
        return true;
      }
    }
    return false;
  }

  /** Visits the cells that a segment goes through, and perhaps some beside them, likewise. */
  along(ax: number, ay: number, bx: number, by: number, visit: (cell: T[]) => unknown): boolean {
    const column = this.columnAt(ax);
    const row = this.rowAt(ay);
    const columns = this.columnAt(bx) - column;
    const rows = this.rowAt(by) - row;
    // The column where the segment reaches a row, or ends before.
    const columnIn = (to: number) => column + Math.max(0, Math.min(1, (to - row) / rows)) * columns;
    const last = this.cellAt(Math.max(row, row + rows) + SLACK);
    for (let r = this.cellAt(Math.min(row, row + rows) - SLACK); r <= last; r += 1) {
      const enters = rows === 0 ? column : columnIn(r - SLACK);
      const leaves = rows === 0 ? column + columns : columnIn(r + 1 + SLACK);
      if (this.inRow(r, Math.min(enters, leaves) - SLACK, Math.max(enters, leaves) + SLACK, visit)) {
        return true;
      }
    }
    return false;
  }

  private inRow(row: number, from: number, to: number, visit: (cell: T[]) => unknown): boolean {
    const last = this.cellAt(to);
    for (let column = this.cellAt(from); column <= last; column += 1) {
      if (visit(this.cells[row * this.size + column]!) === true) {
        return true;
      }
    }
    return false;
  }

  private columnAt(x: number): number {
    return ((x - this.left) / this.width) * this.size;
  }

  private rowAt(y: number): number {
    return ((y - this.top) / this.height) * this.size;
  }

  private cellAt(place: number): number {
    return Math.max(0, Math.min(this.size - 1, Math.floor(place)));
  }
}
