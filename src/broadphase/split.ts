import { perimeterOf } from './boxes.js';
import { BOX } from './layout.js';

/** Into how many slices of equal width boxes are sorted at most, by their centres. */
const BINS = 16;

/** For each slice: how many boxes are in it, the box around them, and the cost of a first part that ends with it. Scratch. */
const counts = /* @__PURE__ */ new Int32Array(BINS);
const around = /* @__PURE__ */ new Float64Array(BINS * BOX);
const costs = /* @__PURE__ */ new Float64Array(BINS);

/** The slices: how many, along which axis, from where on, and how many there are in 1 m. Scratch. */
const slices = { count: 0, axis: 0, start: 0.5, scale: 0.5 };

/** A box that grows: scratch. */
const sum = /* @__PURE__ */ new Float64Array(BOX);

/** The centre of a box along an axis. Each side is halved first, as their sum may overflow. */
function middleOf(boxes: Float64Array, node: number, axis: number): number {
  return 0.5 * boxes[BOX * node + axis]! + 0.5 * boxes[BOX * node + axis + 2]!;
}

/**
 * Divides part of a list of boxes into two, along the axis in which their centres are farther spread, where the sum over both parts of
 * perimeter times number of boxes is least (surface area heuristic, in bins: Wald, "On fast construction of SAH-based bounding volume
 * hierarchies", 2007). @returns where the second part begins.
 */
export function split(boxes: Float64Array, list: number[], from: number, to: number): number {
  laySlices(boxes, list, from, to);
  fillSlices(boxes, list, from, to);
  const second = partition(boxes, list, from, to, bestBin(to - from));
  return second > from && second < to ? second : (from + to) >> 1;
}

/** Moves the boxes in slices up to `last` to the front. @returns where the others begin. */
function partition(boxes: Float64Array, list: number[], from: number, to: number, last: number): number {
  let i = from;
  let j = to;
  while (i < j) {
    const node = list[i]!;
    if (binOf(boxes, node) <= last) {
      i += 1;
    } else {
      j -= 1;
      list[i] = list[j]!;
      list[j] = node;
    }
  }
  return i;
}

/** Divides the space of all centres into slices. */
function laySlices(boxes: Float64Array, list: number[], from: number, to: number): void {
  findMiddles(boxes, list, from, to);
  const width = sum[2]! - sum[0]!;
  const height = sum[3]! - sum[1]!;
  slices.count = Math.min(BINS, to - from);
  slices.axis = width > height ? 0 : 1;
  slices.start = sum[slices.axis]!;
  slices.scale = slices.count / Math.max(width, height);
}

/**
 * Writes the box around the centres of all boxes to `sum`. Nothing may follow the loop: the first list is long, and the code that V8
 * compiles while it runs bails out at anything after it that it has not seen run, a thousand times while a large world is built.
 */
function findMiddles(boxes: Float64Array, list: number[], from: number, to: number): void {
  clear(sum, 0);
  for (let i = from; i < to; i += 1) {
    const x = middleOf(boxes, list[i]!, 0);
    const y = middleOf(boxes, list[i]!, 1);
    sum[0] = Math.min(sum[0]!, x);
    sum[1] = Math.min(sum[1]!, y);
    sum[2] = Math.max(sum[2]!, x);
    sum[3] = Math.max(sum[3]!, y);
  }
}

function binOf(boxes: Float64Array, node: number): number {
  return Math.min(slices.count - 1, (slices.scale * (middleOf(boxes, node, slices.axis) - slices.start)) | 0);
}

/** Sorts boxes into the slices. */
function fillSlices(boxes: Float64Array, list: number[], from: number, to: number): void {
  for (let bin = 0; bin < slices.count; bin += 1) {
    counts[bin] = 0;
    clear(around, BOX * bin);
  }
  for (let i = from; i < to; i += 1) {
    const bin = binOf(boxes, list[i]!);
    counts[bin]! += 1;
    grow(around, BOX * bin, boxes, BOX * list[i]!);
  }
}

/** The last slice of the first part, for the least cost. */
function bestBin(count: number): number {
  clear(sum, 0);
  let before = 0;
  for (let bin = 0; bin < slices.count; bin += 1) {
    grow(sum, 0, around, BOX * bin);
    before += counts[bin]!;
    costs[bin] = before * perimeterOf(sum, 0);
  }
  clear(sum, 0);
  let best = 0;
  let least = Infinity;
  for (let bin = slices.count - 1; bin > 0; bin -= 1) {
    grow(sum, 0, around, BOX * bin);
    before -= counts[bin]!;
    const cost = costs[bin - 1]! + (count - before) * perimeterOf(sum, 0);
    if (before > 0 && before < count && cost < least) {
      least = cost;
      best = bin - 1;
    }
  }
  return best;
}

function clear(box: Float64Array, at: number): void {
  box[at] = Infinity;
  box[at + 1] = Infinity;
  box[at + 2] = -Infinity;
  box[at + 3] = -Infinity;
}

function grow(box: Float64Array, at: number, by: Float64Array, from: number): void {
  box[at] = Math.min(box[at]!, by[from]!);
  box[at + 1] = Math.min(box[at + 1]!, by[from + 1]!);
  box[at + 2] = Math.max(box[at + 2]!, by[from + 2]!);
  box[at + 3] = Math.max(box[at + 3]!, by[from + 3]!);
}
