import { LitElement, html } from 'lit';
import { tell } from '../../command.js';
import { isSameRecord } from '../../store.js';

/**
 * @typedef {import('../../controls/quantity.js').Quantity} Quantity
 * @typedef {import('../../run/linear-looks.js').LinearLooks} LinearLooks
 * @typedef {import('../../run/scene.js').Scene} Scene
 * @typedef {import('../../style/theme.js').Theme} Theme
 * @typedef {import('../../words/voice.js').Voice} Voice
 */

/**
 * What the views beside the plane share: each looks at the gear anew once one of its values has changed, and only then.
 */
export class Panel extends LitElement {
  static properties = {
    voice: { attribute: false }, quantities: { attribute: false }, settings: { attribute: false }, isVeiled: { attribute: false },
  };

  /** @type {Scene | null} */ scene = null;
  /** @type {Theme | null} */ theme = null;

  constructor() {
    super();
    /** @type {Voice | null} */ this.voice = null;
    /** @type {Quantity[]} */ this.quantities = [];
    /** What each lens shows, by its name. @type {Readonly<Record<string, string>>} */ this.settings = {};
    /** Whether what would tell the future is hidden. */ this.isVeiled = false;
  }

  createRenderRoot() {
    return this;
  }

  /** @param {Scene} scene @param {Theme} theme */
  draw(scene, theme) {
    const before = this.scene;
    const isSame = before !== null && this.theme === theme && before.object === scene.object && before.scales === scene.scales
      && isSameRecord(before.parameters, scene.parameters);
    this.scene = scene;
    this.theme = theme;
    if (!isSame) this.requestUpdate();
  }

  render() {
    const { voice, scene } = this;
    if (!voice || !scene) return html``;
    return this.isVeiled ? this.veil(voice) : this.content(voice, scene);
  }

  /** What is seen once it need not be guessed. @param {Voice} _voice @param {Scene} _scene @returns {unknown} */
  content(_voice, _scene) {
    return '';
  }

  /** What hides it. @param {Voice} voice @returns {unknown} */
  veil(voice) {
    return html`<p class="panel-veil"><span aria-hidden="true">?</span><span class="only-heard">${voice.say('energy.veiled')}</span></p>`;
  }

  updated() {
    for (const canvas of this.querySelectorAll('shimmy-canvas')) /** @type {import('../../view/canvas.js').Canvas} */ (canvas).redraw();
  }

  /** @param {string} name */
  quantity(name) {
    return this.quantities.find((one) => one.name === name);
  }

  /** Whether linear theory speaks of a swing inside the gap alone. */
  get isGapped() {
    return this.scene?.linear.isGapped ?? false;
  }

  /** What of this gear linear theory leaves out. */
  get leavesOut() {
    return this.scene?.linear.leavesOut ?? null;
  }

  /** Gives the gear values, which are undone together. @param {Record<string, number>} values in SI */
  put(values) {
    tell(this, 'point', { values, gesture: null });
    tell(this, 'settle');
  }

  /**
   * What linear theory answers; null where the values are so wild that no number comes of them.
   * @template Answer
   * @param {(linear: LinearLooks) => Answer} question
   */
  ask(question) {
    try {
      return this.scene ? question(this.scene.linear) : null;
    } catch {
      return null;
    }
  }
}
