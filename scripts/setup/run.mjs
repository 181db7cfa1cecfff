// Running a program for the user to watch: it speaks for itself, and its failure is ours.

import { spawnSync } from 'node:child_process';
import { ROOT } from './root.mjs';

/** A program ended badly; it has said why itself. */
export class RunFailed extends Error {}

/**
 * @param {string} program
 * @param {string[]} args
 * @param {NodeJS.ProcessEnv} [env]
 */
export function run(program, args, env = process.env) {
  const { status, signal, error } = spawnSync(program, args, { cwd: ROOT, env, stdio: 'inherit' });
  if (status === 0) return;
  throw new RunFailed(`${program} ${args.join(' ')}: ${error?.message ?? signal ?? `exit code ${status}`}`);
}

/** The end of a command that failed: its message and exit code 1; anything unforeseen keeps its stack. @param {unknown} error */
export function end(error) {
  if (!(error instanceof RunFailed)) throw error;
  console.error(`✗ ${error.message}`);
  process.exit(1);
}
