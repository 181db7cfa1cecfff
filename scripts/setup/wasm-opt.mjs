// Binaryen's optimizer, from npm: the build finds it first on PATH.

import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { Missing } from './say.mjs';
import { ROOT } from './root.mjs';

/** @returns {string} */
export function findWasmOpt() {
  const folder = join(ROOT, 'node_modules');
  if (!existsSync(join(folder, '.bin', 'wasm-opt'))) {
    throw new Missing('the npm package binaryen has not put it into node_modules/.bin: remove node_modules and try again');
  }
  return `${JSON.parse(readFileSync(join(folder, 'binaryen', 'package.json'), 'utf8')).version}, of the npm packages`;
}
