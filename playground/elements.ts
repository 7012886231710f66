/** Pixels of the device for each of the page: no more than two are drawn. */
export function pixelRatio(): number {
  return Math.min(2, devicePixelRatio || 1);
}

/** The element of that id. */
export function byId<T extends HTMLElement>(id: string): T {
  const found = document.getElementById(id);
  if (found === null) {
    throw new Error(`The page has no #${id}`);
  }
  return found as T;
}

/** Makes an element. */
export function make<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Readonly<Record<string, string>> = {},
  ...children: (Node | string)[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    element.setAttribute(name, value);
  }
  element.append(...children);
  return element;
}

/** Lines of the icons, in a square of 24. */
const ICONS = {
  play: 'M8 5.5v13l10.5-6.5z',
  pause: 'M8 6v12M16 6v12',
  step: 'M6 6v12l8.5-6zM18 6v12',
  restart: 'M4.5 5v5h5M5 10a7.5 7.5 0 1 1-.3 4.5',
  fit: 'M4 9V4h5M20 9V4h-5M4 15v5h5M20 15v5h-5',
  grab: 'M12 3v18M3 12h18M12 3l-2.5 2.5M12 3l2.5 2.5M12 21l-2.5-2.5M12 21l2.5-2.5M3 12l2.5-2.5M3 12l2.5 2.5M21 12l-2.5-2.5M21 12l-2.5 2.5',
  box: 'M5 5h14v14H5z',
  disc: 'M12 4a8 8 0 1 0 0 16 8 8 0 1 0 0-16z',
  polygon: 'M12 3.5l8.6 6.2-3.3 10.1H6.7L3.4 9.7z',
  delete: 'M6 6l12 12M18 6L6 18',
  explode:
    'M12 2.5v5M12 16.5v5M2.5 12h5M16.5 12h5M5.3 5.3l3.5 3.5M15.2 15.2l3.5 3.5M18.7 5.3l-3.5 3.5M8.8 15.2l-3.5 3.5',
} as const;

export type Icon = keyof typeof ICONS;

export function setIcon(button: HTMLElement, icon: Icon): void {
  const space = 'http://www.w3.org/2000/svg';
  const picture = document.createElementNS(space, 'svg');
  picture.setAttribute('viewBox', '0 0 24 24');
  picture.setAttribute('aria-hidden', 'true');
  const path = document.createElementNS(space, 'path');
  path.setAttribute('d', ICONS[icon]);
  picture.append(path);
  button.querySelector('svg')?.remove();
  button.prepend(picture);
}

/** A button with an icon; `text` is shown where there is room. */
export function iconButton(
  icon: Icon,
  label: string,
  attributes: Readonly<Record<string, string>> = {},
): HTMLButtonElement {
  const button = make('button', { type: 'button', class: 'key', 'aria-label': label, title: label, ...attributes });
  setIcon(button, icon);
  return button;
}
