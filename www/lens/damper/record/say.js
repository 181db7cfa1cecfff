import { decimalsFor } from '../../../words/number.js';

/** @typedef {import('../../../words/voice.js').Voice} Voice */
/** @typedef {import('../../../words/voice.js').Key} Key */
/** @typedef {import('./problem.js').Values} Values */

/** Why a file is no record. @param {{ code: string, values: Values }} problem @param {Voice} voice */
export const problemInWords = ({ code, values }, voice) => voice.say(/** @type {Key} */ (`record.problem.${code}`), filled(values, voice));

/** What was made of a file. @param {import('./problem.js').Notice} notice @param {Voice} voice */
export const noticeInWords = ({ code, values }, voice) => voice.say(/** @type {Key} */ (`record.notice.${code}`), filled(values, voice));

/** Names and numbers as the language has them; line numbers whole. @param {Values} values @param {Voice} voice */
function filled(values, voice) {
  return Object.fromEntries(Object.entries(values).map(([name, value]) => {
    if (name === 'kind') return [name, voice.say(/** @type {Key} */ (`record.kind.${value}`))];
    if (typeof value !== 'number') return [name, value];
    return [name, voice.number(value, Number.isInteger(value) ? 0 : Math.min(6, decimalsFor(value, 4)))];
  }));
}
