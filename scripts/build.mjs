// Builds dist/: the static site, and shimmy.html, the same page as one file that opens from a double-click.

import { pathToFileURL } from 'node:url';
import { ensureModule } from './build-wasm.mjs';
import { end, run } from './setup/run.mjs';
import { setUp } from './setup.mjs';

/** Bundles the page around the module that is there. @param {import('./setup.mjs').Tools} tools */
export function bundlePage({ native }) {
  run('vite', ['build', '--mode', 'site'], native);
  run('vite', ['build', '--mode', 'single-file'], native);
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
