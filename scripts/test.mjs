// Everything that is tested, stage by stage: natively, in Node.js and in real browsers.

import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { bundlePage } from './build.mjs';
import { checkStages } from './check.mjs';
import { ROOT } from './setup/root.mjs';
import { run, RunFailed } from './setup/run.mjs';
import { runStages } from './setup/stages.mjs';
import { setUp } from './setup.mjs';
import { TARGET } from './setup/wasm-trial.mjs';

const tools = setUp('native', 'module', 'checks', 'python', 'browsers');

/** The suite of tests/wasm.rs; the same program runs in every place. @param {NodeJS.ProcessEnv} [place] */
const wasmSuite = (place) => () =>
  run('cargo', ['test', '--locked', '--target', TARGET, '--test', 'wasm'], {
    ...tools.wasm,
    CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUNNER: 'wasm-bindgen-test-runner',
    ...place,
  });

const inChromium = {
  WASM_BINDGEN_USE_BROWSER: '1',
  CHROMEDRIVER: tools.chromedriver,
  WASM_BINDGEN_TEST_WEBDRIVER_JSON: tools.webdriver.chrome,
};
const inFirefox = {
  WASM_BINDGEN_USE_BROWSER: '1',
  GECKODRIVER: tools.geckodriver,
  WASM_BINDGEN_TEST_WEBDRIVER_JSON: tools.webdriver.firefox,
};

/** The test files of a folder, in Node.js' own runner. @param {string} folder @param {...string} options */
const nodeTests = (folder, ...options) => () => {
  const files = readdirSync(join(ROOT, folder), { recursive: true, encoding: 'utf8' })
    .filter((name) => name.endsWith('.test.mjs'))
    .map((name) => join(folder, name));
  if (files.length === 0) throw new RunFailed(`no tests in ${folder}`);
  const programs = {
    SHIMMY_PYTHON: tools.python,
    SHIMMY_CHROMIUM: tools.chromium,
    SHIMMY_FIREFOX: tools.firefox,
    SHIMMY_GECKODRIVER: tools.geckodriver,
  };
  run(process.execPath, ['--test', '--test-reporter=spec', ...options, ...files], { ...tools.native, ...programs });
};

await runStages('npm test', [
  ...checkStages(tools),
  ['engine, natively', () => run('cargo', ['test', '--locked'], tools.native)],
  ['engine in Node.js', wasmSuite()],
  ['engine in Chromium', wasmSuite(inChromium)],
  ['engine in Firefox', wasmSuite(inFirefox)],
  ["the module's API in Node.js", nodeTests('tests/node')],
  ['units of the page', nodeTests('tests/www')],
  ['npm run build', () => bundlePage(tools)],
  ['the page in real browsers', nodeTests('tests/e2e', '--test-concurrency=1')],
]);
