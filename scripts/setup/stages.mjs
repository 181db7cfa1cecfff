// A long command as named stages, each with its time.

import { performance } from 'node:perf_hooks';
import { RunFailed } from './run.mjs';

/** @typedef {[name: string, run: () => void | Promise<void>]} Stage */

/** @param {number} since */
const elapsed = (since) => {
  const seconds = Math.round((performance.now() - since) / 1000);
  return seconds < 60 ? `${seconds} s` : `${Math.floor(seconds / 60)} min ${seconds % 60} s`;
};

/**
 * Runs the stages in turn. The first that fails ends the process, and the last line names it.
 * @param {string} title
 * @param {Stage[]} stages
 */
export async function runStages(title, stages) {
  const start = performance.now();
  /** @type {string[]} */
  const times = [];
  for (const [index, [name, stage]] of stages.entries()) {
    const began = performance.now();
    console.log(`\n── ${index + 1}/${stages.length} ${name}`);
    try {
      await stage();
    } catch (error) {
      if (!(error instanceof RunFailed)) throw error;
      console.error(`\n✗ ${title}: stage ${index + 1} of ${stages.length}, ${name}, failed after ${elapsed(began)}: ${error.message}`);
      process.exit(1);
    }
    times.push(`${name} ${elapsed(began)}`);
  }
  console.log(`\n${times.join('\n')}\n✓ ${title}: all ${stages.length} stages passed in ${elapsed(start)}`);
}
