/** Numbers as the page writes and reads them: one decimal sign a language, both understood. */

/** @typedef {'en' | 'tr'} Language */

const decimalSign = { en: '.', tr: ',' };
const minus = '−';
const thinSpace = '\u202f';

/**
 * A number with a fixed count of decimals, grouped in threes from five digits on, with a true minus.
 * @param {number} value
 * @param {number} decimals
 * @param {Language} language
 */
export function formatNumber(value, decimals, language) {
  const [whole, fraction] = Math.abs(value).toFixed(decimals).split('.');
  const grouped = whole.length > 4 ? whole.replace(/\B(?=(\d{3})+$)/g, thinSpace) : whole;
  const digits = fraction ? grouped + decimalSign[language] + fraction : grouped;
  const isNegative = value < 0 && /[1-9]/.test(digits);
  return isNegative ? minus + digits : digits;
}

/**
 * A number too large or too small for a field, as a power of ten that can be typed back.
 * @param {number} value
 * @param {Language} language
 */
export function formatPower(value, language) {
  return Number(value.toPrecision(6)).toExponential().replace('e+', 'e').replaceAll('-', minus).replace('.', decimalSign[language]);
}

/**
 * Decimals that show `value` in full, to six significant digits, and at least `least` of them.
 * @param {number} value
 * @param {number} least
 */
export function decimalsOf(value, least) {
  const shortest = String(Number(value.toPrecision(6)));
  const [mantissa, exponent = '0'] = shortest.split('e');
  const written = (mantissa.split('.')[1] ?? '').length - Number(exponent);
  return Math.min(12, Math.max(least, written));
}

/**
 * Decimals that show so many significant digits; whole digits always stand.
 * @param {number} value
 * @param {number} digits
 */
export function decimalsFor(value, digits) {
  return Math.min(12, Math.max(0, digits - 1 - Math.floor(Math.log10(Math.abs(value) || 1))));
}

/**
 * Reads what a person typed. "." and "," both serve as the decimal sign; where both occur, the last one does
 * and the other groups digits. A sign that groups must occur where groups can be (`1.234.567`, `1 234,5`).
 * @param {string} text
 * @returns {number} NaN for what is no number
 */
export function parseNumber(text) {
  const plain = text.trim().replaceAll(/[\u2212\u2013]/g, '-').replaceAll(/[\s\u00a0\u202f'’]/g, '');
  const last = Math.max(plain.lastIndexOf('.'), plain.lastIndexOf(','));
  if (last < 0) return asNumber(plain);
  const sign = plain[last];
  const other = sign === '.' ? ',' : '.';
  const before = plain.slice(0, last);
  const after = plain.slice(last + 1);
  const repeated = before.includes(sign);
  const grouping = repeated ? sign : other;
  if (repeated && before.includes(other)) return NaN;
  if (before.includes(grouping) && !/^[+-]?\d{1,3}(\D\d{3})+$/.test(before)) return NaN;
  if (repeated && !/^\d{3}$/.test(after)) return NaN;
  const whole = before.replaceAll(grouping, '');
  return asNumber(repeated ? whole + after : `${whole}.${after}`);
}

/** @param {string} text */
function asNumber(text) {
  return /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(text) ? Number(text) : NaN;
}
