/**
 * How widely the gear will swing, as a small curve over a slider's track: its full height is the swing beyond which the model is
 * not trusted, on every slider alike. Stable cycles solid, unstable ones dashed.
 *
 * @typedef {import('../pkg/shimmy.js').Bifurcation} Bifurcation
 * @typedef {import('../run/swing-scent.js').Swings} Swings
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {import('./quantity.js').Quantity} Quantity
 */

import { html, nothing, svg } from 'lit';
import { trusted } from '../run/trusted.js';
import { decimalsFor } from '../words/number.js';

/** What the full height is, in rad. */
export const fullHeight = trusted;
/** The curve's own width and height; the page stretches it to the track. */
const [width, height] = [1000, 100];

/** @typedef {{ stable: string, unstable: string, area: string, widest: { value: number, amplitude: number } | null }} Curve paths of SVG; `area`: what is under the stable one */

/** A diagram never changes, and a slider is drawn often. @type {WeakMap<Bifurcation, Curve>} */
const known = new WeakMap();

/** @param {Swings | null} swings @param {Quantity} quantity */
export function sparklineOf(swings, quantity) {
  if (!swings) return nothing;
  const { stable, unstable, area } = curveOf(swings.diagram, quantity);
  if (!stable && !unstable) return nothing;
  return html`<svg class=${swings.isOld ? 'sparkline old' : 'sparkline'} viewBox="0 0 ${width} ${height}" preserveAspectRatio="none" aria-hidden="true">
    ${svg`<path class="area" d=${area}/><path class="stable" d=${stable}/><path class="unstable" d=${unstable}/>`}</svg>`;
}

/** The same for who cannot see it. @param {Swings | null} swings @param {Quantity} quantity @param {Voice} voice */
export function swingsInWords(swings, quantity, voice) {
  const widest = swings && !swings.isOld ? curveOf(swings.diagram, quantity).widest : null;
  if (!widest) return '';
  const degrees = (Math.min(widest.amplitude, fullHeight) * 180) / Math.PI;
  const said = { amplitude: `±${voice.number(degrees, Math.min(2, decimalsFor(degrees, 2)))}°`, value: quantity.write(quantity.snapped(widest.value), voice) };
  return voice.say(widest.amplitude > fullHeight ? 'spark.beyond' : 'spark.said', said);
}

/** @param {Bifurcation} diagram @param {Quantity} quantity @returns {Curve} */
export function curveOf(diagram, quantity) {
  const before = known.get(diagram);
  if (before) return before;
  const { parameter, cycles, points } = diagram;
  /** @type {Curve} */
  const curve = { stable: '', unstable: '', area: '', widest: null };
  cycles.forEach((branch, at) => {
    const turns = new Set(points.filter((point) => point.branch === at && point.kind !== 'hopf').map(({ index }) => index));
    const across = (/** @type {number} */ i) => (width * quantity.placeOf(branch[parameter][i])).toFixed(1);
    const place = (/** @type {number} */ i) => `${across(i)} ${(height * (1 - Math.min(1, branch.amplitude[i] / fullHeight))).toFixed(1)}`;
    for (let i = 0; i + 1 < branch.amplitude.length; i++) {
      // A piece is as stable as that end of it at which nothing turns.
      const kind = branch.stable[turns.has(i + 1) ? i : i + 1] === 1 ? 'stable' : 'unstable';
      curve[kind] += `M${place(i)}L${place(i + 1)}`;
      if (kind === 'stable') curve.area += `M${place(i)}L${place(i + 1)}L${across(i + 1)} ${height}L${across(i)} ${height}Z`;
      const amplitude = branch.amplitude[i + 1];
      if (kind === 'stable' && amplitude > (curve.widest?.amplitude ?? 0)) curve.widest = { value: branch[parameter][i + 1], amplitude };
    }
  });
  known.set(diagram, curve);
  return curve;
}

/** So far beyond a boundary, as a share of the slider, and so wide, in rad, a cycle is there in earnest. */
const [beyond, wide] = [0.01, 0.01];

/**
 * Whether a wide swing lives where small ones die out: a cycle reaches beyond where linear theory ends it.
 * @param {Swings | null} swings
 * @param {readonly { from: number, to: number }[]} intervals in which small swings grow, in SI
 * @param {Quantity} quantity
 */
export function livesBeyond(swings, intervals, quantity) {
  if (!swings || swings.isOld) return false;
  const { parameter, cycles } = swings.diagram;
  const margin = beyond * (quantity.parameter.max - quantity.parameter.min);
  return cycles.some((branch) => branch.amplitude.some((amplitude, i) => amplitude > wide
    && intervals.every(({ from, to }) => branch[parameter][i] < from - margin || branch[parameter][i] > to + margin)));
}
