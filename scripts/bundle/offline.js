// What keeps dist/ for visits without a network: the service worker, and release.json, the list of all files of this
// build. Written last of all, when each file has its final content.

import { createHash } from 'node:crypto';
import { copyFileSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join, sep } from 'node:path';
import { ROOT } from '../setup/root.mjs';

const WORKER = 'service-worker.js';
const LIST = 'release.json';

/** @returns {import('vite').Plugin} */
export const offline = () => ({
  name: 'offline',
  apply: 'build',
  writeBundle: {
    order: 'post',
    sequential: true,
    handler({ dir = '' }) {
      listRelease(dir);
      copyFileSync(join(ROOT, 'www', 'offline', WORKER), join(dir, WORKER));
    },
  },
});

/** Writes the list of a build that lies in a folder: each file with its hash, the page under the folder's own address. @param {string} dir */
export function listRelease(dir) {
  const names = readdirSync(dir, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile() && ![WORKER, LIST, 'shimmy.html'].includes(entry.name))
    .map((entry) => join(entry.parentPath, entry.name).slice(join(dir, sep).length).replaceAll(sep, '/'))
    .sort();
  const files = Object.fromEntries(names.map((name) => [name === 'index.html' ? './' : name, integrity(join(dir, name))]));
  const version = createHash('sha256').update(JSON.stringify(files)).digest('hex').slice(0, 12);
  writeFileSync(join(dir, LIST), `${JSON.stringify({ version, files }, null, 1)}\n`);
}

/** @param {string} path */
const integrity = (path) => `sha256-${createHash('sha256').update(readFileSync(path)).digest('base64')}`;
