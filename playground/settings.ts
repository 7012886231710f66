import { sceneOf } from './scenes.js';

/** What is simulated and shown: all that a link holds. */
export interface Settings {
  scene: string;
  /** Simulated time, times that of the clock. */
  speed: number;
  /** m/s²; `null`: what the scene brings. */
  gravity: readonly [number, number] | null;
  velocityIterations: number;
  positionIterations: number;
  substeps: number;
  broadphase: Broadphase;
  sleep: boolean;
  /** Steps to make at once, and then to pause; `null`: play. */
  steps: number | null;
  draw: ReadonlySet<DrawOption>;
}

export type Broadphase = 'tree' | 'sweep';

/** What can be drawn, and its name on the panel. */
export const DRAW_OPTIONS = {
  fill: 'Filled bodies',
  constraints: 'Constraints',
  contacts: 'Contacts',
  impulses: 'Impulses',
  boxes: 'Bounds',
  bodies: 'Origins and paths',
  debug: 'Debug drawing only',
  smooth: 'Interpolation',
} as const;

export type DrawOption = keyof typeof DRAW_OPTIONS;

export const SPEEDS: readonly number[] = [0.1, 0.25, 0.5, 1, 2, 4];

/** Ranges of the whole numbers. */
export const RANGES = {
  velocityIterations: [1, 60],
  positionIterations: [1, 60],
  substeps: [1, 16],
} as const satisfies Record<string, readonly [number, number]>;

/** Longest run that a link may ask for. */
const MAX_STEPS = 20_000;

const SHORT = { velocityIterations: 'velocity', positionIterations: 'position', substeps: 'substeps' } as const;

export function defaults(scene: string): Settings {
  return {
    scene,
    speed: 1,
    gravity: null,
    velocityIterations: 8,
    positionIterations: 8,
    substeps: 4,
    broadphase: 'tree',
    sleep: true,
    steps: null,
    draw: new Set<DrawOption>(['fill', 'constraints', 'smooth']),
  };
}

/** The settings as the part of a link after #; what is as always is left out. */
export function toLink(settings: Settings): string {
  const usual = defaults(settings.scene);
  const link = new URLSearchParams({ scene: settings.scene });
  if (settings.speed !== usual.speed) {
    link.set('speed', String(settings.speed));
  }
  if (settings.gravity !== null) {
    link.set('gravity', settings.gravity.join(','));
  }
  for (const [name, short] of Object.entries(SHORT) as [keyof typeof SHORT, string][]) {
    if (settings[name] !== usual[name]) {
      link.set(short, String(settings[name]));
    }
  }
  if (settings.broadphase !== usual.broadphase) {
    link.set('broadphase', settings.broadphase);
  }
  if (!settings.sleep) {
    link.set('sleep', 'no');
  }
  if ([...settings.draw].sort().join() !== [...usual.draw].sort().join()) {
    link.set('draw', [...settings.draw].join(','));
  }
  if (settings.steps !== null) {
    link.set('steps', String(settings.steps));
  }
  return link.toString().replaceAll('%2C', ',');
}

/** The settings of such a part of a link; what is missing or makes no sense is as always. */
export function fromLink(text: string): Settings {
  const link = new URLSearchParams(text.replace(/^#/, ''));
  const settings = defaults(sceneOf(link.get('scene')).id);
  const number = (name: string): number => Number(link.get(name) || NaN);
  settings.speed = SPEEDS.includes(number('speed')) ? number('speed') : settings.speed;
  const gravity = (link.get('gravity') ?? '').split(',').map((part) => Number(part || NaN));
  if (gravity.length === 2 && gravity.every((part) => Math.abs(part) <= 100)) {
    settings.gravity = [gravity[0]!, gravity[1]!];
  }
  for (const [name, short] of Object.entries(SHORT) as [keyof typeof SHORT, string][]) {
    settings[name] = within(number(short), RANGES[name][0], RANGES[name][1]) ?? settings[name];
  }
  settings.broadphase = link.get('broadphase') === 'sweep' ? 'sweep' : 'tree';
  settings.sleep = link.get('sleep') !== 'no';
  settings.steps = within(number('steps'), 0, MAX_STEPS) ?? null;
  const draw = link.get('draw');
  if (draw !== null) {
    settings.draw = new Set(draw.split(',').filter((name): name is DrawOption => Object.hasOwn(DRAW_OPTIONS, name)));
  }
  return settings;
}

function within(value: number, least: number, most: number): number | undefined {
  return Number.isInteger(value) && value >= least && value <= most ? value : undefined;
}
