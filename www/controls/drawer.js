import { LitElement, html } from 'lit';
import { tell } from '../command.js';
import { damperChoice } from '../object/fitting-choice.js';
import { grouped } from './groups.js';
import './knob.js';

/**
 * @typedef {import('./quantity.js').Quantity} Quantity
 * @typedef {import('../words/voice.js').Voice} Voice
 */

/** All values of the model, over the lens and never over the gear. Closed by the command `drawer`. */
export class Drawer extends LitElement {
  static properties = {
    object: { attribute: false },
    fittings: { attribute: false },
    quantities: { attribute: false },
    values: { attribute: false },
    links: { attribute: false },
    usual: { attribute: false },
    unstable: { attribute: false },
    swings: { attribute: false },
    explained: { attribute: false },
    voice: { attribute: false },
    isVeiled: { attribute: false },
  };

  constructor() {
    super();
    this.object = '';
    /** What can be fitted to it; nothing where it takes none. @type {Readonly<Record<'damper', readonly string[]>>} */
    this.fittings = { damper: [] };
    /** @type {Quantity[]} */ this.quantities = [];
    /** @type {Readonly<Record<string, number>>} */ this.values = {};
    /** Which values follow others. @type {Readonly<Record<string, boolean>>} */ this.links = {};
    /** @type {Readonly<Record<string, number>>} */ this.usual = {};
    /** Where the gear is unstable as one value varies. @type {(name: string) => import('./scent.js').Unstable | null} */
    this.unstable = () => null;
    /** How widely the gear swings as one value varies. @type {(name: string) => import('../run/swing-scent.js').Swings | null} */
    this.swings = () => null;
    /** The parameter that is explained just now. @type {string | null} */ this.explained = null;
    /** @type {Voice | null} */ this.voice = null;
    /** Whether what would tell the future is hidden. */
    this.isVeiled = false;
    /** @type {import('./knob.js').Change} */ this.change = () => null;
  }

  createRenderRoot() {
    return this;
  }

  connectedCallback() {
    super.connectedCallback();
    this.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape' || event.defaultPrevented) return;
      event.preventDefault();
      this.#close();
    });
  }

  render() {
    const { voice } = this;
    if (!voice) return html``;
    return html`
      <header>
        <h2>${voice.say('dock.all', { count: this.quantities.length })}</h2>
        <button type="button" class="framed" @click=${this.#close}>${voice.say('dock.close')}</button>
      </header>
      <div class="drawer-knobs">
        ${this.#groups.map(({ group, members }) => html`
          <section aria-label=${voice.say(`group.${group}`)}>
            <h3>${voice.say(`group.${group}`)}</h3>
            ${group === 'damper' ? damperChoice(this.fittings.damper, this.object, voice, this) : ''}
            ${members.map((quantity) => this.#knob(quantity, voice))}
          </section>`)}
      </div>`;
  }

  /** The groups, and the damper's where one could be fitted. */
  get #groups() {
    return grouped(this.quantities, this.fittings.damper.length > 0 ? ['damper'] : []);
  }

  /** @param {Quantity} quantity @param {Voice} voice */
  #knob(quantity, voice) {
    const { name } = quantity;
    return html`
      <shimmy-knob data-place="drawer" data-name=${name} .quantity=${quantity} .value=${this.values[name]} .usual=${this.usual[name]}
        .links=${this.links} .voice=${voice} .unstable=${this.isVeiled ? null : this.unstable(name)} .swings=${this.isVeiled ? null : this.swings(name)}
        .isExplained=${this.explained === name} .change=${this.change}></shimmy-knob>`;
  }

  firstUpdated() {
    this.querySelector('button')?.focus();
  }

  #close() {
    tell(this, 'drawer');
  }
}

customElements.define('shimmy-drawer', Drawer);
