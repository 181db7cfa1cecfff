// The proof that a compiler can make WebAssembly: it makes some.

import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { ask, whereIs } from './shell.mjs';

export const TARGET = 'wasm32-unknown-unknown';

/**
 * Whether compiler, linker and standard library for the target are there and fit together: a library made by another
 * version would be refused.
 * @param {string} rustc
 * @param {string} [linker]  where the compiler has none of its own
 */
export function canCompile(rustc, linker) {
  if (whereIs(rustc) === null) return false;
  const scratch = mkdtempSync(join(tmpdir(), 'wasm32-trial-'));
  const args = ['-', '--crate-name=trial', '--crate-type=cdylib', `--target=${TARGET}`, '-o', join(scratch, 'trial.wasm')];
  if (linker) args.push(`-Clinker=${linker}`);
  try {
    return ask(rustc, args, { input: 'pub fn trial() -> String { String::new() }' }).ok;
  } finally {
    rmSync(scratch, { recursive: true, force: true });
  }
}
