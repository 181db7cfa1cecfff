import { html } from 'lit';
import { tell } from '../../command.js';
import { chosenMode, modeChoices } from '../../run/modes.js';
import '../../view/canvas.js';
import '../../view/energy-bars.js';
import { drawPhasors } from '../../view/phasors.js';
import { decimalsFor } from '../../words/number.js';
import { armsOf, phaseOf, statesOf } from './mode-shape.js';
import { Panel } from './panel.js';
import { rateOf, signed } from './say.js';

/**
 * @typedef {import('../../run/linear-looks.js').Mode} Mode
 * @typedef {import('../../words/voice.js').Voice} Voice
 */

const circle = 2 * Math.PI;

/**
 * The modes of the gear: which root, how the states swing together at it, how fast that grows or falls, and why. Command:
 * `view` with the mode, which also moves as a ghost on the gear.
 */
export class Modes extends Panel {
  /** @type {Mode | null} */ #mode = null;

  /** @param {Voice} voice */
  content(voice) {
    const choices = this.ask((linear) => modeChoices(linear.modes())) ?? [];
    const chosen = chosenMode(choices, this.settings.mode ?? '');
    this.#mode = chosen?.mode ?? null;
    if (!chosen) return html`<p class="panel-empty">${voice.say('stability.none')}</p>`;
    const { mode } = chosen;
    const states = statesOf(mode).map((one) => `${one.plain} ${phaseOf(mode, one.name, voice)}`.trim()).join(', ');
    return html`
      <div class="panel-scroll modes" tabindex="0" role="group" aria-label=${voice.say('stability.view.modes')}>
        <fieldset class="mode-choices">
          <legend class="only-heard">${voice.say('modes.choose')}</legend>
          ${choices.map((one) => html`
            <label class="framed">
              <input type="radio" name="mode" .checked=${one === chosen} @change=${() => tell(this, 'view', { of: 'mode', shows: one.name })} />
              <span>${rootInWords(one.mode, voice)}</span>
            </label>`)}
          ${this.leavesOut ? html`<span class="theory">${voice.say(this.leavesOut === 'gap' ? 'panel.theory' : 'panel.theory.frictionless')}</span>` : ''}
        </fieldset>
        <div class="phasors"><shimmy-canvas .label=${voice.say('modes.phasors', { states })} .paint=${this.#paint}></shimmy-canvas></div>
        <dl class="mode-facts">${facts(mode, voice)}</dl>
        <shimmy-energy-bars areRates .isReal=${mode.eigenvalue.im === 0} .voice=${voice} .energy=${mode.energyFlow}></shimmy-energy-bars>
      </div>`;
  }

  /** @type {import('../../view/canvas.js').Paint} */
  #paint = (context, size) => {
    const { voice, theme, scene } = this;
    const mode = this.#mode;
    if (!voice || !theme || !scene || !mode) return;
    const { re, im } = mode.eigenvalue;
    const swings = im > 0;
    const factor = Math.exp((circle * re) / im);
    drawPhasors(context, size, {
      arms: armsOf(mode, scene.parameters, voice), growth: swings ? re / im : Math.sign(re), swings,
      readings: swings ? [voice.say('modes.cycle', { factor: voice.number(factor, Math.max(2, decimalsFor(factor, 2))) })] : [],
    }, theme);
  };
}

/** A mode by its root: `52.1 Hz, grows 12.3 s⁻¹`. @param {Mode} mode @param {Voice} voice */
function rootInWords({ eigenvalue: { re, im } }, voice) {
  if (im === 0) return voice.say('modes.real', { rate: signed(re, voice) });
  const what = re > 0 ? 'grows' : re < 0 ? 'falls' : 'lasts';
  return voice.say(`modes.pair.${what}`, { frequency: voice.number(im / circle, 1), rate: rateOf(re, voice) });
}

/** Its numbers, each with its name. @param {Mode} mode @param {Voice} voice */
function facts(mode, voice) {
  const { eigenvalue: { re, im }, dampingRatio, timeToDouble, timeToHalf } = mode;
  const time = timeToDouble ?? timeToHalf;
  const lasts = time === null ? null : time * 1000;
  const rows = [
    [voice.say('modes.frequency'), im > 0 ? `${voice.number(im / circle, 2)} Hz` : voice.say('modes.noSwing')],
    [voice.say('modes.rate'), `${signed(re, voice)} ${voice.say('stability.perSecond')}`],
    [voice.say('modes.ratio'), dampingRatio === null ? '–' : voice.number(dampingRatio, 4)],
    lasts === null ? ['', voice.say('modes.ever')] : [voice.say(timeToDouble === null ? 'modes.half' : 'modes.double'), `${voice.number(lasts, decimalsFor(lasts, 3))} ms`],
  ];
  const shape = statesOf(mode).slice(1).map(({ name, label, unit, perDegree }) => ({ label, text: `${voice.number(perDegree, decimalsFor(perDegree, 3))} ${unit}`, phase: phaseOf(mode, name, voice) }));
  return html`
    ${rows.map(([name, value]) => html`<div><dt>${name}</dt><dd>${value}</dd></div>`)}
    <div class="shape"><dt>${voice.say('modes.shape')}</dt>${shape.map(({ label, text, phase }) => html`<dd>${label} ${text} <span>${phase}</span></dd>`)}</div>`;
}

customElements.define('shimmy-modes', Modes);
