// Running other programs: never through a shell, so that no path or argument needs quoting.

import { spawnSync } from 'node:child_process';
import { accessSync, constants, statSync } from 'node:fs';
import { delimiter, join } from 'node:path';

/**
 * @typedef {object} Outcome
 * @property {boolean} ok     it ran and ended with exit code 0
 * @property {string} out     what it wrote to standard output, trimmed
 * @property {string} all     standard output and error together, trimmed
 */

/**
 * Runs a program quietly to its end.
 * @param {string} program
 * @param {string[]} [args]
 * @param {{env?: NodeJS.ProcessEnv, cwd?: string, input?: string}} [options]
 * @returns {Outcome}
 */
export function ask(program, args = [], options = {}) {
  const { status, stdout, stderr, error } = spawnSync(program, args, {
    env: process.env,
    ...options,
    encoding: 'utf8',
    maxBuffer: 1 << 28,
  });
  const all = [stdout, stderr, error?.message].filter(Boolean).join('\n').trim();
  return { ok: status === 0, out: (stdout ?? '').trim(), all };
}

/**
 * Where the shell would find a program, or null.
 * @param {string} program  a name, or a path that is then only checked
 * @param {NodeJS.ProcessEnv} [env]
 * @returns {string | null}
 */
export function whereIs(program, env = process.env) {
  const suffixes = process.platform === 'win32' ? ['.exe', '.cmd', ''] : [''];
  const folders = /[\\/]/.test(program) ? [''] : (env.PATH ?? '').split(delimiter).filter(Boolean);
  for (const folder of folders) {
    for (const suffix of suffixes) {
      const path = join(folder, program) + suffix;
      if (isExecutable(path)) return path;
    }
  }
  return null;
}

/** @param {string} path */
function isExecutable(path) {
  try {
    accessSync(path, constants.X_OK);
    return statSync(path).isFile();
  } catch {
    return false;
  }
}
