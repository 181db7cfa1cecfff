import { ThesisPanel } from '../cycles/thesis-panel.js';
import { damperOffer } from './offer.js';
import { damperTableNumbers, damperTables } from './thesis-tables.js';

/** @typedef {import('../../words/voice.js').Voice} Voice */

const tables = /** @type {const} */ ({ all: damperTables, numbers: damperTableNumbers, name: 'damper.view.tables', chosen: 'damperTable', sorted: 'damperTableSort' });

/** The tables of the thesis about the damper on the gear, computed with the damper that is on it; `fitDamper` where there is none. */
export class DamperTables extends ThesisPanel {
  get tables() {
    return tables;
  }

  /** @param {string} number @param {Voice} voice */
  titleOf(number, voice) {
    return voice.say(/** @type {import('../../words/voice.js').Key} */ (`atlas.table-${number}`));
  }

  /** @param {Voice} voice @param {import('../../run/scene.js').Scene} scene */
  foreign(voice, scene) {
    return damperOffer(this, scene.object, voice);
  }
}

customElements.define('shimmy-damper-tables', DamperTables);
