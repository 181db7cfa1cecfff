// The licenses of what the bundle carries: npm packages the page imports and crates inside the module.
// The site has them as licenses.txt, the single file as a comment at its end.

import { execFileSync } from 'node:child_process';
import { readdirSync, readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { ROOT } from '../setup/root.mjs';
import { TARGET } from '../setup/wasm-trial.mjs';

/** @typedef {{name: string, license: string, folder: string}} Package */

/** @param {'file' | 'comment'} form @returns {import('vite').Plugin} */
export const notices = (form) => ({
  name: 'notices',
  apply: 'build',
  generateBundle() {
    if (form === 'file') this.emitFile({ type: 'asset', fileName: 'licenses.txt', source: allNotices() });
  },
  transformIndexHtml: (html) =>
    form === 'comment' ? `${html.trimEnd()}\n<!--\n${allNotices().replaceAll('--', '- -')}-->\n` : html,
});

/** Each text once, under the names of all that it covers. */
function allNotices() {
  /** @type {Map<string, string[]>} */
  const covered = new Map();
  for (const { name, license, folder } of [...npmPackages(), ...crates()]) {
    const text = licenseText(folder) ?? `Licensed under ${license}.`;
    covered.set(text, [...(covered.get(text) ?? []), name]);
  }
  return [...covered].map(([text, names]) => `=== ${names.join(', ')}\n\n${text}\n`).join('\n');
}

/** Of several licenses to choose from, MIT is the shortest. @param {string} folder */
function licenseText(folder) {
  const files = readdirSync(folder).filter((name) => /^(licen[cs]e|copying)/i.test(name));
  const file = files.find((name) => /mit/i.test(name)) ?? files[0];
  return file && readFileSync(join(folder, file), 'utf8').replaceAll('\r', '').trim();
}

/** What package.json depends on, and what that depends on. @returns {Package[]} */
function npmPackages() {
  /** @type {Record<string, {version: string, license: string, dev?: boolean}>} */
  const { '': _, ...packages } = JSON.parse(readFileSync(join(ROOT, 'package-lock.json'), 'utf8')).packages;
  return Object.entries(packages)
    .filter(([, { dev }]) => !dev)
    .map(([path, { version, license }]) => ({
      name: `${path.replace(/.*node_modules\//, '')} ${version}`,
      license,
      folder: join(ROOT, path),
    }));
}

/** The crates whose code is in the module; macros and what only tests use stay outside. @returns {Package[]} */
function crates() {
  const tree = cargo('tree', '--locked', '--edges=normal,no-proc-macro', '--prefix=none', `--target=${TARGET}`);
  const names = new Set(tree.split('\n').map((line) => line.replace(/^(\S+) v(\S+).*/, '$1 $2')));
  /** @type {{name: string, version: string, license: string, manifest_path: string, source: string | null}[]} */
  const packages = JSON.parse(cargo('metadata', '--locked', '--format-version=1', `--filter-platform=${TARGET}`)).packages;
  return packages
    .filter(({ name, version, source }) => source !== null && names.has(`${name} ${version}`))
    .map(({ name, version, license, manifest_path }) => ({
      name: `${name} ${version}`,
      license,
      folder: dirname(manifest_path),
    }));
}

/** @param {...string} args */
const cargo = (...args) => execFileSync('cargo', args, { cwd: ROOT, encoding: 'utf8', maxBuffer: 1 << 28 });
