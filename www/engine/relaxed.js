/**
 * The module for ensembles: the one with relaxed SIMD, which multiplies and adds in one step, where the browser has that and
 * the page is a site. Its numbers differ from the other one's by rounding alone.
 */

import { compile, compiledEngine } from './engine.js';
import { hasRelaxedSimd } from './relaxed-simd.js';

/** @type {Promise<WebAssembly.Module> | null} */
let compiling = null;

/** The module, compiled once; what cannot be had, as on a visit without a network, is made up for by the page's own. */
export function compiledForEnsembles() {
  compiling ??= relaxed().catch(() => compiledEngine());
  return compiling;
}

async function relaxed() {
  if (import.meta.env.MODE === 'single-file' || !hasRelaxedSimd()) return compiledEngine();
  const { default: address } = await import('../pkg/shimmy_relaxed.wasm?url');
  return compile(address);
}
