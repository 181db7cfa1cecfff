import { html } from 'lit';

/**
 * A symbol of the equations as the table writes it: `I_z`, `c_Fα`.
 * @param {string} symbol
 */
export function symbolOf(symbol) {
  const [letter, sub] = symbol.split('_');
  return html`<i class="symbol" aria-hidden="true">${letter}${sub ? html`<sub>${sub}</sub>` : ''}</i>`;
}
