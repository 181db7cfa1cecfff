import { tell } from '../../command.js';
import { isSameList } from '../../store.js';
import { Panel } from '../stability/panel.js';

/**
 * What the views of the lens *Cycles* share: like those beside the stability plane each looks at the gear anew once one of its
 * values has changed; besides there is the gear's limit cycle, which the lens follows for all of them.
 */
export class CyclePanel extends Panel {
  static properties = { ...Panel.properties, watch: { attribute: false }, outlook: { attribute: false } };

  constructor() {
    super();
    /** @type {import('./cycle-watch.js').CycleWatch | null} */ this.watch = null;
    /** What becomes of the run. @type {import('../../engine/engine.js').Outlook | null} */ this.outlook = null;
  }

  /** The gear's limit cycle; null where there is none, or no saying. */
  get cycle() {
    const cycle = this.watch?.cycle;
    return cycle?.found ? cycle : null;
  }

  /** What each picture was drawn from last, by its selector. @type {Map<string, readonly unknown[]>} */ #drawn = new Map();

  /** Draws a picture anew where what it is drawn from has changed: most pictures stand still while the gear moves. @param {string} selector @param {readonly unknown[]} from */
  redrawWhere(selector, from) {
    if (isSameList(this.#drawn.get(selector) ?? [], from)) return;
    this.#drawn.set(selector, from);
    /** @type {import('../../view/canvas.js').Canvas | null} */ (this.querySelector(selector))?.redraw();
  }

  /** A setting of the lens. @param {string} of @param {string} shows */
  choose(of, shows) {
    tell(this, 'view', { of, shows });
  }

  /** What the engine answers; null where the values are so wild that no number comes of them. @template Answer @param {(cycles: import('../../run/cycle-looks.js').CycleLooks) => Answer} question */
  askCycles(question) {
    try {
      return this.scene ? question(this.scene.cycles) : null;
    } catch {
      return null;
    }
  }
}
