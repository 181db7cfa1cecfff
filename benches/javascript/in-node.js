// Our module in Node: one line of JSON for each measurement.

import { readFile } from 'node:fs/promises';
import { setFlagsFromString } from 'node:v8';

import init, * as shimmy from '../../www/pkg/shimmy.js';

import { hasRelaxedSimd } from '../../www/engine/relaxed-simd.js';

import { branches } from './branches.js';
import { theCase } from './case.js';
import { ensembles } from './ensembles.js';
import { identifications } from './identification.js';
import { maps } from './maps.js';
import { ourEntry, warmUp, workAndPrecision } from './ours.js';

const place = `Node ${process.versions.node}`;

const module = await WebAssembly.compile(await readFile(new URL('../../www/pkg/shimmy_bg.wasm', import.meta.url)));
await init({ module_or_path: module });
console.log(JSON.stringify({ warmUp: { place, ...warmUp(shimmy, theCase) } }));
console.log(JSON.stringify(ourEntry(shimmy, theCase, place)));
for (const map of maps(shimmy, place)) console.log(JSON.stringify({ map }));
for (const branch of branches(shimmy, place)) console.log(JSON.stringify({ branch }));
for (const ensemble of await ensembles(shimmy, place, module, await relaxed())) console.log(JSON.stringify({ ensemble }));
for (const identification of identifications(shimmy, place)) console.log(JSON.stringify({ identification }));
if (!process.argv.includes('--quick')) {
  for (const row of workAndPrecision(shimmy, theCase)) console.log(JSON.stringify({ row }));
}

/** The module with relaxed SIMD: Node.js 20 knows that only where it is told to. */
async function relaxed() {
  if (!hasRelaxedSimd()) setFlagsFromString('--experimental-wasm-relaxed-simd');
  return hasRelaxedSimd() ? WebAssembly.compile(await readFile(new URL('../../www/pkg/shimmy_relaxed.wasm', import.meta.url))) : null;
}
