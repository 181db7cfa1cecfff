import { html } from 'lit';
import '../../view/canvas.js';
import { drawFamilies } from '../../view/damper/families.js';
import { energyOf, equivalentDamping } from '../../run/damper-looks.js';
import { quantities } from '../../view/quantities.js';
import { DamperPanel } from './panel.js';
import { amplitudes } from './settings.js';

/** @typedef {import('../../words/voice.js').Voice} Voice */

/** Amplitudes that are computed, evenly by their logarithm. */
const count = 25;
const from = amplitudes.min / 1000;

/**
 * What the damper takes out of a cycle, and the dashpot that would take as much, over the amplitude and for each command: a dashpot
 * that grows weaker the wider the swing, which is why a damper that calms a small swing may not calm a large one. Commands: `view`
 * with the damper, its motion and which command is chosen.
 */
export class DamperEnergy extends DamperPanel {
  /** What was computed last. @type {{ key: string, curves: Curve[] }} */ #made = { key: '', curves: [] };

  /** @typedef {{ command: number, amplitude: number[], energy: number[], damping: number[] }} Curve */

  get #curves() {
    const { table, currents, motion } = this;
    if (!table) return [];
    const most = Math.max(2 * motion.amplitude, 0.01);
    const places = Array.from({ length: count }, (_, i) => from * (most / from) ** (i / (count - 1)));
    const key = JSON.stringify([table.name, currents, motion.frequency, most]);
    if (key !== this.#made.key) {
      const curves = currents.map((command) => {
        const found = places.flatMap((amplitude) => {
          const at = { amplitude, frequency: motion.frequency };
          const cycle = this.cycleOf({ model: table.name, command }, at);
          const energy = cycle && energyOf(cycle);
          return energy === null ? [] : [{ amplitude, energy, damping: equivalentDamping(energy, at) }];
        });
        return { command, amplitude: found.map((one) => one.amplitude), energy: found.map((one) => one.energy), damping: found.map((one) => one.damping) };
      });
      this.#made = { key, curves };
    }
    return this.#made.curves;
  }

  /** The chosen command at the bench's amplitude. */
  #now() {
    const { table, motion } = this;
    const command = this.currents[this.chosen];
    const cycle = table && this.cycleOf({ model: table.name, command });
    if (!cycle) return null;
    const energy = energyOf(cycle);
    return { command, energy, damping: equivalentDamping(energy, motion) };
  }

  /** @param {Voice} voice */
  content(voice) {
    const { currents, chosen, isVeiled, motion } = this;
    const now = isVeiled ? null : this.#now();
    return html`
      <div class="damper-energy">
        <div class="plane-choices">
          ${this.modelChoice(voice)}
          <span class="commands" role="group" aria-label=${voice.say('damper.currents')}>
            ${currents.map((command, i) => html`<button type="button" class="framed" aria-pressed=${i === chosen ? 'true' : 'false'} @click=${() => this.choose('damperCurrent', String(command))}>${this.commandOf(command, voice)}</button>`)}
          </span>
        </div>
        <shimmy-canvas class="damper-plots" .label=${voice.say(isVeiled ? 'damper.energy.veiled' : 'damper.energy.name')} .paint=${this.#paint}></shimmy-canvas>
        <p class="damper-reading" role="status">${now ? voice.say('damper.energy.reading', {
          amplitude: voice.number(1000 * motion.amplitude, 1), command: this.commandOf(now.command, voice), energy: voice.number(now.energy, 2), damping: voice.number(now.damping, 0),
        }) : ''}</p>
        ${this.motionKnobs(voice)}
      </div>`;
  }

  /** @param {import('../../run/scene.js').Scene} scene @param {import('../../style/theme.js').Theme} theme */
  draw(scene, theme) {
    const before = this.scene;
    super.draw(scene, theme);
    if (!before) this.requestUpdate();
    this.redrawWhere('.damper-plots', [this.settings, this.voice, this.theme, this.isVeiled]);
  }

  /** @type {import('../../view/canvas.js').Paint} */
  #paint = (context, size) => {
    const { voice, theme, chosen, currents, motion } = this;
    if (!voice || !theme) return;
    const curves = this.isVeiled ? [] : this.#curves.map((curve) => ({ ...curve, label: this.commandOf(curve.command, voice), isChosen: curve.command === currents[chosen] }));
    const now = this.isVeiled ? null : this.#now();
    drawFamilies(context, size, {
      panels: [
        { quantity: quantities.dissipated, curves: curves.map(({ energy, ...curve }) => ({ ...curve, values: energy })), now: now?.energy ?? null },
        { quantity: quantities.equivalentDamping, curves: curves.map(({ damping, ...curve }) => ({ ...curve, values: damping })), now: now?.damping ?? null },
      ],
      across: quantities.pistonAmplitude, at: motion.amplitude, veiled: this.isVeiled,
    }, theme, voice);
  };
}

customElements.define('shimmy-damper-energy', DamperEnergy);
