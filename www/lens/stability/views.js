import './beside.js';
import './histories.js';
import { LocusView } from './locus-view.js';
import './modes.js';
import { panelView } from './panel-view.js';
import { PlaneView } from './plane-view.js';
import { RootsView } from './roots-view.js';
import './routh.js';

/**
 * The views of the lens *Stability*. A new one is a file here (or an element of its own, see panel-view.js), its line in this
 * list, its name in settings.js and in the words (`stability.view.<name>`); its layout is in style/stability.css, under
 * `[data-view='<name>']`, that of an element of its own in a file of style/stability/.
 *
 * @typedef {{
 *   template: (voice: import('../../words/voice.js').Voice) => unknown,
 *   line: (voice: import('../../words/voice.js').Voice) => unknown,
 *   stale: () => void,
 *   draw: (scene: import('../../run/scene.js').Scene) => void,
 * }} View `template`: its pictures and choices; `line`: what stands under them; `stale`: something but words has changed, so all
 *   is to be drawn again; `draw`: is called each frame, and draws what has changed
 */

/** @type {Readonly<Record<typeof import('./settings.js').viewNames[number], new (lens: import('../stability.js').StabilityLens) => View>>} */
export const stabilityViews = {
  plane: PlaneView, roots: RootsView, locus: LocusView, modes: panelView('modes'), routh: panelView('routh'),
  beside: panelView('beside'), histories: panelView('histories'),
};
