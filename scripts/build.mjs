// Builds dist/: the static site, and shimmy.html, the same page as one file that opens from a double-click.

import { statSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { ensureModule, newest } from './build-wasm.mjs';
import { ROOT } from './setup/root.mjs';
import { end, run } from './setup/run.mjs';
import { found } from './setup/say.mjs';
import { setUp } from './setup.mjs';

/** Bundles the page around the module that is there. @param {import('./setup.mjs').Tools} tools */
export function bundlePage({ native }) {
  run('vite', ['build', '--mode', 'site'], native);
  run('vite', ['build', '--mode', 'single-file'], native);
}

/** Builds only when a source is newer than what was built last. @param {import('./setup.mjs').Tools} tools */
export function ensureBundle(tools) {
  ensureModule(tools);
  const built = statSync(join(ROOT, 'dist', 'shimmy.html'), { throwIfNoEntry: false })?.mtimeMs ?? 0;
  const isOld = ['www', 'vite.config.js', 'scripts/bundle', 'package-lock.json'].some((source) => newest(join(ROOT, source)) > built);
  if (isOld) bundlePage(tools);
  else found('page', 'dist/ is newer than its sources');
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  try {
    const tools = setUp('module');
    ensureModule(tools);
    bundlePage(tools);
  } catch (error) {
    end(error);
  }
}
