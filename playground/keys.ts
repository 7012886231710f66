import type { Controls } from '../test/scenes/play.js';
import { byId, make } from './elements.js';

/** A shortcut: its key as `KeyboardEvent.key` has it, as the help shows it, and what it does. */
export interface Shortcut {
  readonly key: string;
  readonly shown?: string;
  readonly does: string;
  run(): void;
}

const ARROWS: Readonly<Record<string, keyof Controls>> = {
  ArrowLeft: 'left',
  ArrowRight: 'right',
  ArrowUp: 'up',
  ArrowDown: 'down',
};

/** Calls shortcuts, and tells the scene which arrows are down. Keys that go to a control of the page are left alone. */
export function listen(shortcuts: readonly Shortcut[], controls: Controls): void {
  const isWithin = ({ target }: KeyboardEvent, selector: string): boolean =>
    target instanceof Element && target.closest(selector) !== null;
  addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey || isWithin(event, 'input, select, dialog')) {
      return;
    }
    const arrow = ARROWS[event.key];
    if (arrow !== undefined) {
      if (!isWithin(event, '[role=radiogroup]')) {
        controls[arrow] = true;
        event.preventDefault();
      }
      return;
    }
    const shortcut = shortcuts.find(({ key }) => key === event.key.toLowerCase());
    const presses = event.key === ' ' && event.target instanceof HTMLButtonElement;
    if (shortcut !== undefined && !presses) {
      event.preventDefault();
      shortcut.run();
    }
  });
  addEventListener('keyup', (event) => {
    const arrow = ARROWS[event.key];
    if (arrow !== undefined) {
      controls[arrow] = false;
    }
  });
  // Who set something with the pointer goes on with keys that are meant for the scene; who came to it with the keyboard is left there.
  let byPointer = false;
  addEventListener('pointerdown', () => {
    byPointer = true;
  });
  addEventListener('keydown', () => {
    byPointer = false;
  });
  addEventListener('change', ({ target }) => {
    if (byPointer && target instanceof HTMLElement) {
      target.blur();
    }
  });
  addEventListener('blur', () => {
    for (const arrow of Object.values(ARROWS)) {
      controls[arrow] = false;
    }
  });
  const list = byId('keys');
  for (const { key, shown = key.toUpperCase(), does } of shortcuts) {
    list.append(make('dt', {}, shown), make('dd', {}, does));
  }
  list.append(make('dt', {}, '← → ↑ ↓'), make('dd', {}, 'steer, where a scene can be steered'));
}

/** Buttons for the arrows, for fingers. */
export function buildPad(controls: Controls): void {
  const button = (arrow: keyof Controls, sign: string, label: string): HTMLElement => {
    const key = make('button', { type: 'button', 'aria-label': label }, sign);
    key.addEventListener('pointerdown', (event) => {
      key.setPointerCapture(event.pointerId);
      controls[arrow] = true;
    });
    for (const type of ['pointerup', 'pointercancel', 'lostpointercapture'] as const) {
      key.addEventListener(type, () => {
        controls[arrow] = false;
      });
    }
    key.addEventListener('contextmenu', (event) => event.preventDefault());
    return key;
  };
  byId('pad').append(
    make('div', {}, button('left', '←', 'Left'), button('right', '→', 'Right')),
    make('div', {}, button('down', '↓', 'Down'), button('up', '↑', 'Up')),
  );
}
