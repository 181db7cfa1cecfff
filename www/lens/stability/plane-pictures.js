/**
 * Pictures of maps, each made once: its colors as pixels and its hatch as lines from the corner of its plot.
 *
 * @typedef {import('./planes-beside.js').StableMap} StableMap
 * @typedef {import('../../style/theme.js').Theme} Theme
 * @typedef {{ theme: Theme, width: number, height: number, image: HTMLCanvasElement, hatch: Float32Array }} Picture
 */

import { cellAt } from '../../view/field.js';
import { hatchOf } from '../../view/hatch.js';
import { paintMapImage } from './map-image.js';


export class PlanePictures {
  /** @type {WeakMap<StableMap, Picture>} */ #made = new WeakMap();

  /** @param {StableMap} map @param {import('../../view/axes.js').Box} plot @param {Theme} theme @returns {Picture} */
  of(map, { left, right, top, bottom }, theme) {
    const [width, height] = [right - left, bottom - top];
    const made = this.#made.get(map);
    if (made && made.theme === theme && made.width === width && made.height === height) return made;
    const { columns, rows, stable } = map;
    const image = made?.image ?? document.createElement('canvas');
    paintMapImage({ columns, rows, stable, growthRate: null, frequency: null, kind: null }, { coloring: 'stable', limits: { growthRate: 1, frequency: [0, 1] } }, theme, image);
    const field = { columns, rows, values: stable };
    const hatch = hatchOf({ left: 0, right: width, top: 0, bottom: height }, (across, up) => !cellAt(field, across, up), theme);
    const picture = { theme, width, height, image, hatch };
    this.#made.set(map, picture);
    return picture;
  }
}
