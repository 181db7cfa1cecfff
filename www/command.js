/**
 * What a hand, a key or a story asks of the page, by name. Elements tell it; whoever holds the page carries it out.
 *
 * @param {EventTarget} element where it is told: the event bubbles from there
 * @param {string} name see the files in commands/
 * @param {unknown} [value]
 */
export function tell(element, name, value) {
  element.dispatchEvent(new CustomEvent('command', { bubbles: true, detail: { name, value } }));
}
