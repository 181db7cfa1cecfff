/**
 * Columns of the tables about cycles: a value with its symbol and unit, on the page, in a picture and in a file.
 *
 * @typedef {import('../../controls/quantity.js').Quantity} Quantity
 * @typedef {import('../../words/voice.js').Voice} Voice
 */

/** @template Row @typedef {import('./table-out.js').OutColumn<Row>} OutColumn */

import { html, nothing } from 'lit';
import { symbolOf } from '../../controls/symbol.js';
import { quantities } from '../../view/quantities.js';
import { decimalsFor } from '../../words/number.js';
import { plainSymbol, shortNumber } from '../stability/say.js';

const units = /** @type {const} */ ({ torsionAngle: 'rad', torsionRate: 'rad/s', lateralDeformation: 'm' });

/** @typedef {keyof typeof units} StateName */

/**
 * A parameter of the gear. `set`: what a press on it does, for the first column.
 * @template Row
 * @param {Quantity} quantity
 * @param {(row: Row) => number} value
 * @param {Voice} voice
 * @param {{ does: (row: Row) => string, set: (row: Row) => void }} [press]
 * @returns {OutColumn<Row>}
 */
export function parameterColumn(quantity, value, voice, press) {
  const { unit, parameter } = quantity;
  const text = (/** @type {Row} */ row) => shortNumber(quantity, value(row), voice);
  return {
    name: quantity.name, unit: parameter.unit, head: `${plainSymbol(quantity)}${unit ? `, ${unit}` : ''}`,
    title: html`${symbolOf(parameter.symbol)}${unit ? html` <span class="unit">${unit}</span>` : nothing}`, value, text,
    show: press ? (row) => html`<button type="button" class="plain" title=${press.does(row)} aria-label=${press.does(row)} @click=${() => press.set(row)}>${text(row)}</button>` : text,
  };
}

/**
 * An amplitude; none where nothing swings.
 * @template Row
 * @param {StateName} state
 * @param {(row: Row) => number | null} value in SI
 * @param {Voice} voice
 * @param {{ name?: string, of?: string }} [more] `of`: by what method, written behind the symbol
 * @returns {OutColumn<Row>}
 */
export function amplitudeColumn(state, value, voice, { name = state, of = '' } = {}) {
  const { symbol, dotted, unit, perSI } = quantities[state];
  const letter = dotted ? `${symbol}\u0307` : symbol;
  const text = (/** @type {Row} */ row) => {
    const amplitude = value(row);
    return amplitude === null || !Number.isFinite(amplitude) ? '–' : voice.number(amplitude * perSI, amplitude === 0 ? 0 : Math.min(4, decimalsFor(amplitude * perSI, 5)));
  };
  const by = of ? ` ${of}` : '';
  return {
    name, unit: units[state], head: `${letter}${by}, ${unit}`,
    title: html`${symbolOf(letter)}${by} <span class="unit">${unit}</span>`, value: (row) => value(row), text, show: text,
  };
}

/**
 * Any figure.
 * @template Row
 * @param {{ name: string, unit: string, head: string, value: (row: Row) => number | null, digits: number, isSigned?: boolean, perSI?: number }} figure
 * @param {Voice} voice
 * @returns {OutColumn<Row>}
 */
export function figureColumn({ name, unit, head, value, digits, isSigned = false, perSI = 1 }, voice) {
  const text = (/** @type {Row} */ row) => {
    const figure = value(row);
    if (figure === null || !Number.isFinite(figure)) return '–';
    const sign = isSigned && figure > 0 ? '+' : '';
    return sign + voice.number(figure * perSI, figure === 0 ? 0 : Math.min(5, decimalsFor(figure * perSI, digits)));
  };
  return { name, unit, head, title: head, value, text, show: text };
}
