// The versions of the tools that no lock file of ours names.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { ROOT } from './root.mjs';

export const WASM_PACK = '0.15.1';
export const GECKODRIVER = '0.37.1';
/** They go together, on Python 3.11 and later. */
export const NUMPY = '2.4.6';
export const SCIPY = '1.17.1';

/** wasm-bindgen's command must be of the version of the crate, which Cargo.toml pins. */
export function wasmBindgen() {
  const version = readFileSync(join(ROOT, 'Cargo.toml'), 'utf8').match(/^wasm-bindgen = "=(.+)"/m)?.[1];
  if (!version) throw new Error('Cargo.toml pins no version of wasm-bindgen');
  return version;
}
