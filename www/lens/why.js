import { LitElement, html } from 'lit';
import { hasSettled } from '../stage/verdict-line.js';
import '../view/energy-bars.js';

/**
 * Why the swing grows, lasts or falls: the energy of a cycle, under the lens. Where there is little room it is folded.
 */
export class Why extends LitElement {
  static properties = { voice: { attribute: false }, energy: { attribute: false }, outlook: { attribute: false }, isVeiled: { attribute: false }, isRoomy: { state: true } };

  constructor() {
    super();
    /** @type {import('../words/voice.js').Voice | null} */ this.voice = null;
    /** @type {import('../engine/engine.js').Energy | null} */ this.energy = null;
    /** @type {import('../engine/engine.js').Outlook | null} */ this.outlook = null;
    /** Whether what would tell the future is hidden. */
    this.isVeiled = false;
    this.isRoomy = roomy.matches;
  }

  createRenderRoot() {
    return this;
  }

  connectedCallback() {
    super.connectedCallback();
    roomy.addEventListener('change', this.#measure);
  }

  disconnectedCallback() {
    roomy.removeEventListener('change', this.#measure);
    super.disconnectedCallback();
  }

  render() {
    const { voice, energy, outlook, isVeiled } = this;
    if (!voice) return html``;
    const trend = outlook && !hasSettled(outlook, voice) ? outlook.present.trend : 'steady';
    const bars = html`<shimmy-energy-bars .voice=${voice} .energy=${energy} .trend=${trend} ?veiled=${isVeiled}></shimmy-energy-bars>`;
    return this.isRoomy ? bars : html`<details><summary>${voice.say('why.short')}</summary>${bars}</details>`;
  }

  #measure = () => {
    this.isRoomy = roomy.matches;
  };
}

/** As style/layout.css has it: beside the stage, and high enough. */
const roomy = matchMedia('(min-width: 1100px) and (min-height: 800px)');

customElements.define('shimmy-why', Why);
