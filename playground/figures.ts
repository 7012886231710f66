import { byId, make } from './elements.js';
import type { Simulation } from './simulation.js';

const ROWS = {
  steps: 'Steps',
  bodies: 'Bodies',
  awake: 'Awake',
  constraints: 'Constraints',
  contacts: 'Contacts',
  hash: 'State hash',
} as const;

/** What is in the world, as numbers. */
export class Figures {
  private readonly values = new Map<string, HTMLElement>();

  constructor() {
    const list = byId('figures');
    for (const [name, label] of Object.entries(ROWS)) {
      const value = make('dd', { id: name });
      this.values.set(name, value);
      list.append(make('dt', {}, label), value);
    }
  }

  /** Worth the time some times a second. */
  show(simulation: Simulation): void {
    const { world } = simulation;
    let contacts = 0;
    for (const arbiters of [world.dynamicArbiters, world.staticArbiters]) {
      for (const arbiter of arbiters) {
        contacts += arbiter.active ? arbiter.contacts.length : 0;
      }
    }
    const set = (name: keyof typeof ROWS, text: string | number): void => {
      this.values.get(name)!.textContent = typeof text === 'number' ? text.toLocaleString('en') : text;
    };
    set('steps', simulation.steps);
    set('bodies', world.rigidBodies.length);
    set('awake', world.liveDynamics.length);
    set('constraints', world.constraints.length);
    set('contacts', contacts);
    set('hash', simulation.hash());
    this.values.get('hash')!.title = simulation.touched
      ? 'Of the state of all bodies. A hand was in it, so the link alone does not give it.'
      : 'Of the state of all bodies. The link gives the same after as many steps.';
  }
}
