// A compiler with a standard library for wasm32-unknown-unknown, by the first way that works:
// it is there; rustup brings it; Debian's packages hold its source, from which it is built once.

import { ask, whereIs } from './shell.mjs';
import { busy, Missing } from './say.mjs';
import { isRoot, onDebian } from './debian.mjs';
import { canCompile, TARGET } from './wasm-trial.mjs';
import { buildForDebian, debianEnvironment, debianIsReady, findDebianClippy } from './wasm-target-debian.mjs';

/**
 * Adds to the environment of wasm builds what they need to find the target.
 * @param {import('../setup.mjs').Tools} tools
 * @returns {string}
 */
export function findTarget(tools) {
  if (canCompile('rustc')) return 'in the toolchain that is here';
  if (debianIsReady()) return useDebian(tools, 'built earlier from its source');

  if (whereIs('rustup')) {
    busy('wasm32 target', `rustup target add ${TARGET}`);
    if (ask('rustup', ['target', 'add', TARGET]).ok && canCompile('rustc')) return 'added by rustup';
  }
  if (onDebian() && isRoot()) {
    buildForDebian();
    return useDebian(tools, 'built now from its source');
  }
  throw new Missing(
    `"rustup target add ${TARGET}" brought nothing, and nothing else can be done here. Needed is either rustup with a` +
      ' network that reaches static.rust-lang.org, or Debian with root, where this script builds it from packages.',
  );
}

/** @param {import('../setup.mjs').Tools} tools @param {string} how */
function useDebian(tools, how) {
  const { version, environment } = debianEnvironment();
  tools.wasm = { ...tools.wasm, ...environment };
  tools.debian = true;
  return `Debian's ${version}, standard library ${how}`;
}

/** Clippy of the very compiler that wasm builds use. @param {import('../setup.mjs').Tools} tools */
export function findTargetClippy(tools) {
  if (tools.debian) findDebianClippy();
  const { ok, out, all } = ask('cargo', ['clippy', '--version'], { env: tools.wasm });
  if (!ok) throw new Missing(`cargo clippy does not run for ${TARGET}:\n${all}`);
  return out;
}
