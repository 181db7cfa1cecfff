import { readers } from '../link/read.js';
import { version } from '../link/write.js';

/** What of a run the page takes, and what it chooses itself: how long and how exactly to compute. */
const understood = ['model', 'parameters', 'friction', 'initial', 'duration', 'samples', 'times', 'method', 'rtol', 'atol', 'step', 'maxSteps'];

/**
 * The address of the experiment that a file of a run holds, for the page to open as it opens any link: what it cannot
 * read there it lists. An error where the text is no run at all.
 * @param {string} text
 */
export function linkOfRun(text) {
  const run = /** @type {unknown} */ (JSON.parse(text));
  if (!isRecord(run) || typeof run.model !== 'string') throw new Error('it names no model');
  const pairs = new URLSearchParams({ shimmy: String(version), model: run.model });
  for (const [key, value] of Object.entries(run)) if (!understood.includes(key) && value !== null) pairs.append(`run.${key}`, JSON.stringify(value));
  // A parameter of a key's name is no key.
  if (isRecord(run.parameters)) for (const [key, value] of Object.entries(run.parameters)) pairs.append(Object.hasOwn(readers, key) || key.includes('.') ? `parameters.${key}` : key, JSON.stringify(value));
  if (isRecord(run.friction)) for (const [key, value] of Object.entries(run.friction)) if (value !== null) pairs.append(`friction.${key}`, JSON.stringify(value));
  if (isRecord(run.initial)) for (const [key, value] of Object.entries(run.initial)) pairs.append(`initial.${key}`, JSON.stringify(value));
  return `#${pairs}`;
}

/** @param {unknown} value @returns {value is Record<string, unknown>} */
function isRecord(value) {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}
