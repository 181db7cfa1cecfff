import { html, nothing } from 'lit';
import { tell } from '../../command.js';
import { withUnit } from '../../controls/quantity.js';
import { writeList } from '../../words/list.js';
import { readBeside, readyBesides, writeBeside } from './beside-settings.js';
import { readTyped } from './beside-typed.js';
import { parameterOption } from './option.js';
import { lowerName, plainSymbol, shortNumber } from './say.js';
import { rangeOf } from './settings.js';

/**
 * What one chooses of planes side by side: a comparison of the thesis, or any plane with any list of values, typed by hand,
 * and a second list if one likes.
 *
 * @typedef {import('../../controls/quantity.js').Quantity} Quantity
 * @typedef {import('../../words/voice.js').Voice} Voice
 * @typedef {import('./beside-settings.js').Beside} Beside
 * @typedef {{ list: number, text: string, why: string }} Refusal of what was typed for which list, and why
 */

/**
 * @param {import('./beside.js').BesidePlanes} host that tells the choice and keeps a refusal
 * @param {Beside} beside
 * @param {Voice} voice
 */
export function besideChoices(host, beside, voice) {
  const { quantities, refusal } = host;
  const say = (/** @type {string} */ shows) => tell(host, 'view', { of: 'beside', shows });
  const text = writeBeside(beside);
  const parameters = quantities.map(({ parameter }) => parameter);
  const ready = readyBesides.flatMap((one) => {
    const named = readBeside(one.text, parameters);
    return named ? [{ ...one, title: titleOf(host, named, voice) }] : [];
  });
  const isReady = ready.some((one) => one.text === text);
  const taken = [beside.x, beside.y, ...beside.lists].map(({ parameter }) => parameter);
  const chosen = (/** @type {Event} */ event) => host.quantity(/** @type {HTMLSelectElement} */ (event.target).value);
  const free = (/** @type {string} */ own) => quantities.filter(({ name }) => name === own || !taken.includes(name));

  const side = (/** @type {'x' | 'y'} */ which, /** @type {'stability.across' | 'stability.up'} */ word) => html`
    <select class="framed" aria-label=${voice.say(word)} title=${voice.say(word)} .value=${beside[which].parameter}
      @change=${(/** @type {Event} */ event) => {
        const quantity = chosen(event);
        if (quantity) say(writeBeside({ ...beside, [which]: rangeOf(quantity.parameter) }));
      }}>${free(beside[which].parameter).map((quantity) => parameterOption(quantity, beside[which].parameter, voice))}</select>`;

  /** Another parameter begins with the ends and the middle of its slider. @param {number} at @param {Quantity | undefined} quantity */
  const vary = (at, quantity) => {
    const lists = beside.lists.slice(0, at);
    const { min, max } = quantity?.parameter ?? { min: 0, max: 0 };
    if (quantity) lists.push({ parameter: quantity.name, values: [min, (min + max) / 2, max].map((value) => quantity.snapped(value)) });
    if (quantity && at === 0 && beside.lists[1]) lists.push(beside.lists[1]);
    say(writeBeside({ ...beside, lists }));
  };
  const list = (/** @type {number} */ at) => {
    const { parameter, values } = beside.lists[at] ?? { parameter: '', values: [] };
    const quantity = host.quantity(parameter);
    const refused = refusal?.list === at ? refusal : null;
    const written = quantity ? writeList(values.map((value) => shortNumber(quantity, value, voice))) : '';
    return html`
      <div class="list">
        <select class="framed" aria-label=${voice.say(at === 0 ? 'beside.varied' : 'beside.second')} .value=${parameter} @change=${(/** @type {Event} */ event) => vary(at, chosen(event))}>
          ${at > 0 ? html`<option value="" ?selected=${parameter === ''}>${voice.say('beside.one')}</option>` : nothing}
          ${free(parameter).map((one) => parameterOption(one, parameter, voice))}
        </select>
        ${quantity ? html`
          <input type="text" class="list-field" autocomplete="off" aria-label=${voice.say('beside.values', { name: lowerName(quantity, voice), unit: quantity.unit })}
            aria-invalid=${refused ? 'true' : 'false'} aria-describedby=${refused ? `beside-why-${at}` : nothing} .value=${refused?.text ?? written}
            @change=${(/** @type {Event} */ event) => {
              const typed = /** @type {HTMLInputElement} */ (event.target).value;
              const answer = readTyped(typed, { beside, at, quantity }, (values) => host.scene?.linear.eigenvalues(values), voice);
              host.refusal = typeof answer === 'string' ? { list: at, text: typed, why: answer } : null;
              if (typeof answer !== 'string') say(writeBeside(answer));
            }} />
          <span class="unit">${quantity.unit}</span>` : nothing}
        ${refused ? html`<p class="why-refused" id="beside-why-${at}" role="alert"><span aria-hidden="true">⚠ </span>${refused.why}</p>` : nothing}
      </div>`;
  };
  return html`
    <div class="beside-choices">
      <select class="framed ready" aria-label=${voice.say('beside.ready')} title=${voice.say('beside.ready')} .value=${isReady ? text : ''}
        @change=${(/** @type {Event} */ event) => { const { value } = /** @type {HTMLSelectElement} */ (event.target); if (value) say(value); }}>
        ${isReady ? nothing : html`<option value="" selected>${titleOf(host, beside, voice)}</option>`}
        ${ready.map((one) => html`<option value=${one.text} ?selected=${one.text === text}>${one.table ? voice.say('beside.table.of', { table: voice.say('atlas.Table', { number: one.table }), what: one.title }) : one.title}</option>`)}
      </select>
      <details ?open=${refusal !== null || !isReady}>
        <summary>${voice.say('beside.freely')}</summary>
        ${list(0)} ${list(1)}
        <div class="list">↑ ${side('y', 'stability.up')} → ${side('x', 'stability.across')}</div>
      </details>
    </div>`;
}

/** What is compared: `k 100 000, 50 000, 0 (e – v)`. @param {import('./beside.js').BesidePlanes} host @param {Beside} beside @param {Voice} voice */
function titleOf(host, { x, y, lists }, voice) {
  const symbol = (/** @type {string} */ name) => { const quantity = host.quantity(name); return quantity ? plainSymbol(quantity) : name; };
  const what = lists.map(({ parameter, values }) => {
    const quantity = host.quantity(parameter);
    if (!quantity) return '';
    const numbers = values.map((value) => shortNumber(quantity, value, voice));
    const text = lists.length > 1 || values.length > 4 ? `${numbers[0]} … ${numbers[numbers.length - 1]}` : numbers.join(voice.language === 'tr' ? '; ' : ', ');
    return `${plainSymbol(quantity)} ${withUnit(text, quantity.unit)}`;
  }).join(' × ');
  return `${what} (${voice.say('stability.ready', { up: symbol(y.parameter), across: symbol(x.parameter) })})`;
}
