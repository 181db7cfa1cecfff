// Bytes over the wire: what a first visit asks for, as a server that compresses would send it.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { brotliCompressSync } from 'node:zlib';

/** @typedef {{ name: string, raw: number, wire: number }} Size */

/** Typefaces are compressed already, and go out as they are. @param {string} path @returns {Omit<Size, 'name'>} */
function sizeOf(path) {
  const content = readFileSync(path);
  return { raw: content.length, wire: path.endsWith('.woff2') ? content.length : brotliCompressSync(content).length };
}

/**
 * @param {string} dist
 * @param {string} address where it is served
 * @param {string[]} requests
 * @returns {Size[]}
 */
export function bytesOf(dist, address, requests) {
  const paths = [...new Set(requests.filter((url) => url.startsWith(address)).map((url) => new URL(url).pathname.slice(new URL(address).pathname.length) || 'index.html'))];
  return paths.map((name) => ({ name, ...sizeOf(join(dist, name)) }));
}

/** @param {string} dist @returns {Size} */
export const singleFile = (dist) => ({ name: 'shimmy.html', ...sizeOf(join(dist, 'shimmy.html')) });
