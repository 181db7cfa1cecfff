// Builds the crate into www/pkg/: shimmy.js, shimmy_bg.wasm, shimmy.d.ts; and shimmy_relaxed.wasm, the same module once more
// for browsers with relaxed SIMD, which ensembles take where it is there. shimmy.js serves both.

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
  const relaxed = `${aside}-relaxed`;
  try {
    packInto(aside, 'module', ['+simd128'], wasm);
    packInto(relaxed, 'relaxed', ['+simd128', '+relaxed-simd'], wasm);
    const [one, other] = [aside, relaxed].map((folder) => readFileSync(join(folder, 'shimmy.js'), 'utf8'));
    if (one !== other) throw new Error('the module with relaxed SIMD asks for another shimmy.js');
    copyFileSync(join(relaxed, 'shimmy_bg.wasm'), join(aside, 'shimmy_relaxed.wasm'));
    rmSync(MODULE, { recursive: true, force: true });
    renameSync(aside, MODULE);
  } finally {
    for (const folder of [aside, relaxed]) rmSync(folder, { recursive: true, force: true });
  }
  // As old as the sources it was made from: what changed during the build is newer.
  writeFileSync(STAMP, '');
  utimesSync(STAMP, began, began);
}

/**
 * Builds the module into a folder.
 * @param {string} out
 * @param {string} name of the folder that it is built in
 * @param {string[]} features of WebAssembly, beside those that any compiler takes for granted
 * @param {NodeJS.ProcessEnv} wasm
 */
function packInto(out, name, features, wasm) {
  // no-install: all that wasm-pack would download, the set-up has found.
  const build = ['build', moduleAlone(name, features), '--mode', 'no-install', '--target', 'web', '--no-pack', '--out-dir', out];
  run('wasm-pack', ['--log-level', 'error', ...build, '--', '--locked', '--config', flags(features, wasm)], { CARGO_TARGET_DIR: join(ROOT, 'target'), ...wasm });
}

/**
 * The crate once more, as a module alone: where a library is built for Rust as well, cargo leaves out optimising across
 * crates, which is a tenth of the module.
 * @param {string} name
 * @param {string[]} features
 * @returns {string} its folder
 */
function moduleAlone(name, features) {
  const folder = join(ROOT, 'target', name);
  const manifest = readFileSync(join(ROOT, 'Cargo.toml'), 'utf8');
  const replaced = (/** @type {string} */ text, /** @type {string} */ line, /** @type {string} */ by) => {
    if (!text.includes(line)) throw new Error(`Cargo.toml has no ${line}`);
    return text.replace(line, by);
  };
  const alone = replaced(manifest, 'crate-type = ["cdylib", "rlib"]', `path = ${JSON.stringify(join(ROOT, 'src', 'lib.rs'))}\ncrate-type = ["cdylib"]`);
  mkdirSync(folder, { recursive: true });
  const enabled = features.map((feature) => JSON.stringify(`--enable-${feature.slice(1).replace('simd128', 'simd')}`)).join(', ');
  writeFileSync(join(folder, 'Cargo.toml'), replaced(alone, '"--enable-simd"', enabled));
  copyFileSync(join(ROOT, 'Cargo.lock'), join(folder, 'Cargo.lock'));
  return folder;
}

/**
 * Panics name their file: without the folders of the machine that built the module, which are nobody's business and bytes.
 * @param {string[]} features
 * @param {NodeJS.ProcessEnv} env
 * @returns {string} a setting of cargo's; it adds to the flags of .cargo/config.toml
 */
function flags(features, env) {
  const folders = [ROOT, join(env.CARGO_HOME ?? join(homedir(), '.cargo'), 'registry', 'src')];
  const paths = folders.map((folder) => `--remap-path-prefix=${folder.replace(/[\\/]$/, '')}${sep}=`);
  return `target.${TARGET}.rustflags=${JSON.stringify([`-Ctarget-feature=${features.join(',')}`, ...paths])}`;
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
