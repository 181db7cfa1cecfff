import { version } from '../link/write.js';

/**
 * The address of the experiment that a file of a run holds, for the page to open as it opens any link: what it cannot
 * read there it lists. An error where the text is no run at all.
 * @param {string} text
 */
export function linkOfRun(text) {
  const run = /** @type {unknown} */ (JSON.parse(text));
  if (!isRecord(run) || typeof run.model !== 'string') throw new Error('it names no model');
  const pairs = new URLSearchParams({ shimmy: String(version), model: run.model });
  if (isRecord(run.parameters)) for (const [key, value] of Object.entries(run.parameters)) pairs.append(key, String(value));
  if (isRecord(run.initial)) for (const [key, value] of Object.entries(run.initial)) pairs.append(`initial.${key}`, String(value));
  return `#${pairs}`;
}

/** @param {unknown} value @returns {value is Record<string, unknown>} */
function isRecord(value) {
  return typeof value === 'object' && value !== null && !Array.isArray(value);
}
