// How the browsers are started for tests. The files name programs of this machine, so they stay out of git.

import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { ROOT } from './root.mjs';
import { isRoot } from './debian.mjs';

/** Quiet, without a window, without talk to the outside; as root the sandbox would refuse to start. */
export const chromiumArguments = () => [
  '--headless',
  '--disable-gpu',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  ...(isRoot() ? ['--no-sandbox'] : []),
];

/**
 * One file a browser, for wasm-bindgen's test runner.
 * @param {import('../setup.mjs').Tools} tools
 * @returns {{chrome: string, firefox: string}}
 */
export function writeWebdriverFiles({ chromium, firefox }) {
  return {
    chrome: write('chrome', { 'goog:chromeOptions': { binary: chromium, args: chromiumArguments() } }),
    firefox: write('firefox', { 'moz:firefoxOptions': { binary: firefox, args: ['-headless'] } }),
  };
}

/** @param {string} name @param {object} capabilities */
function write(name, capabilities) {
  const folder = join(ROOT, 'target', 'webdriver');
  mkdirSync(folder, { recursive: true });
  const path = join(folder, `${name}.json`);
  writeFileSync(path, `${JSON.stringify(capabilities, null, 2)}\n`);
  return path;
}
