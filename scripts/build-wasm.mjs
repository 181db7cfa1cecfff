// Builds the crate into www/pkg/: shimmy.js, shimmy_bg.wasm, shimmy.d.ts.

import { readdirSync, statSync, utimesSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { ROOT } from './setup/root.mjs';
import { end, run } from './setup/run.mjs';
import { found } from './setup/say.mjs';
import { setUp } from './setup.mjs';

const SOURCES = ['src', 'Cargo.toml', 'Cargo.lock', '.cargo/config.toml'];

/** Put there when a build is whole, with the time it began: a half-done one counts as none. */
const STAMP = join(ROOT, 'www', 'pkg', '.built');

/** @param {import('./setup.mjs').Tools} tools */
export function buildModule({ wasm }) {
  const began = new Date();
  // no-install: all that wasm-pack would download, the set-up has found.
  run('wasm-pack', ['--log-level', 'error', 'build', '--mode', 'no-install', '--target', 'web', '--no-pack', '--out-dir', 'www/pkg'], wasm);
  writeFileSync(STAMP, '');
  utimesSync(STAMP, began, began);
}

/** Builds only when a source is newer than the module. @param {import('./setup.mjs').Tools} tools */
export function ensureModule(tools) {
  const built = statSync(STAMP, { throwIfNoEntry: false })?.mtimeMs ?? 0;
  if (SOURCES.some((source) => newest(join(ROOT, source)) > built)) buildModule(tools);
  else found('WebAssembly module', 'www/pkg is newer than its sources');
}

/** The time of the last change in a file or folder; a folder's own time tells of files gone. @param {string} path @returns {number} */
function newest(path) {
  const { mtimeMs } = statSync(path);
  if (!statSync(path).isDirectory()) return mtimeMs;
  return Math.max(mtimeMs, ...readdirSync(path).map((name) => newest(join(path, name))));
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  try {
    buildModule(setUp('module'));
  } catch (error) {
    end(error);
  }
}
