/**
 * The keys of the page, each a line: what is pressed, which command it is, how the list under "?" calls it.
 *
 * @typedef {{
 *   keys: readonly string[], command: string, value?: unknown, word: string, isElementsOwn?: boolean, usedBy?: string,
 *   whileVeiled?: boolean,
 * }} Shortcut `isElementsOwn`: a focused button or slider uses the key itself; `usedBy`: only these elements do, a
 *   selector; `whileVeiled`: only then; `word`: `key.<word>` and `key.<word>.does`
 */

/** Elements that page by these keys themselves; a knob's slider does where no pointer has led to it (see page.js). */
const ownPages = 'select, [role="combobox"], shimmy-page:not([data-pointed]) [type="range"]';

/** Elements that a space presses; a button where no pointer has led to it: who clicks a lens, and then a space, wants a pause. */
const ownSpace = 'select, [role="combobox"], input:not(.number, [type="range"]), shimmy-page:not([data-pointed]) :is(button, summary)';

/** @type {readonly Shortcut[]} */
export const shortcuts = [
  { keys: ['1'], command: 'guess', value: 'dies-out', word: 'guess', whileVeiled: true },
  { keys: ['2'], command: 'guess', value: 'holds', word: 'guess', whileVeiled: true },
  { keys: ['3'], command: 'guess', value: 'grows', word: 'guess', whileVeiled: true },
  { keys: ['Enter'], command: 'reveal', word: 'reveal', usedBy: 'button, summary, select, a', whileVeiled: true },
  { keys: ['PageDown'], command: 'reveal', word: 'reveal', whileVeiled: true },
  { keys: [' '], command: 'toggle', word: 'play', usedBy: ownSpace },
  { keys: ['ArrowLeft'], command: 'back', word: 'step', isElementsOwn: true },
  { keys: ['ArrowRight'], command: 'on', word: 'step', isElementsOwn: true },
  { keys: ['r'], command: 'start', word: 'start' },
  { keys: ['k'], command: 'kick', word: 'kick' },
  { keys: ['m'], command: 'sound', word: 'sound' },
  { keys: ['0'], command: 'fit', word: 'fit' },
  { keys: ['PageDown'], command: 'next', word: 'story', usedBy: ownPages },
  { keys: ['PageUp'], command: 'previous', word: 'story', usedBy: ownPages },
  { keys: ['p'], command: 'predict', word: 'predict' },
  { keys: ['f'], command: 'freeze', word: 'freeze' },
  { keys: ['d'], command: 'pen', word: 'pen' },
  { keys: ['b'], command: 'big', word: 'big' },
  { keys: ['Home'], command: 'rest', word: 'rest', usedBy: 'select, input, [role="slider"]' },
  { keys: ['Escape'], command: 'close', word: 'close' },
];

/** What the list under "?" says besides. */
export const otherKeys = /** @type {const} */ (['search', 'wheel', 'cursor', 'point', 'branch', 'undo', 'knob', 'help']);

/**
 * Which shortcut a key press is; null where it is none, or where the focused element has its own use for it.
 * @param {KeyboardEvent} event
 * @param {boolean} isVeiled whether something is to be guessed
 */
export function shortcutOf(event, isVeiled) {
  if (event.ctrlKey || event.metaKey || event.altKey) return null;
  const isAt = (/** @type {string} */ elements) => event.target instanceof HTMLElement && event.target.matches(elements);
  const isUsed = isAt('button, select, summary, input, [role="slider"]');
  return shortcuts.find(({ keys, isElementsOwn, usedBy, whileVeiled }) =>
    keys.includes(event.key) && !(isElementsOwn && isUsed) && !(usedBy && isAt(usedBy)) && (isVeiled || !whileVeiled)) ?? null;
}

/**
 * Whether a key says nothing to a field for numbers in which nothing is being typed: it is the page's then.
 * @param {KeyboardEvent} event
 */
export function writesNoNumber({ key, ctrlKey, metaKey, altKey }) {
  if (ctrlKey || metaKey) return key.toLowerCase() === 'z';
  return !altKey && /^[a-df-z /?]$/i.test(key);
}
