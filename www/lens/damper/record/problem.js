/**
 * Why a file is no record: a code, for which there is a word in each language (`record.<code>`), and what to fill it with.
 *
 * @typedef {Record<string, string | number>} Values
 * @typedef {{ code: string, values: Values }} Notice what was made of a file that is not quite as it should be
 */
export class Unreadable extends Error {
  /** @param {string} code @param {Values} [values] */
  constructor(code, values = {}) {
    super(`${code} ${JSON.stringify(values)}`);
    this.code = code;
    this.values = values;
  }
}
