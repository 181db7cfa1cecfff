/**
 * A parameter as the page shows it. Angles are degrees here and radians everywhere behind; nothing else is converted.
 *
 * @typedef {import('../pkg/shimmy.js').Parameter} Parameter
 * @typedef {import('../words/voice.js').Voice} Voice
 */

import { decimalsOf } from '../words/number.js';
import { isWord } from '../words/voice.js';

const degree = Math.PI / 180;

export class Quantity {
  #factor;

  /** @param {Parameter} parameter */
  constructor(parameter) {
    this.parameter = parameter;
    const isAngle = parameter.unit === 'rad';
    this.#factor = isAngle ? degree : 1;
    this.unit = isAngle ? '°' : parameter.unit === '1' ? '' : parameter.unit;
    this.isLogarithmic = parameter.scale === 'log';
    this.min = this.toShown(parameter.min);
    this.max = this.toShown(parameter.max);
    const range = this.max - this.min;
    /** Decimals a slider sets: about three hundred places on its way. */
    this.decimals = Math.max(0, Math.ceil(-Math.log10(range / 300)));
    /** What one press of an arrow key adds: about a hundredth of the way, a power of ten. */
    this.step = 10 ** Math.floor(Math.log10(range / 100));
  }

  get name() {
    return this.parameter.name;
  }

  /** @param {number} value in SI, @returns {number} as shown, free of the rounding of the conversion */
  toShown(value) {
    return this.#factor === 1 ? value : Number((value / this.#factor).toPrecision(12));
  }

  /** @param {number} shown */
  toSI(shown) {
    return shown * this.#factor;
  }

  /**
   * The number, without its unit.
   * @param {number} value in SI
   * @param {Voice} voice
   */
  number(value, voice) {
    const shown = this.toShown(value);
    if (shown !== 0 && (Math.abs(shown) >= 1e6 || Math.abs(shown) < 1e-6)) return voice.power(shown);
    return voice.number(shown, decimalsOf(shown, this.isFar(value) ? 0 : this.decimals));
  }

  /**
   * The number with its unit.
   * @param {number} value in SI
   * @param {Voice} voice
   */
  write(value, voice) {
    return withUnit(this.number(value, voice), this.unit);
  }

  /**
   * Whether a value is so far beyond the slider that a slip of the hand is likelier than a gear.
   * @param {number} value in SI
   */
  isFar(value) {
    const shown = this.toShown(value);
    const least = this.min > 0 ? this.min / 10 : this.min - 9 * (this.max - this.min);
    return shown > 10 * this.max || (shown < least && shown !== 0);
  }

  /**
   * Where on the slider a value stands, 0 … 1; values beyond its ends stand at them.
   * @param {number} value in SI
   */
  placeOf(value) {
    const shown = Math.min(Math.max(this.toShown(value), this.min), this.max);
    return this.isLogarithmic
      ? Math.log(shown / this.min) / Math.log(this.max / this.min)
      : (shown - this.min) / (this.max - this.min);
  }

  /**
   * The value at a place on the slider, rounded to what the field shows.
   * @param {number} place 0 … 1
   * @returns {number} in SI
   */
  valueAt(place) {
    const shown = this.isLogarithmic
      ? Number((this.min * (this.max / this.min) ** place).toPrecision(3))
      : Number((this.min + place * (this.max - this.min)).toFixed(this.decimals));
    return this.toSI(Math.min(Math.max(shown, this.min), this.max));
  }

  /**
   * The value some arrow steps away, kept on the slider unless it was beyond already.
   * @param {number} value in SI
   * @param {number} steps may be a fraction
   */
  stepped(value, steps) {
    const from = this.toShown(value);
    const to = Number((from + steps * this.step).toPrecision(12));
    return this.toSI(Math.min(Math.max(to, Math.min(from, this.min)), Math.max(from, this.max)));
  }
}

/**
 * @param {string} number
 * @param {string} unit
 */
export function withUnit(number, unit) {
  return unit === '' || unit === '°' ? number + unit : `${number} ${unit}`;
}

/**
 * The parameter in words; its name in the table where the page has no word for it yet.
 * @param {Quantity} quantity
 * @param {Voice} voice
 */
export function nameOf({ name }, voice) {
  const key = `parameter.${name}`;
  return isWord(key) ? voice.say(key) : name;
}
