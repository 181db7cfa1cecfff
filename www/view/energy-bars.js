import { LitElement, html } from 'lit';
import { styleMap } from 'lit/directives/style-map.js';
import { balanceOf, energyWriter, rateWriter } from './energy-balance.js';

/**
 * @typedef {import('./energy-balance.js').Energy} Energy
 * @typedef {import('./energy-balance.js').Part} Part
 * @typedef {import('../words/voice.js').Voice} Voice
 */

/** A part shorter than this share of a bar may have no room for its number: the sentence says it. */
const small = 0.2;

/**
 * Why a swing grows, lasts or falls: what the tire feeds in over a cycle against what damper and tread take out; with
 * `areRates`, the same of a mode, each part as the growth rate that it alone would give.
 * `veiled` hides all of it until it has been guessed.
 */
export class EnergyBars extends LitElement {
  static properties = { energy: { attribute: false }, voice: { attribute: false }, veiled: { type: Boolean }, areRates: { type: Boolean }, isReal: { type: Boolean }, trend: { attribute: false } };

  constructor() {
    super();
    /** @type {Energy | null} */ this.energy = null;
    /** @type {Voice | null} */ this.voice = null;
    this.veiled = false;
    this.areRates = false;
    /** What is said of the swing beside: where it grows or falls too slowly for the bars. @type {import('../engine/engine.js').Outlook['present']['trend']} */
    this.trend = 'steady';
    /** Of a mode without a swing, which has no cycle. */ this.isReal = false;
  }

  createRenderRoot() {
    return this;
  }

  render() {
    const { voice } = this;
    if (!voice) return html``;
    if (this.veiled) {
      return html`
        <h2>${voice.say('energy.name')}</h2>
        <p class="veil"><span aria-hidden="true">?</span><span class="only-heard">${voice.say('energy.veiled')}</span></p>`;
    }
    const { trend, fed, taken, rest, whole } = balanceOf(this.energy);
    const slow = trend === 'lasts' ? { growing: /** @type {const} */ ('grows'), falling: /** @type {const} */ ('falls'), steady: null }[this.trend] : null;
    if (trend === 'rests') return html`<h2>${voice.say('energy.name')}</h2><p class="sentence">${voice.say('energy.rests')}</p>`;
    const write = this.areRates ? rateWriter(whole, voice) : energyWriter(whole, voice);
    const title = voice.say(this.areRates ? `modes.energy.${trend}.${this.isReal ? 'real' : 'title'}` : `energy.${slow ?? trend}.title`);
    const sentence = voice.say(this.areRates ? `modes.energy.${trend}` : slow ? 'energy.slow' : `energy.${trend}`, { value: write(rest) });
    const bar = (/** @type {Part} */ { element, value }, isNamed = true) => html`
      <span class="part ${element}" style=${styleMap({ flexGrow: String(value / whole) })}>
        <span class="label"><b>${write(value)}</b>${isNamed ? html` <span>${voice.say(`energy.${element}`)}</span>` : ''}</span>
      </span>`;
    const isUnusual = (/** @type {Part} */ { element, value }) => element === 'tire' || value < small * whole;
    const said = (/** @type {Part} */ { element, value }) =>
      voice.say('energy.takes', { element: voice.say(`energy.${element}.full`), value: write(value) });
    const remainder = html`
      <span class="part remainder ${trend}" style=${styleMap({ flexGrow: String(rest / whole) })}><span class="label"><b>${trend === 'grows' ? '+' : '−'}${write(rest)}</b></span></span>`;
    return html`
      <h2>${title}</h2>
      <dl>
        <dt>${voice.say('energy.in')}</dt>
        <dd>${fed.map((one) => bar(one, one.element !== 'tire'))}${trend === 'falls' ? remainder : ''}</dd>
        <dt>${voice.say('energy.out')}</dt>
        <dd>${taken.map((one) => bar(one))}${trend === 'grows' ? remainder : ''}</dd>
      </dl>
      <p class="sentence">${[sentence, ...taken.filter(isUnusual).map(said)].join(' ')}</p>`;
  }
}

customElements.define('shimmy-energy-bars', EnergyBars);
