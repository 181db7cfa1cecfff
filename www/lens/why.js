import { LitElement, html } from 'lit';
import '../view/energy-bars.js';

/**
 * Why the swing grows, lasts or falls: the energy of a cycle, under the lens. Where there is little room it is folded.
 */
export class Why extends LitElement {
  static properties = { voice: { attribute: false }, energy: { attribute: false }, isVeiled: { attribute: false }, isRoomy: { state: true } };

  constructor() {
    super();
    /** @type {import('../words/voice.js').Voice | null} */ this.voice = null;
    /** @type {import('../engine/engine.js').Energy | null} */ this.energy = null;
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
    const { voice, energy, isVeiled } = this;
    if (!voice) return html``;
    const bars = html`<shimmy-energy-bars .voice=${voice} .energy=${energy} ?veiled=${isVeiled}></shimmy-energy-bars>`;
    return this.isRoomy ? bars : html`<details><summary>${voice.say('why.short')}</summary>${bars}</details>`;
  }

  #measure = () => {
    this.isRoomy = roomy.matches;
  };
}

/** As style/layout.css has it: beside the stage, and high enough. */
const roomy = matchMedia('(min-width: 1100px) and (min-height: 800px)');

customElements.define('shimmy-why', Why);
