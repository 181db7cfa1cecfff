import { html } from 'lit';
import '../../view/canvas.js';
import { drawLoops } from '../../view/damper/loops.js';
import { decimalsFor } from '../../words/number.js';
import { Bench } from './bench.js';
import { mostOf } from './loops.js';
import { DamperPanel } from './panel.js';
import { damperNames } from './settings.js';

/** @typedef {import('../../words/voice.js').Voice} Voice */

/** What tells the four apart besides their names. */
const dashes = [[], [7, 4], [2, 3], [10, 3, 2, 3]];

/**
 * The four models on the same motion: their loops, each over its own greatest force, which stands beside it; two orders of magnitude
 * lie between the dampers that they were fitted to. Commands: `view` with the motion and with the command as a share of the most.
 */
export class DamperModels extends DamperPanel {
  #bench = new Bench();

  /** Each with its cycle at its own default command. */
  get #loops() {
    return damperNames.flatMap((name, i) => {
      const table = this.tableOf(name);
      const command = table?.command.default ?? 0;
      const cycle = table && this.cycleOf({ model: name, command });
      return table && cycle ? [{ name, table, command, cycle, dash: dashes[i], most: mostOf(cycle.force) || 1 }] : [];
    });
  }

  /** @param {Voice} voice */
  content(voice) {
    const loops = this.isVeiled ? [] : this.#loops;
    return html`
      <div class="damper-models">
        <shimmy-canvas class="damper-plots" .label=${voice.say(this.isVeiled ? 'damper.loops.veiled' : 'damper.models.name')} .paint=${this.#paint}></shimmy-canvas>
        <div class="figures-table" role="region" tabindex="0" aria-label=${voice.say('damper.view.models')}><table>
          <thead><tr><th scope="col">${voice.say('damper.model')}</th><th scope="col" class="figure">${voice.say('damper.command')}</th><th scope="col" class="figure">F, N</th><th scope="col">${voice.say('damper.source')}</th></tr></thead>
          <tbody>${loops.map(({ name, table, command, most }) => html`
            <tr><th scope="row">${voice.say(`damper.model.${name}`)}</th><td class="figure">${voice.number(command, 2)} ${table.command.unit}</td>
              <td class="figure">±${voice.number(most, Math.min(1, decimalsFor(most, 3)))}</td><td>${voice.say(`damper.source.${name}`)}</td></tr>`)}</tbody>
        </table></div>
        ${this.motionKnobs(voice)}
      </div>`;
  }

  /** @param {import('../../run/scene.js').Scene} scene @param {import('../../style/theme.js').Theme} theme */
  draw(scene, theme) {
    const before = this.scene;
    super.draw(scene, theme);
    if (!before) this.requestUpdate();
    this.#bench.follow(scene, performance.now());
    this.redrawWhere('.damper-plots', [this.#bench.phase, this.settings, this.voice, this.theme, this.isVeiled]);
  }

  /** @type {import('../../view/canvas.js').Paint} */
  #paint = (context, size) => {
    const { voice, theme, motion } = this;
    if (!voice || !theme) return;
    const loops = this.#loops.map(({ name, cycle, dash, most }) => ({
      displacement: cycle.displacement, velocity: cycle.velocity, force: cycle.force.map((force) => force / most), label: voice.say(`damper.model.${name}.short`), dash,
    }));
    const limits = { displacement: 1.15 * motion.amplitude, velocity: 1.15 * 2 * Math.PI * motion.frequency * motion.amplitude, force: 1.15 };
    drawLoops(context, size, { loops, limits, veiled: this.isVeiled, isShare: true }, theme, voice);
  };
}

customElements.define('shimmy-damper-models', DamperModels);
