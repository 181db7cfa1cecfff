// What can be told from the sources without running them: format, clippy for both targets, types of the JavaScript.

import { pathToFileURL } from 'node:url';
import { ensureModule } from './build-wasm.mjs';
import { run } from './setup/run.mjs';
import { runStages } from './setup/stages.mjs';
import { setUp } from './setup.mjs';
import { TARGET } from './setup/wasm-trial.mjs';

/**
 * @param {import('./setup.mjs').Tools} tools
 * @returns {import('./setup/stages.mjs').Stage[]}
 */
export const checkStages = (tools) => [
  ['format', () => run('cargo', ['fmt', '--check'], tools.native)],
  ['clippy', () => run('cargo', ['clippy', '--locked', '--all-targets', '--', '-D', 'warnings'], tools.native)],
  [
    'clippy for wasm32',
    () => run('cargo', ['clippy', '--locked', '--target', TARGET, '--lib', '--test', 'wasm', '--', '-D', 'warnings'], tools.wasm),
  ],
  // The types of the module come from its build.
  ['WebAssembly module', () => ensureModule(tools)],
  ['types of the JavaScript', () => run('tsc', ['--noEmit'], tools.native)],
];

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  await runStages('npm run check', checkStages(setUp('native', 'module', 'checks')));
}
