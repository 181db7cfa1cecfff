import { html } from 'lit';
import './basins.js';
import './branch.js';
import './cycle.js';
import './folds.js';
import './freeplay.js';
import './methods.js';
import './tables.js';

/**
 * The views of the lens *Cycles*. A new one is an element of its own, a panel.js, called `shimmy-<name>`; its line in this
 * list, its name in settings.js and in the words (`cycles.view.<name>`, `cycles.line.<name>`); its layout is in a file of
 * style/cycles/. `fits`: it has axes that hold, and can be fitted; `needsCycle`: it shows the gear's limit cycle, which is then
 * followed.
 *
 * @typedef {{
 *   voice: import('../../words/voice.js').Voice, quantities: import('../../controls/quantity.js').Quantity[], settings: Readonly<Record<string, string>>,
 *   isVeiled: boolean, watch: import('./cycle-watch.js').CycleWatch, outlook: import('../../engine/engine.js').Outlook | null,
 * }} Given
 * @typedef {{ template: (given: Given) => unknown, fits: boolean, needsCycle: boolean }} View
 *
 * @type {Readonly<Record<typeof import('./settings.js').viewNames[number], View>>}
 */
export const cycleViews = {
  cycle: {
    template: ({ voice, quantities, settings, isVeiled, watch, outlook }) => html`<shimmy-cycle class="stability-panel" .voice=${voice} .quantities=${quantities}
      .settings=${settings} .isVeiled=${isVeiled} .watch=${watch} .outlook=${outlook}></shimmy-cycle>`,
    fits: true, needsCycle: true,
  },
  branch: {
    template: ({ voice, quantities, settings, isVeiled, watch, outlook }) => html`<shimmy-branch class="stability-panel" .voice=${voice} .quantities=${quantities}
      .settings=${settings} .isVeiled=${isVeiled} .watch=${watch} .outlook=${outlook}></shimmy-branch>`,
    fits: true, needsCycle: true,
  },
  folds: {
    template: ({ voice, quantities, settings, isVeiled, watch }) => html`<shimmy-folds class="stability-panel" .voice=${voice} .quantities=${quantities}
      .settings=${settings} .isVeiled=${isVeiled} .watch=${watch}></shimmy-folds>`,
    fits: false, needsCycle: true,
  },
  methods: {
    template: ({ voice, quantities, settings, isVeiled, watch }) => html`<shimmy-methods class="stability-panel" .voice=${voice} .quantities=${quantities}
      .settings=${settings} .isVeiled=${isVeiled} .watch=${watch}></shimmy-methods>`,
    fits: true, needsCycle: true,
  },
  tables: {
    template: ({ voice, quantities, settings, isVeiled }) => html`<shimmy-cycle-tables class="stability-panel" .voice=${voice} .quantities=${quantities}
      .settings=${settings} .isVeiled=${isVeiled}></shimmy-cycle-tables>`,
    fits: false, needsCycle: false,
  },
  freeplay: {
    template: ({ voice, quantities, settings, isVeiled, watch }) => html`<shimmy-freeplay class="stability-panel" .voice=${voice} .quantities=${quantities}
      .settings=${settings} .isVeiled=${isVeiled} .watch=${watch}></shimmy-freeplay>`,
    fits: false, needsCycle: true,
  },
  basins: {
    template: ({ voice, quantities, settings, isVeiled, watch }) => html`<shimmy-basins class="stability-panel" .voice=${voice} .quantities=${quantities}
      .settings=${settings} .isVeiled=${isVeiled} .watch=${watch}></shimmy-basins>`,
    fits: false, needsCycle: true,
  },
};
