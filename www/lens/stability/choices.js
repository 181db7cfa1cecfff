import { html } from 'lit';
import { tell } from '../../command.js';
import { symbolOf } from '../../controls/symbol.js';
import { parameterOption } from './option.js';
import { colorings, rangeOf, readyPlanes, writePlane } from './settings.js';
import { lowerName, plainSymbol } from './say.js';

/**
 * What one chooses of a plane: a ready one, or any two parameters, and the color.
 *
 * @typedef {import('../../controls/quantity.js').Quantity} Quantity
 * @typedef {import('../../words/voice.js').Voice} Voice
 * @typedef {import('./settings.js').Plane} Plane
 */

/**
 * @param {HTMLElement} host that tells the choice
 * @param {Plane} plane
 * @param {readonly Quantity[]} quantities
 * @param {Voice} voice
 * @param {{ isOpen: boolean, toggle: () => void }} fold the ranges are folded away, and where there is little room all but the ready ones
 * @param {Readonly<Record<'x' | 'y', import('./range-fields.js').RangeFields>>} ends
 */
export function planeChoices(host, plane, quantities, voice, { isOpen, toggle }, ends) {
  const choose = (/** @type {Partial<Plane>} */ change) => tell(host, 'view', { of: 'plane', shows: writePlane({ ...plane, ...change }) });
  const byName = (/** @type {string} */ name) => quantities.find((one) => one.name === name);
  const ranged = (/** @type {Quantity} */ quantity) => rangeOf(quantity.parameter);
  /** A side takes a parameter; where the other side has it they change places. @param {'x' | 'y'} side @param {string} name */
  const put = (side, name) => {
    const [quantity, other] = [byName(name), side === 'x' ? 'y' : 'x'];
    if (!quantity) return;
    choose(plane[/** @type {'x' | 'y'} */ (other)].parameter === name ? { x: plane.y, y: plane.x } : { [side]: ranged(quantity) });
  };
  const side = (/** @type {'x' | 'y'} */ which, /** @type {'stability.across' | 'stability.up'} */ word) => html`
    <select class="framed folded" aria-label=${voice.say(word)} title=${voice.say(word)} .value=${plane[which].parameter}
      @change=${(/** @type {Event} */ event) => put(which, /** @type {HTMLSelectElement} */ (event.target).value)}>
      ${quantities.map((quantity) => parameterOption(quantity, plane[which].parameter, voice))}
    </select>`;
  return html`
    <div class=${isOpen ? 'plane-choices folding is-open' : 'plane-choices folding'}>
      ${readyPlanes.map(({ x, y }) => {
        const [across, up] = [byName(x), byName(y)];
        if (!across || !up) return '';
        const short = voice.say('stability.ready', { up: plainSymbol(up), across: plainSymbol(across) });
        const does = voice.say('stability.ready.does', { short, up: lowerName(up, voice), across: lowerName(across, voice) });
        return html`<button type="button" class="framed ready" aria-label=${does} title=${does} aria-pressed=${plane.x.parameter === x && plane.y.parameter === y ? 'true' : 'false'}
          @click=${() => choose({ x: ranged(across), y: ranged(up) })}>${short}</button>`;
      })}
      <button type="button" class="framed icon fold" aria-label=${voice.say('stability.fold')} title=${voice.say('stability.fold')} aria-expanded=${isOpen ? 'true' : 'false'}
        @click=${toggle}>⋯</button>
      ${side('y', 'stability.up')}
      <button type="button" class="framed icon swap folded" aria-label=${voice.say('stability.swap')} title=${voice.say('stability.swap')}
        @click=${() => choose({ x: plane.y, y: plane.x })}>⇄</button>
      ${side('x', 'stability.across')}
      <select class="framed folded" aria-label=${voice.say('stability.color')} title=${voice.say('stability.color')} .value=${plane.coloring}
        @change=${(/** @type {Event} */ event) => choose({ coloring: /** @type {Plane['coloring']} */ (/** @type {HTMLSelectElement} */ (event.target).value) })}>
        ${colorings.map((coloring) => html`<option value=${coloring} ?selected=${coloring === plane.coloring}>${voice.say(`stability.color.${coloring}`)}</option>`)}
      </select>
      ${isOpen ? /** @type {const} */ (['y', 'x']).map((which) => html`
        <span class="ends">${symbolOf(byName(plane[which].parameter)?.parameter.symbol ?? '')} ${ends[which].fields(plane[which], (range) => choose({ [which]: range }), voice)}</span>`) : ''}
      ${isOpen ? /** @type {const} */ (['y', 'x']).map((which) => ends[which].why(plane[which])) : ''}
    </div>`;
}
