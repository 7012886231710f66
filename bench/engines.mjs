// The engines: how each is loaded, and what package it is; extra ones take part only if they are named. Adapters are loaded only when
// asked for, one in a process.
import { readFileSync } from 'node:fs';

const box2dFlavour = (name) => import(`./node_modules/box2d3-wasm/build/dist/es/${name}/Box2D.${name}.mjs`);

export const engines = {
  phys2d: { load: async () => (await import('../dist/phys2d.js')).phys2D },
  'phys2d-plain': {
    title: 'phys2d, plain',
    isExtra: true,
    load: async () => {
      const { createWorld, phys2D, worldState } = await import('../dist/phys2d.js');
      return Object.assign(Object.create(phys2D), {
        createWorld: (params) => createWorld({ ...params, state: worldState }),
      });
    },
  },
  Box2D: {
    title: 'Box2D SIMD',
    package: 'box2d3-wasm',
    flavour: 'deluxe',
    load: async () => (await import('./box2d.mjs')).box2d(await box2dFlavour('deluxe')),
  },
  'Box2D-scalar': {
    title: 'Box2D scalar',
    package: 'box2d3-wasm',
    flavour: 'compat',
    load: async () => (await import('./box2d.mjs')).box2d(await box2dFlavour('compat')),
  },
  'Box2D-fine': {
    title: 'Box2D SIMD, 16 sub-steps',
    package: 'box2d3-wasm',
    flavour: 'deluxe',
    isExtra: true,
    load: async () => (await import('./box2d.mjs')).box2d(await box2dFlavour('deluxe'), 16),
  },
  'Rapier-SIMD': {
    title: 'Rapier SIMD',
    package: '@dimforge/rapier2d-simd-compat',
    load: async () => (await import('./rapier.mjs')).rapier(await import('@dimforge/rapier2d-simd-compat')),
  },
  Rapier: {
    package: '@dimforge/rapier2d-compat',
    load: async () => (await import('./rapier.mjs')).rapier(await import('@dimforge/rapier2d-compat')),
  },
  planck: { package: 'planck', load: async () => (await import('./planck.mjs')).planck },
  'planck-discrete': {
    title: 'planck, discrete',
    package: 'planck',
    isExtra: true,
    load: async () => (await import('./planck.mjs')).planckDiscrete,
  },
  'phaser-box2d': { package: 'phaser-box2d', load: async () => (await import('./phaser.mjs')).phaser },
  'matter-js': { package: 'matter-js', load: async () => (await import('./matter.mjs')).matter },
  'p2-es': { package: 'p2-es', load: async () => (await import('./p2.mjs')).p2es },
};

/** Those that take part if none is named. */
export const usual = Object.keys(engines).filter((name) => !engines[name].isExtra);

/** The version of an engine, and of what flavour it is. */
export function versionOf(name) {
  const { package: owner, flavour } = engines[name];
  const path = owner === undefined ? '../package.json' : `node_modules/${owner}/package.json`;
  const { version } = JSON.parse(readFileSync(new URL(path, import.meta.url), 'utf8'));
  const notes = [owner !== undefined && owner !== name ? owner : '', flavour ? `flavour ${flavour}` : ''];
  const note = notes.filter(Boolean).join(', ');
  return note === '' ? version : `${version} (${note})`;
}
