// The environment that builds run in.

import { homedir } from 'node:os';
import { delimiter, join } from 'node:path';
import { ROOT } from './root.mjs';

/** Where a tool goes that is here in another version, which may serve another project. */
export const OWN_TOOLS = join(ROOT, 'target', 'tools');

/**
 * Our own tools first: another wasm-opt on PATH may be one whose output dies at start (Debian's 108 does so).
 * Cargo's programs last: cargo's folder need not be on PATH.
 * @returns {NodeJS.ProcessEnv}
 */
export function buildEnvironment() {
  const cargo = process.env.CARGO_HOME ?? join(homedir(), '.cargo');
  const folders = [join(OWN_TOOLS, 'bin'), join(ROOT, 'node_modules', '.bin'), process.env.PATH, join(cargo, 'bin')];
  /** @type {NodeJS.ProcessEnv} */
  const env = { ...process.env, PATH: folders.join(delimiter) };
  for (const name of flagsThatReplaceOurs()) delete env[name];
  return env;
}

/** Exported flags silently replace those of .cargo/config.toml, so builds leave them out. */
export const flagsThatReplaceOurs = () => ['RUSTFLAGS', 'CARGO_ENCODED_RUSTFLAGS'].filter((name) => process.env[name]);
