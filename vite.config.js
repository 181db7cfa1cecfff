// Two bundles of one page. `site`: dist/, a static site for any server and any sub-path.
// `single-file`: dist/shimmy.html with everything inside, which opens from a double-click.

import { defineConfig } from 'vite';
import { viteSingleFile } from 'vite-plugin-singlefile';
import { contentSecurityPolicy } from './scripts/bundle/content-security-policy.js';
import { installable } from './scripts/bundle/installable.js';
import { notices } from './scripts/bundle/notices.js';
import { offline } from './scripts/bundle/offline.js';
import { openedFromFile } from './scripts/bundle/opened-from-file.js';
import { preloadEngine } from './scripts/bundle/preload-engine.js';

/** The site loads its own files; the single file has none. */
const OWN_FILES = Object.fromEntries(
  ['script-src', 'worker-src', 'connect-src', 'img-src', 'style-src', 'font-src', 'manifest-src'].map((kind) => [kind, "'self'"]),
);

export default defineConfig(({ mode }) => {
  const single = mode === 'single-file';
  return {
    root: 'www',
    base: './',
    // The fonts come from node_modules, beside the page's folder.
    server: { fs: { allow: ['..'] } },
    publicDir: single ? false : 'public',
    build: {
      outDir: '../dist',
      emptyOutDir: !single,
      modulePreload: { polyfill: false },
      reportCompressedSize: false,
    },
    // A worker of the single file starts from a blob:, where only a classic script runs in every browser.
    worker: { format: single ? 'iife' : 'es' },
    plugins: single
      ? [viteSingleFile({ outputFileName: 'shimmy.html' }), notices('comment'), contentSecurityPolicy()]
      : [openedFromFile(), preloadEngine(), installable(), notices('file'), contentSecurityPolicy(OWN_FILES), offline()],
  };
});
