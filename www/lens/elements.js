import { html, unsafeStatic } from 'lit/static-html.js';
import './compare.js';
import './forces.js';
import './phase.js';
import './stability.js';

/**
 * The element of a lens that is ready.
 * @param {string} lens
 * @param {{ voice: import('../words/voice.js').Voice, shows: string, views: Readonly<Record<string, string>>, isVeiled: boolean, quantities: import('../controls/quantity.js').Quantity[] }} given
 */
export function lensElement(lens, { voice, shows, views, isVeiled, quantities }) {
  const tag = unsafeStatic(`shimmy-${lens}-lens`);
  return html`<${tag} id="lens-panel" role="tabpanel" aria-labelledby="tab-${lens}" .voice=${voice} .shows=${shows} .settings=${views} .isVeiled=${isVeiled}
    .quantities=${quantities}></${tag}>`;
}
