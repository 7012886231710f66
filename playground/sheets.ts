import { byId } from './elements.js';

/** On small screens the list of scenes and the panel lie over the picture, one at a time. */
export class Sheets {
  private readonly pairs = (['scenes', 'panel'] as const).map((name) => ({
    sheet: byId(name),
    button: byId(`open-${name}`),
  }));

  constructor() {
    for (const { sheet, button } of this.pairs) {
      button.addEventListener('click', () => {
        const opens = !sheet.classList.contains('open');
        this.close();
        sheet.classList.toggle('open', opens);
        button.setAttribute('aria-expanded', String(opens));
      });
    }
    byId('stage').addEventListener('pointerdown', () => this.close());
    addEventListener('keydown', (event) => {
      if (event.key === 'Escape') {
        this.close();
      }
    });
  }

  close(): void {
    for (const { sheet, button } of this.pairs) {
      sheet.classList.remove('open');
      button.setAttribute('aria-expanded', 'false');
    }
  }
}
