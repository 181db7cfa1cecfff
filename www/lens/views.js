import { viewNames as cycleViews } from './cycles/settings.js';
import { viewNames as damperViews } from './damper/settings.js';
import { viewNames as landingViews } from './landing/settings.js';
import { viewNames } from './stability/settings.js';

/**
 * What can be seen otherwise, and how: the views of each lens by name, the first is the usual one; and which settings of
 * `view` a link may carry. A lens that is not listed keeps its setting in its own words.
 *
 * @type {Readonly<Record<string, readonly string[]>>}
 */
export const viewsOfLens = {
  phase: ['portrait', 'deformation', 'orbit', 'spectrum', 'spectrum-log'],
  forces: ['all', 'sideForce', 'aligningMoment', 'restoringMoment', 'frictionMoment'],
  stability: viewNames,
  cycles: cycleViews,
  damper: damperViews,
  landing: landingViews,
  compare: [],
};

/**
 * Which way the orbit is seen from, as the lens *Phase* keeps it: `orbit,56,20`, yaw and pitch in degrees.
 * @param {string} text
 */
const isTurnedOrbit = (text) => {
  const [, yaw, pitch] = (text.match(/^orbit,(-?\d{1,3}),(\d{1,2})$/) ?? []).map(Number);
  return Math.abs(yaw) <= 180 && pitch <= 90;
};

/**
 * Whether a lens has a view of this name.
 * @param {string} lens
 * @param {string} shows
 */
export function hasView(lens, shows) {
  const views = viewsOfLens[lens];
  return !views || views.includes(shows) || (lens === 'phase' && isTurnedOrbit(shows));
}
