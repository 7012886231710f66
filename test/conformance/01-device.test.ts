import { describe, expect, it } from 'vitest';
import { Physics2DDevice, phys2D } from '../../src/index.js';
import { near } from './setting.js';

describe('device and vertex helpers', () => {
  it('C-001 a device has a version and a vendor', () => {
    const device = Physics2DDevice.create();
    expect(Physics2DDevice.version).toBe(1);
    expect(typeof device.vendor).toBe('string');
  });

  it('C-002 box vertices go clockwise from the upper left', () => {
    expect(phys2D.createBoxVertices(4, 2)).toEqual([
      [-2, -1],
      [2, -1],
      [2, 1],
      [-2, 1],
    ]);
  });

  it('C-003 rectangle corners may be given in any order', () => {
    const expected = [
      [1, 2],
      [5, 2],
      [5, 8],
      [1, 8],
    ];
    expect(phys2D.createRectangleVertices(1, 2, 5, 8)).toEqual(expected);
    expect(phys2D.createRectangleVertices(5, 8, 1, 2)).toEqual(expected);
  });

  it('C-004 regular polygons start on the x-axis; all helpers go clockwise', () => {
    const vertices = phys2D.createRegularPolygonVertices(2, 4, 4);
    near(vertices.flat(), [1, 0, 0, 2, -1, 0, 0, -2]);
    for (const list of [vertices, phys2D.createBoxVertices(1, 2), phys2D.createRectangleVertices(3, 1, 0, 0)]) {
      expect(phys2D.createPolygonShape({ vertices: list }).computeArea()).toBeGreaterThan(0);
    }
  });

  it('C-005 there is one default material', () => {
    expect(phys2D.getDefaultMaterial()).toBe(phys2D.getDefaultMaterial());
    expect(Physics2DDevice.create().getDefaultMaterial()).toBe(phys2D.getDefaultMaterial());
  });

  it('C-006 the default material has the default values exactly', () => {
    const material = phys2D.getDefaultMaterial();
    expect([
      material.getElasticity(),
      material.getStaticFriction(),
      material.getDynamicFriction(),
      material.getRollingFriction(),
      material.getDensity(),
      material.userData,
    ]).toEqual([0, 2, 1, 0.005, 1, null]);
  });

  it('C-007 worlds and bodies need no options', () => {
    expect(phys2D.createWorld().getGravity()).toEqual([0, 10]);
    expect(phys2D.createRigidBody().isDynamic()).toBe(true);
  });
});
