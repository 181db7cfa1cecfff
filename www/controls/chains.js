/** Chains: a value that follows others, seen from it and from those that it follows. A press parts or joins them. */

import { html, nothing, svg } from 'lit';
import { tell } from '../command.js';
import { followed } from '../run/links.js';
import { relationOf } from './equations.js';

/**
 * @typedef {import('../run/links.js').Links} Links
 * @typedef {import('../words/voice.js').Voice} Voice
 */

/**
 * The chains at a parameter.
 * @param {string} name
 * @param {Links} links
 * @param {Voice} voice
 */
export function chainsOf(name, links, voice) {
  const followers = Object.keys(followed).filter((one) => one in links && (one === name || followed[one].includes(name)));
  return followers.length === 0 ? nothing : html`<div class="chains">${followers.map((one) => chainOf(one, links[one], voice))}</div>`;
}

/** @param {string} follower @param {boolean} isJoined @param {Voice} voice */
function chainOf(follower, isJoined, voice) {
  const relation = voice.say(/** @type {import('../words/voice.js').Key} */ (`relation.${follower}`));
  const title = voice.say(isJoined ? 'chain.joined' : 'chain.parted', { relation });
  return html`
    <button type="button" class="chain" aria-pressed=${isJoined ? 'true' : 'false'} title=${title}
      @click=${(/** @type {Event} */ event) => tell(/** @type {Element} */ (event.currentTarget), 'toggleLink', follower)}>
      <svg viewBox="0 0 24 12" width="24" height="12" aria-hidden="true">${isJoined ? joined : parted}</svg>
      <span class="only-heard">${relation}:</span> <span class="relation">${relationOf(follower, '', voice)}</span>
    </button>`;
}

const joined = svg`<rect x="1.5" y="2" width="11" height="8" rx="4" /><rect x="11.5" y="2" width="11" height="8" rx="4" /><path d="M8.5 6h7" />`;
const parted = svg`<path d="M8 2H5.5a4 4 0 0 0 0 8H8M16 2h2.5a4 4 0 0 1 0 8H16M10.5 1l.8 2M13.5 1l-.8 2M10.5 11l.8-2M13.5 11l-.8-2" />`;
