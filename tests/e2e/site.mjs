// The built page in the two places where it must work: from a server under a sub-path, and from a double-click.

import { createReadStream, existsSync } from 'node:fs';
import { createServer } from 'node:http';
import { extname, join, normalize } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

export const dist = fileURLToPath(new URL('../../dist/', import.meta.url));
const subPath = '/some/where/';

/** @type {Record<string, string>} */
const types = {
  '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.wasm': 'application/wasm', '.woff2': 'font/woff2',
  '.json': 'application/json', '.webmanifest': 'application/manifest+json', '.svg': 'image/svg+xml', '.png': 'image/png', '.txt': 'text/plain',
};

/**
 * Serves dist/, or another build, under a sub-path. `show` puts another build in its place.
 * @param {string} [folder]
 * @returns {Promise<{ address: string, show: (folder: string) => void, close: () => void }>}
 */
export async function serve(folder = dist) {
  let shown = folder;
  const server = createServer((request, response) => {
    const path = decodeURIComponent(new URL(request.url ?? '/', 'http://localhost').pathname);
    const name = path === subPath ? 'index.html' : normalize(path.slice(subPath.length));
    const file = join(shown, name);
    if (!path.startsWith(subPath) || name.startsWith('..') || !existsSync(file)) {
      response.writeHead(404).end();
      return;
    }
    response.writeHead(200, { 'content-type': types[extname(file)] ?? 'application/octet-stream' });
    createReadStream(file).pipe(response);
  });
  await new Promise((done) => server.listen(0, '127.0.0.1', () => done(undefined)));
  const { port } = /** @type {import('node:net').AddressInfo} */ (server.address());
  return {
    address: `http://127.0.0.1:${port}${subPath}`,
    show: (other) => {
      shown = other;
    },
    close: () => {
      server.closeAllConnections();
      server.close();
    },
  };
}

/** The page as one file, opened from the disk. */
export const fileAddress = pathToFileURL(join(dist, 'shimmy.html')).href;
