import { expect, it } from 'vitest';
import { phys2D } from '../../src/index.js';
import { type Meeting, MeetingQueue } from '../../src/solver/impacts/meeting-queue.js';
import { Movers } from '../../src/solver/impacts/movers.js';
import { generator } from '../scenes/mixed.js';

// Meetings come out in time, however their times are changed in between.

function body(type: 'dynamic' | 'kinematic') {
  return phys2D.createRigidBody({ type, shapes: [phys2D.createCircleShape({ radius: 1 })] });
}

it('gives the first of the meetings that are left, those of equal times with kinematic bodies first, then by the ids of the shapes', () => {
  const random = generator(3);
  const movers = new Movers();
  const bodies = Array.from({ length: 40 }, (_, i) => body(i % 5 === 0 ? 'kinematic' : 'dynamic'));
  const queue = new MeetingQueue();
  const left = new Set<Meeting>();
  for (const [i, one] of bodies.entries()) {
    for (const two of bodies.slice(i + 1, i + 6)) {
      const meeting = queue.draft(one.shapes[0]!, two.shapes[0]!);
      meeting.time = Math.floor(8 * random());
      queue.add(meeting, movers.of(one), movers.of(two), true);
      left.add(meeting);
    }
  }
  const rank = ({ time, a, b }: Meeting): number[] => {
    const isKinematic = a.owner!.isKinematic() || b.owner!.isKinematic();
    return [time, isKinematic ? 0 : 1, a.id, b.id];
  };
  const compare = (one: Meeting, two: Meeting): number => {
    const other = rank(two);
    return (
      rank(one)
        .map((value, i) => value - other[i]!)
        .find((difference) => difference !== 0) ?? 0
    );
  };
  let taken = 0;
  for (let next = queue.first(); next !== null; next = queue.first()) {
    queue.remove(next);
    expect(next).toBe([...left].sort(compare)[0]);
    left.delete(next);
    taken += 1;
    for (const meeting of [...left].filter(() => random() < 0.05)) {
      if (random() < 0.5) {
        meeting.time = Math.floor(8 * random());
        queue.put(meeting);
      } else {
        queue.remove(meeting);
        left.delete(meeting);
      }
    }
  }
  expect(left.size).toBe(0);
  expect(taken).toBeGreaterThan(20);
});

it('lists the meetings of each dynamic body', () => {
  const movers = new Movers();
  const queue = new MeetingQueue();
  const [one, two, wall] = [body('dynamic'), body('dynamic'), body('kinematic')] as const;
  for (const [a, b] of [
    [one, two],
    [one, wall],
    [two, wall],
  ] as const) {
    queue.add(queue.draft(a.shapes[0]!, b.shapes[0]!), movers.of(a), movers.of(b), true);
  }
  const partners = (of: typeof one) => {
    const found = [];
    const mover = movers.of(of);
    for (let meeting = mover.newestMeeting; meeting !== null; meeting = meeting.nextOf(mover)) {
      found.push(meeting.a.owner === of ? meeting.b.owner : meeting.a.owner);
    }
    return found;
  };
  expect(new Set(partners(one))).toEqual(new Set([two, wall]));
  expect(new Set(partners(two))).toEqual(new Set([one, wall]));
  expect(partners(wall)).toEqual([]);
});
