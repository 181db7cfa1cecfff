import { html } from 'lit';
import './calm.js';
import './energy.js';
import './identify.js';
import './loops.js';
import './models.js';
import './tables.js';

/**
 * The views of the lens *Damper*. A new one is an element of its own, a panel.js, called `shimmy-damper-<name>`; its line in this
 * list, its name in settings.js and in the words (`damper.view.<name>`, `damper.line.<name>`); its layout is in a file of
 * style/damper/. `fits`: it has axes that hold, and can be fitted.
 *
 * @typedef {{
 *   voice: import('../../words/voice.js').Voice, quantities: import('../../controls/quantity.js').Quantity[], settings: Readonly<Record<string, string>>,
 *   isVeiled: boolean,
 * }} Given
 * @typedef {{ template: (given: Given) => unknown, fits: boolean }} View
 *
 * @type {Readonly<Record<typeof import('./settings.js').viewNames[number], View>>}
 */
export const damperViews = {
  loops: {
    template: ({ voice, quantities, settings, isVeiled }) => html`<shimmy-damper-loops class="stability-panel" .voice=${voice} .quantities=${quantities} .settings=${settings} .isVeiled=${isVeiled}></shimmy-damper-loops>`,
    fits: true,
  },
  models: {
    template: ({ voice, quantities, settings, isVeiled }) => html`<shimmy-damper-models class="stability-panel" .voice=${voice} .quantities=${quantities} .settings=${settings} .isVeiled=${isVeiled}></shimmy-damper-models>`,
    fits: false,
  },
  energy: {
    template: ({ voice, quantities, settings, isVeiled }) => html`<shimmy-damper-energy class="stability-panel" .voice=${voice} .quantities=${quantities} .settings=${settings} .isVeiled=${isVeiled}></shimmy-damper-energy>`,
    fits: false,
  },
  identify: {
    template: ({ voice, quantities, settings, isVeiled }) => html`<shimmy-damper-identify class="stability-panel" .voice=${voice} .quantities=${quantities} .settings=${settings} .isVeiled=${isVeiled}></shimmy-damper-identify>`,
    fits: false,
  },
  calm: {
    template: ({ voice, quantities, settings, isVeiled }) => html`<shimmy-damper-calm class="stability-panel" .voice=${voice} .quantities=${quantities} .settings=${settings} .isVeiled=${isVeiled}></shimmy-damper-calm>`,
    fits: false,
  },
  tables: {
    template: ({ voice, quantities, settings, isVeiled }) => html`<shimmy-damper-tables class="stability-panel" .voice=${voice} .quantities=${quantities} .settings=${settings} .isVeiled=${isVeiled}></shimmy-damper-tables>`,
    fits: false,
  },
};
