import { html } from 'lit';
import './beside-view.js';
import './roll-view.js';
import './table-view.js';

/**
 * The views of the lens *Landing*. A new one is an element of its own; its line in this list, its name in settings.js and in the words
 * (`landing.view.<name>`, `landing.line.<name>`).
 *
 * @typedef {{ voice: import('../../words/voice.js').Voice, quantities: import('../../controls/quantity.js').Quantity[], settings: Readonly<Record<string, string>>, isVeiled: boolean, rolls: import('./roll-set.js').RollSet }} Given
 *
 * @type {Readonly<Record<typeof import('./settings.js').viewNames[number], (given: Given) => unknown>>}
 */
export const landingViews = {
  roll: ({ voice, quantities, settings, isVeiled }) => html`<shimmy-landing-roll class="stability-panel" .voice=${voice} .quantities=${quantities} .settings=${settings} .isVeiled=${isVeiled}></shimmy-landing-roll>`,
  beside: ({ voice, quantities, settings, isVeiled, rolls }) => html`<shimmy-landing-beside class="stability-panel" .voice=${voice} .quantities=${quantities} .settings=${settings} .isVeiled=${isVeiled} .rolls=${rolls}></shimmy-landing-beside>`,
  table: ({ voice, quantities, settings, isVeiled, rolls }) => html`<shimmy-landing-table class="stability-panel" .voice=${voice} .quantities=${quantities} .settings=${settings} .isVeiled=${isVeiled} .rolls=${rolls}></shimmy-landing-table>`,
};
