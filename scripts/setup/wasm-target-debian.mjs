// Debian's compiler comes with no standard library for wasm32-unknown-unknown, but with its source.
// Versions and paths are read from the packages: Debian's security suite moves on.

import { copyFileSync, cpSync, mkdirSync, mkdtempSync, readdirSync, renameSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { ask, whereIs } from './shell.mjs';
import { busy, Missing, tail } from './say.mjs';
import { install, isRoot, onDebian, packageFile, packageVersion } from './debian.mjs';
import { canCompile, TARGET } from './wasm-trial.mjs';

const STEP = 'wasm32 target';
const TOOLCHAIN = 'debian';

/** Debian's compiler. */
const compiler = () => packageFile('rustc-web', '/bin/rustc');

/** The major version of the compiler's LLVM, which the linker's must equal. @param {string} rustc */
const llvmOf = (rustc) => ask(rustc, ['--version', '--verbose']).out.match(/^LLVM version: (\d+)/m)?.[1];

/** @param {string} rustc */
const linkerOf = (rustc) => `wasm-ld-${llvmOf(rustc)}`;

/** Whether an earlier run has built and installed everything. */
export const debianIsReady = () =>
  onDebian() && packageVersion('rustc-web') !== null && canCompile(compiler(), linkerOf(compiler()));

/** Clippy for Debian's compiler. */
export const findDebianClippy = () => need('rust-web-clippy');

/** What cargo has to be told to use this compiler; by a toolchain of rustup where there is rustup. */
export function debianEnvironment() {
  const rustc = compiler();
  const version = ask(rustc, ['--version']).out.replace(/ \(.*/, '');
  const linker = { CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER: linkerOf(rustc) };
  if (!whereIs('rustup')) return { version, environment: { ...linker, RUSTC: rustc } };

  if (ask('rustup', ['which', '--toolchain', TOOLCHAIN, 'rustc']).out !== rustc) {
    const { ok, all } = ask('rustup', ['toolchain', 'link', TOOLCHAIN, ask(rustc, ['--print', 'sysroot']).out]);
    if (!ok) throw new Missing(`rustup toolchain link ${TOOLCHAIN} failed:\n${tail(all)}`);
  }
  return { version, environment: { ...linker, RUSTUP_TOOLCHAIN: TOOLCHAIN } };
}

/** Installs compiler, source and linker, and builds the standard library once. */
export function buildForDebian() {
  need('rustc-web', 'rust-web-src');
  const rustc = compiler();
  if (!whereIs(linkerOf(rustc))) need(`lld-${llvmOf(rustc)}`);
  if (canCompile(rustc, linkerOf(rustc))) return;

  busy(STEP, "building the standard library from Debian's source, about a minute");
  const library = dirname(dirname(packageFile('rust-web-src', '/library/sysroot/Cargo.toml')));
  const scratch = mkdtempSync(join(tmpdir(), 'wasm32-std-'));
  try {
    putInPlace(compile(library, scratch, rustc), rustc);
  } finally {
    rmSync(scratch, { recursive: true, force: true });
  }
  if (!canCompile(rustc, linkerOf(rustc))) throw new Missing(`${rustc} refuses the standard library just built for ${TARGET}`);
}

/** Packages, of one and the same version where they are of the compiler. @param {...string} names */
function need(...names) {
  const versions = names.map(packageVersion);
  if (versions.every((version) => version !== null && version === versions[0])) return;
  if (!isRoot()) throw new Missing(`Debian's packages are needed; as root: apt-get install ${names.join(' ')}`);
  busy(STEP, `apt-get install ${names.join(' ')}`);
  install(names);
}

/**
 * The folder with the compiled libraries.
 * @param {string} library
 * @param {string} scratch
 * @param {string} rustc
 */
function compile(library, scratch, rustc) {
  // The vendored crates stay behind: they lack a dev-dependency that the lock file names, and the registry has it.
  const copy = join(scratch, 'library');
  cpSync(library, copy, { recursive: true, filter: (path) => path !== join(library, 'vendor') });

  const args = ['build', '--release', '--target', TARGET, '--features', 'compiler-builtins-mem', '--target-dir', scratch];
  // As the compiler's own build has it: the library may use what is unstable, and carries bitcode to optimize across.
  const env = {
    ...process.env,
    RUSTC: rustc,
    RUSTC_BOOTSTRAP: '1',
    __CARGO_DEFAULT_LIB_METADATA: 'sysroot',
    RUSTFLAGS: '-Zforce-unstable-if-unmarked -Cembed-bitcode=yes',
  };
  const { ok, all } = ask('cargo', args, { cwd: join(copy, 'sysroot'), env });
  if (!ok) throw new Missing(`the standard library did not build:\n${tail(all)}`);
  return join(scratch, TARGET, 'release', 'deps');
}

/** To where the compiler looks, in place of what an earlier version left. @param {string} built @param {string} rustc */
function putInPlace(built, rustc) {
  const place = ask(rustc, ['--print', 'target-libdir', '--target', TARGET]).out;
  const next = `${place}.next`;
  rmSync(next, { recursive: true, force: true });
  mkdirSync(next, { recursive: true });
  for (const name of readdirSync(built)) {
    if (name.endsWith('.rlib')) copyFileSync(join(built, name), join(next, name));
  }
  rmSync(place, { recursive: true, force: true });
  renameSync(next, place);
}
