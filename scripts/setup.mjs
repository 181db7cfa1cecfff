// The set-up: finds what a command needs and brings what is missing. One line a step; a second run changes nothing.
// By itself, `node scripts/setup.mjs`, it sets up everything.

import { pathToFileURL } from 'node:url';
import { failed, found, Missing } from './setup/say.mjs';
import { buildEnvironment, flagsThatReplaceOurs } from './setup/environment.mjs';
import { findNode, installPackages } from './setup/packages.mjs';
import { findRust, findRustChecks } from './setup/rust.mjs';
import { findTarget, findTargetClippy } from './setup/wasm-target.mjs';
import { findWasmBindgen, findWasmPack } from './setup/cargo-tools.mjs';
import { findWasmOpt } from './setup/wasm-opt.mjs';
import { findSciPy } from './setup/python.mjs';
import { findChromedriver, findChromium, findFirefox, findGeckodriver } from './setup/browsers.mjs';

/**
 * What the steps have found, for those who build and test.
 * @typedef {object} Tools
 * @property {NodeJS.ProcessEnv} native  the environment of native builds
 * @property {NodeJS.ProcessEnv} wasm    the environment of builds for wasm32
 * @property {boolean} debian            whether wasm builds use Debian's compiler
 * @property {string} chromium           paths of programs, from here on down; empty where not asked for
 * @property {string} chromedriver
 * @property {string} firefox
 * @property {string} geckodriver
 * @property {string} python             one that has SciPy
 * @property {{chrome: string, firefox: string}} webdriver  files for wasm-bindgen's test runner
 */

/** @typedef {'native' | 'module' | 'checks' | 'chromium' | 'browsers' | 'python'} Need */

/** Who needs what. Everybody needs what lists nobody. @type {{name: string, for: Need[], run: (tools: Tools) => string}[]} */
const STEPS = [
  { name: 'Node.js', for: [], run: findNode },
  { name: 'npm packages', for: [], run: installPackages },
  { name: 'Rust', for: ['native', 'module'], run: findRust },
  { name: 'wasm32 target', for: ['module'], run: findTarget },
  { name: 'wasm-bindgen', for: ['module'], run: findWasmBindgen },
  { name: 'wasm-pack', for: ['module'], run: findWasmPack },
  { name: 'wasm-opt', for: ['module'], run: findWasmOpt },
  { name: 'rustfmt, clippy', for: ['checks'], run: findRustChecks },
  { name: 'clippy for wasm32', for: ['checks'], run: findTargetClippy },
  { name: 'SciPy', for: ['python'], run: findSciPy },
  { name: 'Chromium', for: ['chromium', 'browsers'], run: findChromium },
  { name: 'ChromeDriver', for: ['browsers'], run: findChromedriver },
  { name: 'Firefox', for: ['browsers'], run: findFirefox },
  { name: 'geckodriver', for: ['browsers'], run: findGeckodriver },
];

/**
 * Sets up what is asked for. Where a piece cannot be had it says which and ends the process.
 * @param {...Need} needs
 * @returns {Tools}
 */
export function setUp(...needs) {
  const env = buildEnvironment();
  /** @type {Tools} */
  const tools = {
    native: env,
    wasm: env,
    debian: false,
    chromium: '',
    chromedriver: '',
    firefox: '',
    geckodriver: '',
    python: '',
    webdriver: { chrome: '', firefox: '' },
  };
  for (const name of flagsThatReplaceOurs()) found(name, 'left out, or it would replace the flags of .cargo/config.toml');
  for (const step of STEPS) {
    if (step.for.length > 0 && !step.for.some((need) => needs.includes(need))) continue;
    try {
      found(step.name, step.run(tools));
    } catch (error) {
      if (!(error instanceof Missing)) throw error;
      failed(step.name, error.message);
      process.exit(1);
    }
  }
  return tools;
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) setUp('native', 'module', 'checks', 'python', 'browsers');
