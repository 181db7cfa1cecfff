// Builds the crate into www/pkg/: shimmy.js, shimmy_bg.wasm, shimmy.d.ts.

import { copyFileSync, mkdirSync, readdirSync, readFileSync, renameSync, rmSync, statSync, utimesSync, writeFileSync } from 'node:fs';
import { homedir } from 'node:os';
import { join, sep } from 'node:path';
import { pathToFileURL } from 'node:url';
import { ROOT } from './setup/root.mjs';
import { end, run } from './setup/run.mjs';
import { found } from './setup/say.mjs';
import { TARGET } from './setup/wasm-trial.mjs';
import { setUp } from './setup.mjs';

const SOURCES = ['src', 'Cargo.toml', 'Cargo.lock', '.cargo/config.toml'];

const MODULE = join(ROOT, 'www', 'pkg');
const STAMP = join(MODULE, '.built');

/** Builds aside and swaps the folder when it is whole, so that nobody loads half a module. @param {import('./setup.mjs').Tools} tools */
export function buildModule({ wasm }) {
  const began = new Date();
  const aside = join(ROOT, 'target', `pkg-${process.pid}`);
  try {
    // no-install: all that wasm-pack would download, the set-up has found.
    const build = ['build', moduleAlone(), '--mode', 'no-install', '--target', 'web', '--no-pack', '--out-dir', aside, '--', '--locked', '--config', withoutPaths(wasm)];
    run('wasm-pack', ['--log-level', 'error', ...build], { CARGO_TARGET_DIR: join(ROOT, 'target'), ...wasm });
    rmSync(MODULE, { recursive: true, force: true });
    renameSync(aside, MODULE);
  } finally {
    rmSync(aside, { recursive: true, force: true });
  }
  // As old as the sources it was made from: what changed during the build is newer.
  writeFileSync(STAMP, '');
  utimesSync(STAMP, began, began);
}

/**
 * The crate once more, as a module alone: where a library is built for Rust as well, cargo leaves out optimising across
 * crates, which is a tenth of the module.
 * @returns {string} its folder
 */
function moduleAlone() {
  const folder = join(ROOT, 'target', 'module');
  const manifest = readFileSync(join(ROOT, 'Cargo.toml'), 'utf8');
  const both = 'crate-type = ["cdylib", "rlib"]';
  if (!manifest.includes(both)) throw new Error(`Cargo.toml has no line ${both}`);
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(folder, 'Cargo.toml'), manifest.replace(both, `path = ${JSON.stringify(join(ROOT, 'src', 'lib.rs'))}\ncrate-type = ["cdylib"]`));
  copyFileSync(join(ROOT, 'Cargo.lock'), join(folder, 'Cargo.lock'));
  return folder;
}

/**
 * Panics name their file: without the folders of the machine that built the module, which are nobody's business and bytes.
 * @param {NodeJS.ProcessEnv} env
 * @returns {string} a setting of cargo's; it adds to the flags of .cargo/config.toml
 */
function withoutPaths(env) {
  const folders = [ROOT, join(env.CARGO_HOME ?? join(homedir(), '.cargo'), 'registry', 'src')];
  const flags = folders.map((folder) => `--remap-path-prefix=${folder.replace(/[\\/]$/, '')}${sep}=`);
  return `target.${TARGET}.rustflags=${JSON.stringify(flags)}`;
}

/** Builds only when a source is newer than the module. @param {import('./setup.mjs').Tools} tools */
export function ensureModule(tools) {
  const built = statSync(STAMP, { throwIfNoEntry: false })?.mtimeMs ?? 0;
  if (SOURCES.some((source) => newest(join(ROOT, source)) > built)) buildModule(tools);
  else found('WebAssembly module', 'www/pkg is newer than its sources');
}

/** The time of the last change in a file or folder; a folder's own time tells of files gone. @param {string} path @returns {number} */
export function newest(path) {
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
