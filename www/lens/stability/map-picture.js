import { isSameList } from '../../store.js';
import { sheetOf } from '../../view/map-sheet.js';
import { paintMapImage } from './map-image.js';

/**
 * What of a plane's picture comes from its map, made anew only where that, or how it is drawn, has changed: the colors as
 * pixels, and the sheet over them.
 *
 * @typedef {import('./plane-map.js').Looked} Looked
 * @typedef {import('./settings.js').Coloring} Coloring
 * @typedef {import('../../style/theme.js').Theme} Theme
 * @typedef {import('../../words/voice.js').Voice} Voice
 */
export class MapPicture {
  image = document.createElement('canvas');
  /** @type {import('../../view/map-sheet.js').MapSheet | null} */ sheet = null;
  /** What the image and the sheet were made from. @type {unknown[]} */ #imageOf = [];
  /** @type {unknown[]} */ #sheetOf = [];

  /**
   * @param {CanvasRenderingContext2D} context that knows how wide words are
   * @param {import('../../view/axes.js').Box} frame
   * @param {Looked} looked
   * @param {{ coloring: Coloring, isLinearOnly: boolean, isRubbed?: boolean }} look `isLinearOnly`: of a gear that is not linear even for a
   *   small swing, by its gap; `isRubbed`: by its friction
   * @param {Theme} theme
   * @param {Voice} voice
   */
  make(context, frame, { map, limits }, { coloring, isLinearOnly, isRubbed = false }, theme, voice) {
    const look = [map, limits, theme, coloring];
    if (!isSameList(look, this.#imageOf)) {
      paintMapImage(map, { coloring, limits }, theme, this.image);
      this.#imageOf = look;
    }
    const laid = [...look, ...Object.values(frame), voice, isLinearOnly, isRubbed];
    if (isSameList(laid, this.#sheetOf)) return;
    const words = isLinearOnly
      ? { stable: voice.say('stability.stable.linear'), hopf: voice.say('stability.unstable.linear'), divergence: voice.say('stability.divergence.linear') }
      : isRubbed
      ? { stable: voice.say('stability.stable.frictionless'), hopf: voice.say('stability.unstable.frictionless'), divergence: voice.say('stability.divergence.frictionless') }
      : { stable: voice.say('stability.stable'), hopf: voice.say('stability.unstable'), divergence: voice.say('stability.divergence') };
    this.sheet = sheetOf(context, frame, map, { coloring, limits, words }, theme, voice);
    this.#sheetOf = laid;
  }
}
