import * as names from './index.js';
import { Physics2DDevice } from './index.js';

const { default: phys2D, ...classes } = names;

/** The one global of the script tag: a device with every public name as a property. */
export default Object.assign(Physics2DDevice.create(), classes, { phys2D });
