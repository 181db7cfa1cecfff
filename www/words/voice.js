import { en } from './en/index.js';
import { tr } from './tr/index.js';
import { formatNumber, formatPower } from './number.js';

/**
 * @typedef {import('./number.js').Language} Language
 * @typedef {keyof typeof en} Key
 * @typedef {{
 *   language: Language,
 *   say: (key: Key, values?: Record<string, string | number>) => string,
 *   number: (value: number, decimals: number) => string,
 *   power: (value: number) => string,
 * }} Voice the page's words and numbers in one language
 */

/** @type {Record<Language, Record<Key, string>>} */
export const languages = { en, tr };

/** @type {Map<Language, Voice>} */
const voices = new Map();

/**
 * The voice of a language: always the same, so that an element whose words have not changed is not rendered anew.
 * @param {Language} language
 * @returns {Voice}
 */
export function voiceOf(language) {
  const voice = voices.get(language) ?? spoken(language);
  voices.set(language, voice);
  return voice;
}

/** @param {Language} language @returns {Voice} */
function spoken(language) {
  const words = languages[language];
  return {
    language,
    say: (key, values = {}) => words[key].replaceAll(/\{(\w+)\}/g, (_, name) => String(values[name])),
    number: (value, decimals) => formatNumber(value, decimals, language),
    power: (value) => formatPower(value, language),
  };
}

/**
 * Whether a word of that name exists; names that the engine gives (parameters, error codes) are asked for first.
 * @param {string} key
 * @returns {key is Key}
 */
export function isWord(key) {
  return Object.hasOwn(en, key);
}
