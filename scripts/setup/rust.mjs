// The Rust toolchain, and the parts of it that the checks need.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { ask, whereIs } from './shell.mjs';
import { busy, Missing } from './say.mjs';
import { ROOT } from './root.mjs';

/** @returns {string} */
export function findRust() {
  if (!whereIs('cargo') || !whereIs('rustc')) {
    throw new Missing('cargo and rustc are not on PATH: install them from https://rustup.rs and open a new shell');
  }
  const { ok, out, all } = ask('rustc', ['--version']);
  if (!ok) throw new Missing(`rustc does not run (rustup default stable would give it a toolchain):\n${all}`);

  const wanted = readFileSync(join(ROOT, 'Cargo.toml'), 'utf8').match(/^rust-version = "(.+)"/m)?.[1] ?? '0';
  const here = out.split(' ')[1];
  if (here.localeCompare(wanted, 'en', { numeric: true }) < 0) {
    throw new Missing(`${here} is here and ${wanted} or later is needed: rustup update stable`);
  }
  return out;
}

/** rustfmt and clippy, for natives builds. @returns {string} */
export function findRustChecks() {
  for (const component of ['rustfmt', 'clippy']) {
    const command = component === 'clippy' ? 'clippy' : 'fmt';
    if (ask('cargo', [command, '--version']).ok) continue;
    busy('Rust checks', `rustup component add ${component}`);
    if (!ask('rustup', ['component', 'add', component]).ok) {
      throw new Missing(`cargo ${command} is missing: rustup component add ${component}`);
    }
  }
  return `${ask('cargo', ['fmt', '--version']).out}, ${ask('cargo', ['clippy', '--version']).out}`;
}
