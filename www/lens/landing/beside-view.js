import { html } from 'lit';
import { tell } from '../../command.js';
import '../../view/canvas.js';
import { drawRollMultiple } from '../../view/roll-multiple.js';
import { roundLimit } from '../../view/scale.js';
import { cases, currents, dampings } from './cases.js';
import { angleOf, speedOf } from './say.js';
import { SetPanel } from './set-panel.js';
import { durationOf } from './settings.js';

/**
 * @typedef {import('../../words/voice.js').Voice} Voice
 * @typedef {import('./cases.js').Case} Case
 */

const degree = Math.PI / 180;

/** Figures 7.27 – 7.42 as small multiples, with the gear's other values and its landing. A press has that gear land: command `land`. */
export class LandingBeside extends SetPanel {
  /** @param {Voice} voice */
  content(voice) {
    const quantity = this.quantity('dampingConstant');
    const velocity = this.quantity('velocity');
    if (!quantity || !velocity) return html`<p class="panel-empty">${voice.say('landing.foreign')}</p>`;
    const amperes = (/** @type {number} */ current) => `${voice.number(current, current % 1 === 0 ? 0 : current % 0.5 === 0 ? 1 : 2)} A`;
    return html`
      <div class="landing-beside" role="group" aria-label=${voice.say('landing.view.beside')}>
        <span class="corner" aria-hidden="true">${quantity.parameter.symbol} \\ I</span>
        ${currents.map((current) => html`<span class="head" aria-hidden="true">${amperes(current)}</span>`)}
        ${dampings.map((damping, row) => html`
          <span class="side" aria-hidden="true">${voice.number(damping, 0)}</span>
          ${currents.map((current, column) => {
            const at = row * currents.length + column;
            const said = voice.say('landing.beside.press', { damping: quantity.write(damping, voice), current: amperes(current), what: this.#inWords(at, velocity, voice) });
            return html`<button type="button" class="multiple" aria-pressed=${this.isNow(cases[at]) ? 'true' : 'false'} title=${said} aria-label=${said} @click=${() => tell(this, 'land', cases[at])}>
              <shimmy-canvas aria-hidden="true" .paint=${this.#paints[at]}></shimmy-canvas></button>`;
          })}`)}
      </div>`;
  }

  /** What became of a landing. @param {number} at @param {import('../../controls/quantity.js').Quantity} velocity @param {Voice} voice */
  #inWords(at, velocity, voice) {
    const item = this.rolls?.items[at];
    if (!item?.answer) return voice.say(item?.isFailed ? 'landing.failed' : 'landing.working');
    const { begins, ends, widest } = item.answer.shimmy;
    if (!begins) return voice.say('landing.beside.calm');
    return voice.say('landing.beside.shimmies', { angle: angleOf(widest.angle, voice), from: speedOf(begins.velocity, velocity, voice), to: ends ? speedOf(ends.velocity, velocity, voice) : '–' });
  }

  #paints = cases.map((_, at) => (/** @type {CanvasRenderingContext2D} */ context, /** @type {import('../../view/canvas.js').Size} */ size) => this.#paint(at, context, size));

  /** @param {number} at @param {CanvasRenderingContext2D} context @param {import('../../view/canvas.js').Size} size */
  #paint(at, context, size) {
    const { theme, voice, rolls } = this;
    if (!theme || !voice || !rolls) return;
    const item = rolls.items[at];
    const widest = Math.max(2 * degree, ...rolls.items.map(({ answer }) => answer?.shimmy.widest.angle ?? 0));
    const shimmy = item?.answer?.shimmy;
    drawRollMultiple(context, size, {
      band: item?.answer?.stretches ?? null, end: durationOf(this.roll), limit: roundLimit(widest / degree) * degree, threshold: item?.answer?.threshold ?? degree,
      note: item?.isFailed ? '–' : shimmy?.begins ? `±${angleOf(shimmy.widest.angle, voice)}` : '', isShimmy: Boolean(shimmy?.begins), isNow: this.isNow(cases[at]), isOld: item?.isOld ?? true,
    }, theme);
  }
}

customElements.define('shimmy-landing-beside', LandingBeside);
