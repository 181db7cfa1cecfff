import { html } from 'lit';
import { tell } from '../command.js';
import { limitsFor } from '../run/fit.js';
import { mannerOf } from '../stage/manner.js';
import '../view/compare-table.js';
import { drawPhasePortrait } from '../view/phase-portrait.js';
import { orbitLabel } from './destination.js';
import { PlotLens } from './plot-lens.js';

/**
 * @typedef {import('../engine/engine.js').Outlook} Outlook
 * @typedef {import('../view/compare-table.js').Compared} Compared
 * @typedef {import('../words/voice.js').Voice} Voice
 */

/**
 * The lens *Compare*: the run and its ghosts in one phase portrait, and in a table what each of them comes to. Pins the run,
 * lets ghosts go.
 */
export class CompareLens extends PlotLens {
  /** Of each outlook, asked for once. @type {WeakMap<Outlook, import('../engine/engine.js').Energy | null>} */ #settled = new WeakMap();

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
    const { outlook, ghosts, scene, isVeiled } = this;
    if (!scene || (!outlook && !isVeiled)) return [];
    const runs = [
      { changes: [], goal: outlook, of: scene.object, values: scene.parameters },
      ...ghosts.map(({ live, outlook: goal, kept }) => ({ changes: this.#changes(live.parameters, scene.parameters, voice), goal, of: kept.object, values: live.parameters })),
    ];
    if (isVeiled) return runs.map(({ changes }) => ({ changes, becomes: null }));
    return runs.flatMap(({ changes, goal, of, values }) => (goal ? [{ changes, becomes: becomesOf(goal, this.#energyOf(scene, goal, of, values)) }] : []));
  }

  /** Of the motion that a run comes to, as its amplitude and frequency are. @param {NonNullable<PlotLens['scene']>} scene @param {Outlook} goal @param {string} of @param {Readonly<Record<string, number>>} values */
  #energyOf(scene, goal, of, values) {
    let energy = this.#settled.get(goal);
    if (energy === undefined) {
      try {
        energy = scene.energySettled(of, values, goal);
      } catch {
        // Values so wild that the engine counts no cycle.
        energy = null;
      }
      this.#settled.set(goal, energy);
    }
    return energy;
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
      limits: this.isVeiled ? scales.limits : limitsWith(scales.limits, [outlook, ...scene.ghosts.flatMap(({ outlook: goal }) => goal ?? [])]), trail: orbitPast, orbit: outlook.orbit, orbitLabel: orbitLabel(outlook, voice), state,
      exposed: scene.exposed,
      freeplay: parameters.freeplayAngle ?? 0,
      ghosts: this.ghostsOf(scene, voice),
      veiled: this.isVeiled,
    }, theme, voice);
  }
}

/**
 * Axes that hold the cycles that the run and its ghosts go to, as far as they go within the axes' reach at all.
 * @param {import('../run/fit.js').Swing} limits @param {readonly Outlook[]} goals
 */
function limitsWith(limits, goals) {
  const most = (/** @type {'torsionAngle' | 'torsionRate'} */ name, /** @type {number} */ least) =>
    goals.reduce((largest, { orbit }) => orbit[name].reduce((one, value) => Math.max(one, Math.abs(value)), largest), least);
  const wide = limitsFor({ ...limits, angle: most('torsionAngle', 0), rate: most('torsionRate', 0) });
  return { ...limits, angle: Math.max(limits.angle, wide.angle), rate: Math.max(limits.rate, wide.rate) };
}

/** @param {Outlook} goal @param {import('../engine/engine.js').Energy | null} energy @returns {Compared['becomes']} */
function becomesOf(goal, energy) {
  return { manner: mannerOf(goal), amplitude: goal.verdict === 'grows' ? null : goal.amplitude.torsionAngle, frequency: goal.frequency ?? null, energy };
}

customElements.define('shimmy-compare-lens', CompareLens);
