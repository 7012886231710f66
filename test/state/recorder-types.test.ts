import { expect, expectTypeOf, it } from 'vitest';
import { phys2D, type Vec2 } from '../../src/index.js';
import { Recorder } from '../../src/state/index.js';
import { plainBody, weightless } from '../conformance/setting.js';

it('methods of one and of two signatures are called with the arguments of either', () => {
  const world = weightless();
  const body = plainBody({ velocity: [1, 2] });
  world.addRigidBody(body);
  const recorder = new Recorder(world);
  const velocity = recorder.call(body, 'getVelocity');
  expectTypeOf<Vec2>().toExtend<typeof velocity>();
  expect(velocity).toEqual([1, 2]);
  const target = [0, 0];
  expect(recorder.call(body, 'getVelocity', target)).toBe(target);
  expect(recorder.call(body, 'transformLocalPointToWorld', [1, 0])).toEqual([1, 0]);
  recorder.call(body, 'applyImpulse', [0, -5]);
  expectTypeOf(recorder.call(world, 'addRigidBody', phys2D.createRigidBody())).toEqualTypeOf<boolean>();
  // @ts-expect-error: an impulse is needed
  expect(() => recorder.call(body, 'applyImpulse')).toThrow('applyImpulse');
  // @ts-expect-error: a list of two numbers
  expect(() => recorder.call(body, 'setVelocity', 3)).toThrow('velocity');
});
