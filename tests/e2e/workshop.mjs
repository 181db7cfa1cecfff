// The page's own modules, one by one in a browser, as the development server gives them: for tests that hold a part
// in the hand.

import { fileURLToPath } from 'node:url';
import { createServer } from 'vite';

const root = fileURLToPath(new URL('../../', import.meta.url));

/** @returns {Promise<{ address: string, close: () => Promise<void> }>} */
export async function openWorkshop() {
  const server = await createServer({
    configFile: `${root}vite.config.js`,
    root: `${root}www`,
    logLevel: 'error',
    server: { port: 0, host: '127.0.0.1', hmr: false, fs: { strict: false } },
    cacheDir: `${root}target/workshop`,
  });
  await server.listen();
  const { port } = /** @type {import('node:net').AddressInfo} */ (server.httpServer?.address());
  return { address: `http://127.0.0.1:${port}/`, close: () => server.close() };
}
