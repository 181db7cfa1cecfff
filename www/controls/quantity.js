/**
 * A parameter as the page shows it, in the unit that people think in; behind the page it is SI.
 *
 * @typedef {import('../pkg/shimmy.js').Parameter} Parameter
 * @typedef {import('../words/voice.js').Voice} Voice
 */

import { decimalsOf, parseNumber } from '../words/number.js';
import { isWord } from '../words/voice.js';
import { shownUnit, typedUnit } from './unit.js';

export class Quantity {
  #unit;

  /**
   * @param {Parameter} parameter
   * @param {import('./unit.js').VelocityUnit} [velocityUnit]
   */
  constructor(parameter, velocityUnit = 'm/s') {
    this.parameter = parameter;
    this.#unit = shownUnit(parameter.unit, velocityUnit);
    this.unit = this.#unit.name;
    this.isLogarithmic = parameter.scale === 'log';
    this.min = this.toShown(parameter.min);
    this.max = this.toShown(parameter.max);
    const range = this.max - this.min;
    /** The least a slider sets: about three hundred places on its way. A power of ten. */
    this.grain = powerOfTen(Math.floor(Math.log10(range / 300)));
    /** Decimals that show it. */
    this.decimals = decimalsOf(this.grain, 0);
    /** What one press of an arrow key adds: about a hundredth of the way, a power of ten. */
    this.step = powerOfTen(Math.floor(Math.log10(range / 100)));
  }

  get name() {
    return this.parameter.name;
  }

  /** @param {number} value in SI, @returns {number} as shown, free of the rounding of the conversion */
  toShown(value) {
    return this.#unit.size === 1 ? value : Number((value / this.#unit.size).toPrecision(12));
  }

  /** @param {number} shown */
  toSI(shown) {
    return shown * this.#unit.size;
  }

  /**
   * Reads what a person typed: a number, with a unit behind it or not.
   * @param {string} text
   * @returns {number} as shown; NaN for what is no number
   */
  read(text) {
    const typed = typedUnit(text, this.parameter.unit);
    if (!typed) return parseNumber(text);
    const number = parseNumber(typed.number);
    return typed.size === this.#unit.size ? number : this.toShown(number * typed.size);
  }

  /**
   * The number, without its unit.
   * @param {number} value in SI
   * @param {Voice} voice
   */
  number(value, voice) {
    const shown = this.toShown(value);
    if (shown !== 0 && (Math.abs(shown) >= 1e6 || Math.abs(shown) < 1e-6)) return voice.power(shown);
    const isIdle = !this.#unit.isRound && Number(shown.toPrecision(6)) !== shown;
    return voice.number(shown, isIdle ? this.decimals : decimalsOf(shown, this.isFar(value) ? 0 : this.decimals));
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
   * The value rounded to what the field shows.
   * @param {number} value in SI
   * @returns {number} in SI
   */
  snapped(value) {
    const shown = this.toShown(value);
    return this.toSI(Number(this.isLogarithmic ? shown.toPrecision(3) : shown.toFixed(this.decimals)));
  }

  /**
   * A value rounded to what the slider sets, up or down. What is nearer than a hundredth of that to a round number is
   * that number: 27.5996 is 27.6.
   * @param {number} value in SI
   * @param {'up' | 'down'} direction
   * @returns {number} in SI
   */
  rounded(value, direction) {
    const shown = this.toShown(value);
    const grain = this.isLogarithmic ? powerOfTen(Math.floor(Math.log10(shown)) - 2) : this.grain;
    const grains = shown / grain;
    const nearest = Math.round(grains);
    const whole = Math.abs(grains - nearest) < 0.01 ? nearest : direction === 'up' ? Math.ceil(grains) : Math.floor(grains);
    return this.toSI(Number((whole * grain).toPrecision(12)));
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

/** Exactly as it is written, which 10 ** −4 is not. @param {number} exponent */
function powerOfTen(exponent) {
  return Number(`1e${exponent}`);
}
