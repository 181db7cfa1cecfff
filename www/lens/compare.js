import { html } from 'lit';
import { tell } from '../command.js';
import { mannerOf } from '../stage/manner.js';
import '../view/compare-table.js';
import { drawPhasePortrait } from '../view/phase-portrait.js';
import { PlotLens } from './plot-lens.js';

/**
 * @typedef {import('../engine/engine.js').Outlook} Outlook
 * @typedef {import('../words/voice.js').Voice} Voice
 */

/**
 * The lens *Compare*: the run and its ghosts in one phase portrait, and their numbers in a table. Pins the run, lets
 * ghosts go.
 */
export class CompareLens extends PlotLens {
  static properties = { ...PlotLens.properties, energy: { attribute: false } };

  constructor() {
    super();
    /** @type {import('../engine/engine.js').Energy | null} */ this.energy = null;
  }

  /** @param {Voice} voice */
  label(voice) {
    return voice.say('compare.portrait');
  }

  /** @param {Voice} voice */
  line(voice) {
    return html`
      <button type="button" class="plain" ?disabled=${this.ghosts.length === 0} @click=${() => tell(this, 'unpinAll')}>${voice.say('compare.clear')}</button>`;
  }

  /** @param {Voice} voice */
  plot(voice) {
    return html`
      ${super.plot(voice)}
      <shimmy-compare-table .voice=${voice} .rows=${this.#rows(voice)} ?veiled=${this.isVeiled}
        @pin=${() => tell(this, 'pin')} @unpin=${(/** @type {CustomEvent} */ event) => tell(this, 'unpin', event.detail)}></shimmy-compare-table>`;
  }

  /** The run first, then the ghosts. @param {Voice} voice @returns {import('../view/compare-table.js').Compared[]} */
  #rows(voice) {
    const { outlook, energy, ghosts, scene } = this;
    if (!outlook || !scene) return [];
    const numbersOf = (/** @type {Outlook} */ goal) =>
      ({ manner: mannerOf(goal), amplitude: goal.amplitude.torsionAngle, frequency: goal.frequency ?? goal.present.frequency });
    return [{ changes: [], ...numbersOf(outlook), energy }, ...ghosts.flatMap((ghost) => (ghost.outlook
      ? [{ changes: this.#changes(ghost.live.parameters, scene.parameters, voice), ...numbersOf(ghost.outlook), energy: ghost.energy }] : []))];
  }

  /** @param {Readonly<Record<string, number>>} values @param {Readonly<Record<string, number>>} others @param {Voice} voice */
  #changes(values, others, voice) {
    return this.quantities.filter(({ name }) => values[name] !== others[name])
      .map((quantity) => ({ symbol: quantity.parameter.symbol, text: quantity.write(values[quantity.name], voice) }));
  }

  /** @type {PlotLens['paintScene']} */
  paintScene(context, size, scene, theme, voice) {
    const { outlook, scales, orbitPast, state, parameters } = scene;
    drawPhasePortrait(context, size, {
      limits: scales.limits, trail: orbitPast, orbit: outlook.orbit, orbitLabel: voice.say(`phase.heads.${mannerOf(outlook)}`), state,
      exposed: scene.exposed,
      freeplay: parameters.freeplayAngle ?? 0,
      ghosts: scene.ghosts.map((ghost) => ({ label: this.labelOf(scene, ghost, voice), trail: ghost.orbitPast })),
      veiled: this.isVeiled,
    }, theme, voice);
  }
}

customElements.define('shimmy-compare-lens', CompareLens);
