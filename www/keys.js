/**
 * The keys of the page, each a line: what is pressed, which command it is, how the list under "?" calls it.
 *
 * @typedef {{
 *   keys: readonly string[], command: string, value?: unknown, word: string, isElementsOwn?: boolean, usedBy?: string,
 * }} Shortcut `isElementsOwn`: a focused button or slider uses the key itself; `usedBy`: only these elements do, a
 *   selector; `word`: `key.<word>` and `key.<word>.does`
 */

/** @type {readonly Shortcut[]} */
export const shortcuts = [
  { keys: [' '], command: 'toggle', word: 'play', isElementsOwn: true },
  { keys: ['ArrowLeft'], command: 'back', word: 'step', isElementsOwn: true },
  { keys: ['ArrowRight'], command: 'on', word: 'step', isElementsOwn: true },
  { keys: ['r'], command: 'start', word: 'start' },
  { keys: ['k'], command: 'kick', word: 'kick' },
  { keys: ['0'], command: 'fit', word: 'fit' },
  { keys: ['PageDown'], command: 'next', word: 'story', usedBy: 'select, input' },
  { keys: ['PageUp'], command: 'previous', word: 'story', usedBy: 'select, input' },
];

/** What the list under "?" says besides. */
export const otherKeys = /** @type {const} */ (['search', 'undo', 'knob', 'help']);

/**
 * Which shortcut a key press is; null where it is none, or where the focused element has its own use for it.
 * @param {KeyboardEvent} event
 */
export function shortcutOf(event) {
  if (event.ctrlKey || event.metaKey || event.altKey) return null;
  const isAt = (/** @type {string} */ elements) => event.target instanceof HTMLElement && event.target.matches(elements);
  const isUsed = isAt('button, select, summary, input, [role="slider"]');
  return shortcuts.find(({ keys, isElementsOwn, usedBy }) =>
    keys.includes(event.key) && !(isElementsOwn && isUsed) && !(usedBy && isAt(usedBy))) ?? null;
}
