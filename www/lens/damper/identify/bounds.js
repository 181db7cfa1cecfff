import { html } from 'lit';
import { symbolOf } from '../../../controls/symbol.js';
import { parseNumber } from '../../../words/number.js';
import { parameterName, writeValue } from './say.js';

/**
 * @typedef {import('../../../run/damper-looks.js').DamperTable} DamperTable
 * @typedef {import('../../../words/voice.js').Voice} Voice
 * @typedef {DamperTable['parameters'][number]} Parameter
 * @typedef {{ parameter: Parameter, place: number, low: number, high: number, isLog: boolean }} Gene a parameter that is looked for; `place`: in the table
 */

/** What the engine holds at its default unless bounds ask for it: the form of the model, and what no record at steady commands tells. */
const held = ['exponent', 'commandRate', 'forceScale'];
/** As the engine has it: bounds that span two decades are looked through by logarithms. */
const decades = 100;

/** The bounds of a parameter; null where it is held at its default. @param {Parameter} parameter @param {Readonly<Record<string, [number, number]>>} bounds @returns {[number, number] | null} */
function boundsOf({ name, min, max }, bounds) {
  const own = bounds[name];
  if (own) return own[0] < own[1] ? own : null;
  return held.includes(name) ? null : [min, max];
}

/** What is looked for. @param {DamperTable} table @param {Readonly<Record<string, [number, number]>>} bounds @returns {Gene[]} */
export function genesOf({ parameters }, bounds) {
  return parameters.flatMap((parameter, place) => {
    const [low, high] = boundsOf(parameter, bounds) ?? [0, 0];
    return low < high ? [{ parameter, place, low, high, isLog: low > 0 && (parameter.scale === 'log' || high / low >= decades) }] : [];
  });
}

/**
 * Where each parameter is looked for, to be typed, or held at its default.
 * @param {import('../identify.js').DamperIdentify} host @param {DamperTable} table @param {Voice} voice
 */
export function boundsTable(host, table, voice) {
  const { bench } = host;
  const put = (/** @type {string} */ name, /** @type {[number, number] | null} */ bounds) => {
    const { [name]: _, ...others } = bench.bounds;
    bench.bounds = bounds ? { ...others, [name]: bounds } : others;
    host.requestUpdate();
  };
  const field = (/** @type {Parameter} */ parameter, /** @type {[number, number]} */ range, /** @type {0 | 1} */ end) => html`
    <input type="text" inputmode="decimal" class="number" ?disabled=${bench.isBusy} .value=${writeValue(range[end], voice)}
      aria-label=${voice.say(end === 0 ? 'identify.low' : 'identify.high', { name: parameterName(parameter, voice) })}
      @change=${(/** @type {Event} */ event) => {
        const input = /** @type {HTMLInputElement} */ (event.target);
        const value = parseNumber(input.value);
        const next = /** @type {[number, number]} */ (end === 0 ? [value, range[1]] : [range[0], value]);
        if (Number.isFinite(value) && next[0] < next[1]) put(parameter.name, next);
        input.value = writeValue((bench.bounds[parameter.name] ?? range)[end], voice);
      }} />`;
  return html`
    <details class="bounds">
      <summary>${voice.say('identify.bounds', { count: genesOf(table, bench.bounds).length })}</summary>
      <div class="figures-table" role="region" tabindex="0" aria-label=${voice.say('identify.bounds.table')}><table>
        <thead><tr><th scope="col">${voice.say('identify.parameter')}</th><th scope="col">${voice.say('identify.looked')}</th><th scope="col">${voice.say('identify.from')}</th><th scope="col">${voice.say('identify.to')}</th><th scope="col"></th></tr></thead>
        <tbody>${table.parameters.map((parameter) => {
          const range = boundsOf(parameter, bench.bounds);
          const name = parameterName(parameter, voice);
          return html`<tr>
            <th scope="row">${symbolOf(parameter.symbol)} ${name}</th>
            <td><input type="checkbox" aria-label=${voice.say('identify.look', { name })} .checked=${range !== null} ?disabled=${bench.isBusy}
              @change=${(/** @type {Event} */ event) => put(parameter.name, /** @type {HTMLInputElement} */ (event.target).checked ? (held.includes(parameter.name) ? [parameter.min, parameter.max] : null) : [parameter.default, parameter.default])} /></td>
            ${range ? html`<td>${field(parameter, range, 0)}</td><td>${field(parameter, range, 1)}</td>` : html`<td colspan="2">${voice.say('identify.held', { value: writeValue(bench.bounds[parameter.name]?.[0] ?? parameter.default, voice) })}</td>`}
            <td>${parameter.unit === '1' ? '' : parameter.unit}</td></tr>`;
        })}</tbody>
      </table></div>
    </details>`;
}
