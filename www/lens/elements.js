import { html, unsafeStatic } from 'lit/static-html.js';
import './compare.js';
import './forces.js';
import './phase.js';

/**
 * Lenses that come when one first looks: the page is there the sooner.
 * @type {Readonly<Record<string, () => Promise<unknown>>>}
 */
const later = { stability: () => import('./stability.js'), cycles: () => import('./cycles.js'), damper: () => import('./damper.js'), landing: () => import('./landing.js') };

/** Those that are on their way, and those that did not arrive. @type {Map<string, 'loading' | 'failed'>} */
const ways = new Map();

/**
 * The element of a lens that is ready.
 * @param {string} lens
 * @param {{ voice: import('../words/voice.js').Voice, shows: string, views: Readonly<Record<string, string>>, isVeiled: boolean, quantities: import('../controls/quantity.js').Quantity[] }} given
 * @param {() => void} arrived is called when a lens has come that was not there, or cannot come
 */
export function lensElement(lens, { voice, shows, views, isVeiled, quantities }, arrived) {
  const name = `shimmy-${lens}-lens`;
  if (later[lens] && !customElements.get(name)) {
    const failed = ways.get(lens) === 'failed';
    if (!failed) bring(lens, arrived);
    return html`<div id="lens-panel" role="tabpanel" aria-labelledby="tab-${lens}"><p class="panel-empty" role="status">${voice.say(failed ? 'lens.failed' : 'lens.loading')}
      ${failed ? html`<button type="button" class="framed" @click=${() => bring(lens, arrived)}>${voice.say('lens.again')}</button>` : ''}</p></div>`;
  }
  const tag = unsafeStatic(name);
  return html`<${tag} id="lens-panel" role="tabpanel" aria-labelledby="tab-${lens}" .voice=${voice} .shows=${shows} .settings=${views} .isVeiled=${isVeiled}
    .quantities=${quantities}></${tag}>`;
}

/** @param {string} lens @param {() => void} arrived */
function bring(lens, arrived) {
  if (ways.get(lens) === 'loading') return;
  ways.set(lens, 'loading');
  later[lens]().then(() => ways.delete(lens), () => ways.set(lens, 'failed')).then(arrived);
}
