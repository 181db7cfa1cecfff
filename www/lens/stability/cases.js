/**
 * What linear theory says of the thesis' cases (table 5.7), as a table and as a file.
 *
 * @typedef {import('../../run/linear-histories.js').Case} Case
 * @typedef {import('../../words/voice.js').Voice} Voice
 */

import { html } from 'lit';
import { symbolOf } from '../../controls/symbol.js';
import { tableCsv } from '../../out/table-csv.js';
import { decimalsFor, decimalsOf } from '../../words/number.js';

const circle = 2 * Math.PI;

/**
 * @param {Voice} voice
 * @param {(one: Case) => void} set what a press on a case does
 * @returns {import('./figures-table.js').Column<Case>[]}
 */
export function casesColumns(voice, set) {
  const plain = (/** @type {number} */ value) => voice.number(value, decimalsOf(value, 0));
  const parameter = (/** @type {'velocity' | 'dampingConstant'} */ name, /** @type {string} */ symbol, /** @type {boolean} */ isFirst) => ({
    name, title: symbolOf(symbol), value: (/** @type {Case} */ { parameters }) => parameters[name],
    show: (/** @type {Case} */ one) => {
      const text = plain(one.parameters[name]);
      const does = voice.say('cases.set', { v: plain(one.parameters.velocity), c: plain(one.parameters.dampingConstant) });
      return isFirst ? html`<button type="button" class="plain" title=${does} aria-label=${does} @click=${() => set(one)}>${text}</button>` : text;
    },
  });
  return [
    parameter('velocity', 'v', true), parameter('dampingConstant', 'c', false),
    {
      name: 'becomes', title: voice.say('cases.becomes'), isWord: true, value: (one) => Number(growthOf(one) > 0),
      show: (one) => html`<span class=${growthOf(one) > 0 ? 'is-unstable' : ''}>${growthOf(one) > 0 ? '▴ ' : '▾ '}${voice.say(growthOf(one) > 0 ? 'cases.grows' : 'cases.falls')}</span>`,
    },
    { name: 'rate', title: voice.say('cases.rate'), value: growthOf, show: (one) => `${growthOf(one) > 0 ? '+' : ''}${voice.number(growthOf(one), decimalsFor(growthOf(one), 3))}` },
    {
      name: 'time', title: voice.say('cases.time'), value: (one) => timeOf(one) * 1000,
      show: (one) => voice.say(growthOf(one) > 0 ? 'cases.doubles' : 'cases.halves', { time: voice.number(timeOf(one) * 1000, decimalsFor(timeOf(one) * 1000, 3)) }),
    },
    { name: 'frequency', title: voice.say('cases.frequency'), value: frequencyOf, show: (one) => { const frequency = frequencyOf(one); return frequency === null ? '–' : voice.number(frequency, 2); } },
    { name: 'figures', title: voice.say('cases.figures'), value: ({ figures }) => Number(figures[0].split('.')[1]), show: ({ figures }) => figures.join(', ') },
  ];
}

/** In SI, with units in the header. @param {readonly Case[]} cases */
export function casesCsv(cases) {
  return tableCsv([
    { name: 'velocity', unit: 'm/s' }, { name: 'dampingConstant', unit: 'N m s/rad' }, { name: 'becomes', unit: '' }, { name: 'growthRate', unit: '1/s' },
    { name: 'timeToDouble', unit: 's' }, { name: 'timeToHalf', unit: 's' }, { name: 'frequency', unit: 'Hz' }, { name: 'figures', unit: '' },
  ], cases.map((one) => {
    const grows = growthOf(one) > 0;
    const { velocity, dampingConstant } = one.parameters;
    return [velocity, dampingConstant, grows ? 'grows' : 'decays', growthOf(one), grows ? timeOf(one) : null, grows ? null : timeOf(one), frequencyOf(one), one.figures.join(' ')];
  }));
}

/** Of the leading root, in 1/s. @param {Case} one */
export const growthOf = ({ roots }) => roots[0].re;

/** How long a swing takes to double or to halve, in s. @param {Case} one */
export const timeOf = (one) => Math.LN2 / Math.abs(growthOf(one));

/** Of what swings, in Hz; null where nothing does. @param {Case} one */
export function frequencyOf({ roots }) {
  const pair = roots.find(({ im }) => im > 0);
  return pair ? pair.im / circle : null;
}
