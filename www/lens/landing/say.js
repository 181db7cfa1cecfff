/**
 * What there is to say of a landing roll.
 *
 * @typedef {import('./roll.js').Shimmy} Shimmy
 * @typedef {import('./why.js').Reason} Reason
 * @typedef {import('../../controls/quantity.js').Quantity} Quantity
 * @typedef {import('../../words/voice.js').Voice} Voice
 */

/** A speed, in the unit in which the page shows it. @param {number} velocity @param {Quantity} quantity @param {Voice} voice */
export const speedOf = (velocity, quantity, voice) => `${voice.number(quantity.toShown(velocity), 1)} ${quantity.unit}`;

/** @param {number} angle in rad @param {Voice} voice @param {number} [decimals] */
export const angleOf = (angle, voice, decimals = 1) => `${voice.number((angle * 180) / Math.PI, decimals)}°`;

/** When it shimmies, in a sentence. @param {Shimmy} shimmy @param {number} threshold @param {Quantity} quantity @param {Voice} voice */
export function summaryOf({ begins, ends, widest }, threshold, quantity, voice) {
  const speed = (/** @type {number} */ velocity) => speedOf(velocity, quantity, voice);
  if (!begins) return voice.say('landing.calm', { angle: angleOf(widest.angle, voice, 2), threshold: angleOf(threshold, voice) });
  return voice.say(ends ? 'landing.shimmies' : 'landing.shimmies.on', {
    from: speed(begins.velocity), to: ends ? speed(ends.velocity) : '', angle: angleOf(widest.angle, voice), at: speed(widest.velocity),
    distance: voice.number((ends?.distance ?? widest.distance) - begins.distance, 0),
  });
}

/** Why, in sentences. @param {readonly Reason[]} reasons @param {number} threshold @param {Quantity} quantity @param {Voice} voice */
export function reasonsInWords(reasons, threshold, quantity, voice) {
  return reasons.map(({ key, values }) => voice.say(/** @type {import('../../words/voice.js').Key} */ (`landing.why.${key}`), {
    threshold: angleOf(threshold, voice), ...Object.fromEntries(Object.entries(values).map(([name, value]) => [name, speedOf(value, quantity, voice)])),
  }));
}
