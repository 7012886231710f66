import { DYNAMIC, KINEMATIC } from '../../body-kind.js';
import { isOlder, type Shape } from '../../shape/shape.js';
import type { Mover } from './movers.js';

/** Two shapes that meet on their ways, and when. The object is used again and again. */
export class Meeting {
  /** From 0 where the step began to 1 where it ended. Infinite: they do not meet unless something stops one of them before. */
  time = 0.5;
  /** Whether `time` is only the earliest that it may be: the exact one is found when the meeting is the next. */
  isEstimate = false;
  /**
   * Whether one lands on the other: they were close as the step began, or neither is near any ground, from which it would slide over to the
   * other.
   */
  lands = false;
  /** Place in the heap, −1 while it is not in it. */
  slot = -1;
  /** The next meeting of each of the two bodies. */
  nextOfA: Meeting | null = null;
  nextOfB: Meeting | null = null;

  constructor(
    public a: Shape,
    public b: Shape,
  ) {}

  /** The meeting after this one in the list of a body. */
  nextOf({ body }: Mover): Meeting | null {
    return this.a.owner === body ? this.nextOfA : this.nextOfB;
  }
}

/**
 * The order of meetings: by time; of equal times those with kinematic bodies first, then by the ids of the shapes. Those that never come
 * have no order.
 */
function comesBefore(one: Meeting, two: Meeting): boolean {
  if (one.time !== two.time || one.time === Infinity) {
    return one.time < two.time;
  }
  const kinematic = isKinematic(one);
  if (kinematic !== isKinematic(two)) {
    return kinematic;
  }
  return one.a.id !== two.a.id ? one.a.id < two.a.id : one.b.id < two.b.id;
}

function isKinematic({ a, b }: Meeting): boolean {
  return a.owner!.kind === KINEMATIC || b.owner!.kind === KINEMATIC;
}

/**
 * The meetings of a step: in a binary heap that gives the first one, and in a list for each dynamic body. The heap is only made when the
 * first is asked for, as many of those that are added are removed before.
 */
export class MeetingQueue {
  /** In the order in which they were found. What lies beyond the count is used again. */
  readonly all: Meeting[] = [];
  count = 0;
  private readonly heap: Meeting[] = [];
  private size = 0;
  private isHeap = false;

  clear(): void {
    this.count = 0;
    this.size = 0;
    this.isHeap = false;
  }

  /** Releases shapes of earlier steps. */
  release(): void {
    for (const meeting of this.all) {
      meeting.a = null!;
      meeting.b = null!;
    }
  }

  /** A meeting of two shapes that is not among the others until it is added. */
  draft(one: Shape, two: Shape): Meeting {
    if (this.count === this.all.length) {
      this.all.push(new Meeting(one, two));
    }
    const meeting = this.all[this.count]!;
    const isFirst = isOlder(one, two);
    meeting.a = isFirst ? one : two;
    meeting.b = isFirst ? two : one;
    meeting.slot = -1;
    meeting.isEstimate = false;
    meeting.lands = false;
    return meeting;
  }

  /** Adds the draft. If it `comes`, it waits in the heap. */
  add(meeting: Meeting, one: Mover, two: Mover, comes: boolean): void {
    this.count += 1;
    if (!comes) {
      return;
    }
    meeting.nextOfA = one.newestMeeting;
    meeting.nextOfB = two.newestMeeting;
    if (one.body.kind === DYNAMIC) {
      one.newestMeeting = meeting;
    }
    if (two.body.kind === DYNAMIC) {
      two.newestMeeting = meeting;
    }
    this.size += 1;
    this.put(meeting, this.size - 1);
  }

  /** The meeting with the earliest time; `null` if there is none. */
  first(): Meeting | null {
    if (!this.isHeap) {
      this.isHeap = true;
      for (let slot = (this.size >> 1) - 1; slot >= 0; slot -= 1) {
        this.sink(this.heap[slot]!, slot);
      }
    }
    return this.size > 0 ? this.heap[0]! : null;
  }

  /** Takes a meeting out of the heap. */
  remove(meeting: Meeting): void {
    const { slot } = meeting;
    meeting.slot = -1;
    this.size -= 1;
    if (slot < this.size) {
      this.put(this.heap[this.size]!, slot);
    }
  }

  /** Puts a meeting into its place in the heap; to be called when its time has changed. */
  put(meeting: Meeting, slot = meeting.slot): void {
    if (this.isHeap) {
      this.rise(meeting, slot);
      this.sink(meeting, meeting.slot);
    } else {
      this.heap[slot] = meeting;
      meeting.slot = slot;
    }
  }

  private rise(meeting: Meeting, from: number): void {
    const { heap } = this;
    let slot = from;
    while (slot > 0) {
      const above = heap[(slot - 1) >> 1]!;
      if (!comesBefore(meeting, above)) {
        break;
      }
      heap[slot] = above;
      above.slot = slot;
      slot = (slot - 1) >> 1;
    }
    heap[slot] = meeting;
    meeting.slot = slot;
  }

  private sink(meeting: Meeting, from: number): void {
    const { heap, size } = this;
    let slot = from;
    for (let below = 2 * slot + 1; below < size; below = 2 * slot + 1) {
      if (below + 1 < size && comesBefore(heap[below + 1]!, heap[below]!)) {
        below += 1;
      }
      const next = heap[below]!;
      if (!comesBefore(next, meeting)) {
        break;
      }
      heap[slot] = next;
      next.slot = slot;
      slot = below;
    }
    heap[slot] = meeting;
    meeting.slot = slot;
  }
}
