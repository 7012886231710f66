import { byId, make } from './elements.js';
import { type Broadphase, DRAW_OPTIONS, type DrawOption, RANGES, type Settings } from './settings.js';

type Change = (part: Partial<Settings>) => void;

/** A row with a slider. */
interface Slider {
  readonly input: HTMLInputElement;
  readonly shown: HTMLOutputElement;
}

/** What one can set, on the right or in a sheet. */
export class Panel {
  private readonly sliders: Record<keyof typeof RANGES | 'gravityX' | 'gravityY', Slider>;
  private readonly broadphase: HTMLSelectElement;
  private readonly sleep: HTMLInputElement;
  private readonly draw = new Map<DrawOption, HTMLInputElement>();

  constructor(change: Change, drawn: () => ReadonlySet<DrawOption>) {
    const world = make('fieldset', {}, make('legend', {}, 'World'));
    const gravity = (): void => {
      const { gravityX, gravityY } = this.sliders;
      change({ gravity: [gravityX.input.valueAsNumber, gravityY.input.valueAsNumber] });
    };
    const whole = (name: keyof typeof RANGES, label: string): Slider => {
      const [least, most] = RANGES[name];
      return slider(world, label, least, most, 1, (value) => change({ [name]: value }));
    };
    this.sliders = {
      gravityX: slider(world, 'Gravity across', -20, 20, 0.5, gravity),
      gravityY: slider(world, 'Gravity down', -20, 20, 0.5, gravity),
      velocityIterations: whole('velocityIterations', 'Velocity iterations'),
      positionIterations: whole('positionIterations', 'Position iterations'),
      substeps: whole('substeps', 'Substeps'),
    };
    this.broadphase = make(
      'select',
      {},
      make('option', { value: 'tree' }, 'Box tree'),
      make('option', { value: 'sweep' }, 'Sweep and prune'),
    );
    this.broadphase.addEventListener('change', () => change({ broadphase: this.broadphase.value as Broadphase }));
    world.append(make('label', { class: 'choice' }, 'Broadphase', this.broadphase));
    this.sleep = check(world, 'Bodies fall asleep', (on) => change({ sleep: on }));

    const drawing = make('fieldset', {}, make('legend', {}, 'Drawing'));
    for (const [name, label] of Object.entries(DRAW_OPTIONS) as [DrawOption, string][]) {
      const set = (on: boolean): void => {
        change({ draw: new Set([...drawn()].filter((other) => other !== name).concat(on ? name : [])) });
      };
      this.draw.set(name, check(drawing, label, set));
    }
    byId('settings').append(world, drawing);
  }

  /** Shows how things are set. */
  show(settings: Settings, gravity: readonly [number, number]): void {
    const { sliders } = this;
    const values = { gravityX: gravity[0], gravityY: gravity[1], ...settings };
    for (const name of Object.keys(sliders) as (keyof typeof sliders)[]) {
      sliders[name].input.valueAsNumber = values[name];
      sliders[name].shown.value = String(values[name]);
    }
    this.broadphase.value = settings.broadphase;
    this.sleep.checked = settings.sleep;
    for (const [name, box] of this.draw) {
      box.checked = settings.draw.has(name);
    }
  }
}

function slider(
  parent: HTMLElement,
  label: string,
  least: number,
  most: number,
  step: number,
  set: (value: number) => void,
): Slider {
  const range = { type: 'range', min: String(least), max: String(most), step: String(step), 'aria-label': label };
  const input = make('input', range);
  const shown = make('output');
  input.addEventListener('input', () => {
    shown.value = input.value;
    set(input.valueAsNumber);
  });
  parent.append(make('label', {}, label, input, shown));
  return { input, shown };
}

function check(parent: HTMLElement, label: string, set: (on: boolean) => void): HTMLInputElement {
  const input = make('input', { type: 'checkbox' });
  input.addEventListener('change', () => set(input.checked));
  parent.append(make('label', { class: 'check' }, input, label));
  return input;
}
