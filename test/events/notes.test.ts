import { expect, it } from 'vitest';
import { Note, Notes } from '../../src/events/notes.js';
import { phys2D } from '../../src/index.js';
import { BEGIN } from '../../src/listeners.js';
import { disc } from '../conformance/setting.js';

const PAIRS = [
  [3, 4],
  [1, 9],
  [3, 2],
  [1, 2],
  [2, 7],
] as const;

function fill(notes: Notes, pairs: readonly (readonly [number, number])[]): void {
  for (const [idA, idB] of pairs) {
    notes.add(idA, idB);
  }
}

const listed = (notes: Notes): number[][] => notes.all.slice(0, notes.count).map(({ idA, idB }) => [idA, idB]);

it('notes are ordered by the first id, then by the second', () => {
  const notes = new Notes(BEGIN);
  fill(notes, PAIRS);
  notes.sort();
  expect(listed(notes)).toEqual([
    [1, 2],
    [1, 9],
    [2, 7],
    [3, 2],
    [3, 4],
  ]);
});

it('notes of the same ids stay as they came, and what was used before is not among them', () => {
  const notes = new Notes(BEGIN);
  fill(notes, PAIRS);
  const before = [...notes.all];
  notes.clear();
  expect(notes.count).toBe(0);
  fill(notes, [
    [8, 1],
    [7, 1],
    [7, 1],
  ]);
  expect(notes.all).toEqual(before);
  const [last, first, second] = notes.all;
  notes.sort();
  expect(notes.all.slice(0, 3)).toEqual([first, second, last]);
  expect(notes.all[0]).toBe(first);
  expect(notes.all[1]).toBe(second);
  expect(listed(notes)).toEqual([
    [7, 1],
    [7, 1],
    [8, 1],
  ]);
});

it('what is cleared holds on to nothing', () => {
  const notes = new Notes(BEGIN);
  const note = notes.add(0, 0);
  const [own, other] = [disc(1), disc(1)];
  own.addEventListener('begin', () => {});
  Object.assign(note, { own, other, listeners: own.listeners, otherListeners: own.listeners });
  note.body = phys2D.createRigidBody({ shapes: [own] });
  notes.clear();
  expect(note).toEqual(new Note());
});
