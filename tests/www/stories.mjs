// The page without its elements, over the real engine, as it opens; and stories of presets and figures for the tests.

import { readFile } from 'node:fs/promises';
import init, * as module from '../../www/pkg/shimmy.js';
import { App } from '../../www/app.js';
import { askedInNames } from '../../www/engine/fitted.js';

await init({ module_or_path: await readFile(new URL('../../www/pkg/shimmy_bg.wasm', import.meta.url)) });

/** As the page asks it. */
export const engine = askedInNames(module);

/** @param {string} [address] */
export function openedApp(address = '') {
  const app = new App();
  app.open(engine, [address], { isStill: false });
  return app;
}

/** @param {App} app */
export function sessionOf(app) {
  if (!app.session) throw new Error('no session');
  return app.session;
}
