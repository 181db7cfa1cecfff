// The built module in Node.js, as a script of anybody's would load it.

import { readFile } from 'node:fs/promises';
import init, * as shimmy from '../../www/pkg/shimmy.js';

await init({ module_or_path: await readFile(new URL('../../www/pkg/shimmy_bg.wasm', import.meta.url)) });

export { shimmy };

/** The run that everything else is a variation of: it shimmies. */
export const SHIMMY = {
  model: 'torsional',
  parameters: { velocity: 80, dampingConstant: 20 },
  initial: { torsionAngle: 0.05 },
};

/** Names of the states, in their order. */
export const STATES = /** @type {const} */ (['torsionAngle', 'torsionRate', 'lateralDeformation']);

/** The error that a call throws; no error is one, too. @param {() => unknown} call @returns {any} */
export function refusal(call) {
  try {
    call();
  } catch (error) {
    return error;
  }
  throw new Error('the call was not refused');
}
