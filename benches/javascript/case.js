// The case that every solver is given, and how far a solution is from the truth.

import { readFileSync } from 'node:fs';

/** @typedef {{ model: string, parameters: Record<string, number>, initial: Record<string, number>,
 *   state: string[], amplitude: number[], times: number[], reference: number[][],
 *   allowed: number[], tolerances: number[] }} Case */

/** @type {Case} */
export const theCase = JSON.parse(readFileSync(new URL('../case.json', import.meta.url), 'utf8'));
