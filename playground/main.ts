import { Dock } from './dock.js';
import { byId, make } from './elements.js';
import { Figures } from './figures.js';
import { DRAWING, Graph } from './graph.js';
import { buildPad, listen, type Shortcut } from './keys.js';
import { Panel } from './panel.js';
import { Pointers } from './pointer.js';
import { groups, scenes } from './scenes.js';
import { fromLink, type Settings, toLink } from './settings.js';
import { Sheets } from './sheets.js';
import { Simulation } from './simulation.js';
import { TOOLS, type Tool } from './tools.js';
import { View } from './view.js';

/** ms between two looks at the numbers. */
const LOOK = 250;
/** Steps made at a time on the way to the one that a link asks for. */
const LEAP = 20;

/** px of the picture from its edge to the other side of what lies over it there, if it is shown. */
function covered(id: string): number {
  const element = byId(id);
  const below = byId('stage').clientHeight - element.offsetTop - element.offsetHeight;
  return element.offsetParent === null ? 0 : element.offsetHeight + Math.min(element.offsetTop, below);
}

/** Scrolls a list, and nothing else, so that an element of it is seen. */
function reveal(element: HTMLElement, list: HTMLElement): void {
  const [inner, outer] = [element.getBoundingClientRect(), list.getBoundingClientRect()];
  list.scrollTop += Math.min(0, inner.top - outer.top - 8) + Math.max(0, inner.bottom - outer.bottom + 8);
}

/** The page: what is set, what runs, what is seen. `playground` in the console. */
class Playground {
  readonly simulation = new Simulation(fromLink(location.hash));
  readonly view = new View(byId('stage'), () => this.margins());
  readonly pointers = new Pointers(this.view, this.simulation);
  private readonly panel = new Panel(
    (part) => this.change(part),
    () => this.simulation.settings.draw,
  );
  private readonly dock = new Dock({
    restart: () => this.restart(),
    toggle: () => this.setPlaying(!this.simulation.playing),
    step: () => this.step(),
    fit: () => this.view.fit(this.simulation),
    setSpeed: (speed) => this.change({ speed }),
    setTool: (tool) => this.setTool(tool),
  });
  private readonly sheets = new Sheets();
  private readonly figures = new Figures();
  private readonly graph = new Graph(byId('graph'), byId('legend'));
  private last = 0;
  private looked = -Infinity;
  private shown = -1;
  private hideMessage = 0;

  constructor() {
    this.listScenes();
    this.addActions();
    buildPad(this.simulation.controls);
    listen(this.shortcuts(), this.simulation.controls);
    addEventListener('hashchange', () => this.open(fromLink(location.hash)));
    const dark = matchMedia('(prefers-color-scheme: dark)');
    dark.addEventListener('change', () => this.setTheme(dark.matches));
    this.setTheme(dark.matches);
    this.setTool('grab');
    requestAnimationFrame((now) => this.frame(now));
  }

  get settings(): Settings {
    return this.simulation.settings;
  }

  /** Takes other settings, from a link or the list. */
  open(settings: Settings): void {
    const { simulation } = this;
    simulation.settings = settings;
    simulation.playing = true;
    simulation.restart();
    this.sheets.close();
  }

  change(part: Partial<Settings>): void {
    this.simulation.apply({ ...this.settings, steps: null, ...part });
    this.tell();
  }

  restart(): void {
    this.open({ ...this.settings, steps: null });
  }

  setPlaying(playing: boolean): void {
    this.simulation.playing = playing;
    this.change({});
    this.looked = -Infinity;
  }

  step(): void {
    this.setPlaying(false);
    this.simulation.step();
    this.graph.add(this.simulation.times);
    this.looked = -Infinity;
  }

  setTool(tool: Tool): void {
    this.pointers.tool = tool;
    this.view.canvas.dataset.tool = tool;
    this.tell();
  }

  setTheme(isDark: boolean): void {
    document.documentElement.style.colorScheme = isDark ? 'dark' : 'light';
    this.view.setTheme(isDark);
  }

  /** A link to what is seen: while it is paused, and no hand was in it, to this very step. */
  link(): string {
    const { simulation } = this;
    const steps = simulation.playing || simulation.touched ? null : simulation.steps;
    return `${location.href.replace(/#.*/, '')}#${toLink({ ...this.settings, steps })}`;
  }

  /** What is followed is in the middle, so the arrows may lie over the rest. */
  private margins(): readonly [number, number] {
    const pad = this.simulation.play.follow === undefined ? covered('pad') : 0;
    return [covered('caption'), Math.max(covered('dock'), pad)];
  }

  private frame(now: number): void {
    const { simulation, view, graph } = this;
    const elapsed = Math.min(0.1, Math.max(0, (now - this.last) / 1000));
    this.last = now;
    if (this.shown !== simulation.generation) {
      this.shown = simulation.generation;
      this.showScene();
    }
    if (view.resize()) {
      view.fit(simulation);
    }
    this.pointers.update();
    const made = this.leap() || simulation.advance(elapsed) > 0;
    const start = performance.now();
    view.draw(simulation, this.settings.draw);
    if (made) {
      simulation.times.set(DRAWING, performance.now() - start);
      graph.add(simulation.times);
    }
    if (now - this.looked > LOOK) {
      this.looked = now;
      graph.draw();
      this.figures.show(simulation);
    }
    requestAnimationFrame((next) => this.frame(next));
  }

  /** Goes on towards the step that the link asks for, and pauses there. @returns whether it has made steps. */
  private leap(): boolean {
    const { simulation } = this;
    const { steps } = this.settings;
    if (steps === null || !simulation.playing) {
      return false;
    }
    const missing = Math.min(LEAP, steps - simulation.steps);
    simulation.step(missing);
    if (simulation.steps >= steps) {
      simulation.playing = false;
      this.looked = -Infinity;
      this.tell();
    }
    return missing > 0;
  }

  /** Puts what is set onto the page and into its address. */
  private tell(): void {
    const { simulation, settings } = this;
    this.dock.show(simulation.playing, settings.speed, this.pointers.tool);
    this.panel.show(settings, settings.gravity ?? simulation.scene.gravity ?? [0, 10]);
    history.replaceState(null, '', `#${toLink(settings)}`);
  }

  private showScene(): void {
    const { scene } = this.simulation;
    byId('title').textContent = scene.title;
    byId('note').textContent = scene.note;
    document.title = `${scene.title} · phys2d playground`;
    byId('pad').hidden = scene.controls !== true;
    for (const button of byId('scenes').querySelectorAll('button')) {
      const isThis = button.dataset.scene === scene.id;
      button.setAttribute('aria-current', String(isThis));
      if (isThis) {
        reveal(button, byId('scenes'));
      }
    }
    this.view.canvas.setAttribute('aria-label', `${scene.title}: ${scene.note}`);
    this.view.resize();
    this.view.fit(this.simulation);
    this.graph.clear();
    this.looked = -Infinity;
    this.tell();
  }

  private listScenes(): void {
    for (const group of groups) {
      const list = make('ul');
      for (const { id, title } of group.scenes) {
        const button = make('button', { type: 'button', 'data-scene': id }, title);
        button.addEventListener('click', () => this.openScene(id));
        list.append(make('li', {}, button));
      }
      byId('scenes').append(make('h2', {}, group.title), list);
    }
  }

  /** Another scene: with its own gravity, all else as it is set. */
  private openScene(scene: string): void {
    this.open({ ...this.settings, scene, gravity: null, steps: null });
  }

  private turnPage(by: number): void {
    const at = scenes.indexOf(this.simulation.scene);
    this.openScene(scenes[(at + by + scenes.length) % scenes.length]!.id);
  }

  private addActions(): void {
    const action = (id: string, label: string, run: () => void): void => {
      const button = make('button', { type: 'button', id, class: 'plain' }, label);
      button.addEventListener('click', run);
      byId('actions').append(button);
    };
    action('copy', 'Copy link', () => this.copyLink());
    action('theme', 'Theme', () => this.switchTheme());
    action('open-help', 'Keys', () => byId<HTMLDialogElement>('help').showModal());
  }

  private switchTheme(): void {
    this.setTheme(document.documentElement.style.colorScheme !== 'dark');
  }

  private copyLink(): void {
    const link = this.link();
    const { playing, touched } = this.simulation;
    const from = !playing && touched ? ': from the start, as a hand was in it' : '';
    history.replaceState(null, '', link);
    const done = navigator.clipboard?.writeText(link) ?? Promise.reject(new Error('no clipboard'));
    done.then(
      () => this.say(`The link is copied${from}`),
      () => this.say(`The link is in the address bar${from}`),
    );
  }

  private say(text: string): void {
    const message = byId('message');
    message.textContent = text;
    message.classList.add('shown');
    clearTimeout(this.hideMessage);
    this.hideMessage = setTimeout(() => message.classList.remove('shown'), 1800);
  }

  private shortcuts(): Shortcut[] {
    const tools = Object.keys(TOOLS) as Tool[];
    return [
      { key: ' ', shown: 'Space', does: 'play or pause', run: () => this.setPlaying(!this.simulation.playing) },
      { key: '.', does: 'single step', run: () => this.step() },
      { key: 'r', does: 'restart', run: () => this.restart() },
      { key: '[', does: 'the scene before', run: () => this.turnPage(-1) },
      { key: ']', does: 'the next scene', run: () => this.turnPage(1) },
      { key: 'f', does: 'show all', run: () => this.view.fit(this.simulation) },
      { key: 'l', does: 'copy the link', run: () => this.copyLink() },
      { key: 't', does: 'light or dark', run: () => this.switchTheme() },
      ...tools.map((tool, i) => ({
        key: String(i + 1),
        does: TOOLS[tool].toLowerCase(),
        run: () => this.setTool(tool),
      })),
      { key: '?', does: 'this list', run: () => byId<HTMLDialogElement>('help').showModal() },
    ];
  }
}

try {
  Object.assign(globalThis, { playground: new Playground() });
} catch (error) {
  byId('message').textContent = String(error instanceof Error ? error.message : error);
  byId('message').classList.add('shown');
  throw error;
}
