// The proof that a compiler can make WebAssembly: it makes some.

import { ask, whereIs } from './shell.mjs';

export const TARGET = 'wasm32-unknown-unknown';

/**
 * Whether a compiler and its standard library for the target fit together: one of another version would refuse.
 * @param {string} rustc
 */
export function canCompile(rustc) {
  const args = ['-', '--crate-name=trial', '--crate-type=lib', '--emit=metadata', '-o', '-', `--target=${TARGET}`];
  return whereIs(rustc) !== null && ask(rustc, args, { input: 'pub fn trial() -> String { String::new() }' }).ok;
}
