// Programs that cargo builds: wasm-pack, wasm-bindgen, geckodriver.

import { ask, whereIs } from './shell.mjs';
import { busy, Missing, tail } from './say.mjs';
import { OWN_TOOLS } from './environment.mjs';
import { wasmBindgen, WASM_PACK } from './pins.mjs';

/** @param {import('../setup.mjs').Tools} tools */
export const findWasmPack = (tools) => cargoTool(tools, 'wasm-pack', 'wasm-pack', WASM_PACK, ['--locked'], 2);

/**
 * Not --locked: the lock file of this crate names a version that the registry no longer serves.
 * @param {import('../setup.mjs').Tools} tools
 */
export const findWasmBindgen = (tools) => cargoTool(tools, 'wasm-bindgen', 'wasm-bindgen-cli', wasmBindgen(), [], 3);

/**
 * The version wanted, built by cargo where it is not there.
 * @param {import('../setup.mjs').Tools} tools
 * @param {string} program
 * @param {string} crate
 * @param {string} version
 * @param {string[]} options
 * @param {number} minutes  how long it takes on a small machine
 */
export function cargoTool(tools, program, crate, version, options, minutes) {
  const path = whereIs(program, tools.wasm);
  const here = path && versionOf(path);
  if (here === version) return here;

  busy(program, `cargo install ${crate} --version ${version}, about ${minutes} minutes`);
  const place = here ? ['--root', OWN_TOOLS] : [];
  const { ok, all } = ask('cargo', ['install', crate, '--version', version, ...options, ...place]);
  if (!ok) throw new Missing(`cargo install ${crate} --version ${version} failed:\n${tail(all)}`);
  return `${version}, built now${here ? ` beside ${here}, which stays` : ''}`;
}

/** @param {string} path */
const versionOf = (path) => ask(path, ['--version']).out.match(/\d+\.\d+\.\d+/)?.[0];
