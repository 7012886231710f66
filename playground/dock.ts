import { byId, type Icon, iconButton, make, setIcon } from './elements.js';
import { SPEEDS } from './settings.js';
import { TOOLS, type Tool } from './tools.js';

export interface DockActions {
  restart(): void;
  toggle(): void;
  step(): void;
  fit(): void;
  setSpeed(speed: number): void;
  setTool(tool: Tool): void;
}

/** The buttons below the picture. */
export class Dock {
  private readonly play: HTMLButtonElement;
  private readonly speed: HTMLSelectElement;
  private readonly tools = new Map<Tool, HTMLButtonElement>();

  constructor(actions: DockActions) {
    const button = (icon: Icon, label: string, id: string, run: () => void): HTMLButtonElement => {
      const made = iconButton(icon, label, { id });
      made.addEventListener('click', run);
      return made;
    };
    this.play = button('pause', 'Pause', 'play', () => actions.toggle());
    this.speed = make('select', { id: 'speed', 'aria-label': 'Speed' });
    for (const speed of SPEEDS) {
      this.speed.append(make('option', { value: String(speed) }, `${speed} ×`));
    }
    this.speed.addEventListener('change', () => actions.setSpeed(Number(this.speed.value)));
    byId('transport').append(
      button('restart', 'Restart', 'restart', () => actions.restart()),
      this.play,
      button('step', 'Single step', 'step', () => actions.step()),
      this.speed,
      button('fit', 'Show all', 'fit', () => actions.fit()),
    );
    for (const [tool, label] of Object.entries(TOOLS) as [Tool, string][]) {
      const choice = iconButton(tool, label, { role: 'radio', 'aria-checked': 'false', id: `tool-${tool}` });
      choice.append(make('span', {}, label));
      choice.addEventListener('click', ({ detail }) => {
        actions.setTool(tool);
        // By the pointer: arrows go on steering the scene.
        if (detail > 0) choice.blur();
      });
      this.tools.set(tool, choice);
      byId('tools').append(choice);
    }
    const choices = [...this.tools.entries()];
    byId('tools').addEventListener('keydown', (event) => {
      const way = { ArrowLeft: -1, ArrowUp: -1, ArrowRight: 1, ArrowDown: 1 }[event.key];
      const at = choices.findIndex(([, choice]) => choice === event.target);
      if (way !== undefined && at >= 0) {
        const [tool, choice] = choices[(at + way + choices.length) % choices.length]!;
        actions.setTool(tool);
        choice.focus();
        event.preventDefault();
      }
    });
  }

  show(playing: boolean, speed: number, tool: Tool): void {
    setIcon(this.play, playing ? 'pause' : 'play');
    const label = playing ? 'Pause' : 'Play';
    this.play.setAttribute('aria-label', label);
    this.play.title = label;
    this.speed.value = String(speed);
    for (const [name, choice] of this.tools) {
      choice.setAttribute('aria-checked', String(name === tool));
      choice.tabIndex = name === tool ? 0 : -1;
    }
  }
}
