import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import type * as source from '../../src/index.js';
import type * as state from '../../src/state/index.js';

/** The bundles as built, for what steps for long: unbundled, that takes five times as long. */
async function built(name: string): Promise<unknown> {
  return import(/* @vite-ignore */ pathToFileURL(join(import.meta.dirname, '../../dist', name)).href);
}

export const { phys2D } = (await built('phys2d.js')) as typeof source;
export const { serialize, deserialize, Recorder, replay } = (await built('state.js')) as typeof state;
