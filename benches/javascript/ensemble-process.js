// A process with an instance of its own, which does the ensemble as often as it is told.

import { readFile } from 'node:fs/promises';

import * as shimmy from '../../www/pkg/shimmy.js';

import { work } from './ensembles.js';

shimmy.initSync({ module: await readFile(new URL('../../www/pkg/shimmy_bg.wasm', import.meta.url)) });
process.on('message', (/** @type {number} */ times) => {
  work(shimmy, times);
  process.send?.('done');
});
