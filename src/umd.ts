import * as audit from './audit/index.js';
import * as debug from './debug/index.js';
import * as names from './index.js';
import { Physics2DDevice } from './index.js';
import * as outline from './outline/index.js';
import * as runner from './runner.js';
import * as state from './state/index.js';

// The device has a `createWorld` of its own, whose worlds can be saved.
const { default: phys2D, createWorld: _, ...classes } = names;

/** The one global of the script tag: a device with every public name as a property. */
export default Object.assign(Physics2DDevice.create(), classes, debug, outline, runner, audit, state, { phys2D });
