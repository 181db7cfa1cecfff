import { LitElement, html } from 'lit';
import { tell } from '../command.js';
import '../view/canvas.js';
import { drawPhasePortrait } from '../view/phase-portrait.js';
import { decimalsFor } from '../words/number.js';

/**
 * @typedef {import('../engine/engine.js').Outlook} Outlook
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {import('../run/scene.js').Scene} Scene
 */

const degrees = 180 / Math.PI;

/** The lens *Phase*: ψ̇ over ψ, and in one line the motion it settles on. */
export class PhaseLens extends LitElement {
  static properties = { outlook: { attribute: false }, voice: { attribute: false }, shows: { attribute: false }, isVeiled: { attribute: false } };

  /** @type {Scene | null} */ #scene = null;
  /** @type {Theme | null} */ #theme = null;

  constructor() {
    super();
    /** @type {Outlook | null} */ this.outlook = null;
    /** @type {Voice | null} */ this.voice = null;
    /** Whether what would tell the future is hidden. */
    this.isVeiled = false;
    /** Which of its views. */ this.shows = '';
  }

  createRenderRoot() {
    return this;
  }

  render() {
    const { voice, outlook } = this;
    if (!voice) return html``;
    return html`
      <shimmy-canvas .label=${voice.say('phase.name')} .paint=${this.#paint}></shimmy-canvas>
      <footer>
        <p class="destination">${outlook ? destination(outlook, voice) : ''}</p>
        <button type="button" class="framed" title="${voice.say('phase.fit.does')} (0)" @click=${() => tell(this, 'fit')}>
          ${voice.say('phase.fit')}
        </button>
      </footer>`;
  }

  /** @param {Scene} scene @param {Theme} theme */
  draw(scene, theme) {
    this.#scene = scene;
    this.#theme = theme;
    /** @type {import('../view/canvas.js').Canvas | null} */ (this.querySelector('shimmy-canvas'))?.redraw();
  }

  /** @type {import('../view/canvas.js').Paint} */
  #paint = (context, size) => {
    const { voice } = this;
    const scene = this.#scene;
    const theme = this.#theme;
    if (!voice || !scene || !theme) return;
    const { outlook, scales, orbitPast, state, parameters } = scene;
    drawPhasePortrait(context, size, {
      limits: scales.limits,
      trail: orbitPast,
      orbit: outlook.orbit,
      orbitLabel: voice.say(`phase.heads.${outlook.verdict}`),
      state,
      freeplay: parameters.freeplayAngle ?? 0,
    }, theme, voice);
  };
}

/**
 * @param {Outlook} outlook
 * @param {Voice} voice
 */
export function destination({ verdict, amplitude, frequency }, voice) {
  if (verdict === 'rests') return voice.say('phase.rest');
  if (verdict === 'dies-out') return voice.say('phase.none');
  if (verdict === 'grows' || !frequency) return voice.say('phase.grows');
  return voice.say(verdict === 'rattles' ? 'phase.rattle' : 'phase.cycle', {
    degrees: `±${voice.number(amplitude.torsionAngle * degrees, 3)}°`,
    radians: voice.number(amplitude.torsionAngle, decimalsFor(amplitude.torsionAngle, 5)),
    frequency: voice.number(frequency, 2),
  });
}

customElements.define('shimmy-phase-lens', PhaseLens);
