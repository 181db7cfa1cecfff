// Serves the page for a look and for work on it: what is changed in www/ shows at once.

import { ensureModule } from './build-wasm.mjs';
import { end, run } from './setup/run.mjs';
import { setUp } from './setup.mjs';

try {
  const tools = setUp('module');
  ensureModule(tools);
  console.log('\nOpen the address below in a browser. Ctrl+C ends.');
  run('vite', process.argv.slice(2), tools.native);
} catch (error) {
  end(error);
}
