// Serves the page for a look and for work on it: what is changed in www/ shows at once.
// npm start -- --port 8080 --host 0.0.0.0

import { parseArgs } from 'node:util';
import { ensureModule } from './build-wasm.mjs';
import { ROOT } from './setup/root.mjs';
import { end } from './setup/run.mjs';
import { setUp } from './setup.mjs';

const { port, host } = parseArgs({ options: { port: { type: 'string' }, host: { type: 'string' } } }).values;
try {
  ensureModule(setUp('module'));
} catch (error) {
  end(error);
}

// Only now, because the set-up may just have installed it. It takes up vite.config.js, and another port where one is taken.
const { createServer } = await import('vite');
process.chdir(ROOT);
const server = await createServer({ server: { host, port: port ? Number(port) : undefined } });
await server.listen();
console.log('\nOpen this address in a browser; Ctrl+C ends.');
server.printUrls();

// npm runs us in a shell that passes no signal on: when it is gone, we go.
const shell = process.ppid;
if (process.env.npm_lifecycle_event) setInterval(() => process.ppid === shell || process.exit(), 500).unref();
