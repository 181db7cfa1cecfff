/// <reference types="vite/client" />
/**
 * Loads the WebAssembly module, once. The only file that imports it, beside the workers' own.
 *
 * @typedef {typeof import('../pkg/shimmy.js')} Engine
 * @typedef {import('../pkg/shimmy.js').Run} Run
 * @typedef {import('../pkg/shimmy.js').Simulator} Simulator
 * @typedef {import('../pkg/shimmy.js').Outlook} Outlook
 * @typedef {import('../pkg/shimmy.js').Model} Model
 * @typedef {import('../pkg/shimmy.js').Energy} Energy
 * @typedef {import('../pkg/shimmy.js').Columns} Columns
 * @typedef {import('../pkg/shimmy.js').Curves} Curves
 * @typedef {import('../pkg/shimmy.js').Forces} Forces
 * @typedef {import('../pkg/shimmy.js').ForceColumns} ForceColumns
 */

import init, * as engine from '../pkg/shimmy.js';
import { askedInNames } from './fitted.js';
import address from '../pkg/shimmy_bg.wasm?url';

/** @type {Promise<WebAssembly.Module> | null} */
let compiling = null;
/** @type {Promise<Engine> | null} */
let loading = null;

/** @returns {Promise<Engine>} */
export function loadEngine() {
  loading ??= compiledEngine().then(async (module) => {
    await init({ module_or_path: module });
    return askedInNames(engine);
  });
  return loading;
}

/** The engine where it is there already, as it is for whoever has drawn something of it. @returns {Engine} */
export function engineIfLoaded() {
  return engine;
}

/** The module itself, compiled once for this page and all its workers. */
export function compiledEngine() {
  compiling ??= compile(address);
  return compiling;
}

/** Compiles while the bytes arrive; a server that does not say `application/wasm` gets the slower way. @param {string} address */
export async function compile(address) {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`${response.status} ${response.statusText}`);
  const isStreamable = response.headers.get('content-type')?.startsWith('application/wasm');
  return isStreamable ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}
