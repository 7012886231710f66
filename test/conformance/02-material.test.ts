import { expect, it } from 'vitest';
import { phys2D } from '../../src/index.js';

it('C-008 a material keeps what it is given, and has defaults for the rest', () => {
  const userData = { name: 'steel' };
  const material = phys2D.createMaterial({
    elasticity: 0.3,
    staticFriction: 4,
    dynamicFriction: 3,
    rollingFriction: 0.1,
    density: 7,
    userData,
  });
  expect([
    material.getElasticity(),
    material.getStaticFriction(),
    material.getDynamicFriction(),
    material.getRollingFriction(),
    material.getDensity(),
  ]).toEqual([0.3, 4, 3, 0.1, 7]);
  expect(material.userData).toBe(userData);
  const plain = phys2D.createMaterial({ density: 2 });
  expect([plain.getElasticity(), plain.getStaticFriction(), plain.getDensity()]).toEqual([0, 2, 2]);
  expect(phys2D.createMaterial({ userData: 0 }).userData).toBe(0);
});
