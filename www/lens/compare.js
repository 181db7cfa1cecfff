import { html } from 'lit';
import { tell } from '../command.js';
import { mannerOf } from '../stage/manner.js';
import '../view/compare-table.js';
import { drawPhasePortrait } from '../view/phase-portrait.js';
import { PlotLens } from './plot-lens.js';

/**
 * @typedef {import('../engine/engine.js').Outlook} Outlook
 * @typedef {import('../view/compare-table.js').Compared} Compared
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
      <shimmy-compare-table .voice=${voice} .rows=${this.#rows(voice)}
        @pin=${() => tell(this, 'pin')} @unpin=${(/** @type {CustomEvent} */ event) => tell(this, 'unpin', event.detail)}></shimmy-compare-table>`;
  }

  /** The run first, then the ghosts, as soon as they have been looked at. @param {Voice} voice @returns {Compared[]} */
  #rows(voice) {
    const { outlook, energy, ghosts, scene, isVeiled } = this;
    if (!scene || (!outlook && !isVeiled)) return [];
    const runs = [
      { changes: [], goal: outlook, exchanged: energy },
      ...ghosts.map((ghost) => ({ changes: this.#changes(ghost.live.parameters, scene.parameters, voice), goal: ghost.outlook, exchanged: ghost.energy })),
    ];
    if (isVeiled) return runs.map(({ changes }) => ({ changes, becomes: null }));
    return runs.flatMap(({ changes, goal, exchanged }) => (goal ? [{ changes, becomes: becomesOf(goal, exchanged) }] : []));
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
      ghosts: this.ghostsOf(scene, voice),
      veiled: this.isVeiled,
    }, theme, voice);
  }
}

/** @param {Outlook} goal @param {import('../engine/engine.js').Energy | null} energy @returns {Compared['becomes']} */
function becomesOf(goal, energy) {
  return { manner: mannerOf(goal), amplitude: goal.amplitude.torsionAngle, frequency: goal.frequency ?? goal.present.frequency, energy };
}

customElements.define('shimmy-compare-lens', CompareLens);
