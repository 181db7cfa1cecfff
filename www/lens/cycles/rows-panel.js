import { sorted } from '../stability/figures-table.js';
import { CyclePanel } from './panel.js';
import { Rows } from './rows.js';
import { takeTable } from './table-out.js';

/** @typedef {import('../../words/voice.js').Voice} Voice */

/** So long a frame may work on rows, in ms. */
const slice = 4;

/**
 * A view with a table whose rows are computed when it is looked at, some each frame. A view says which rows, and what is asked
 * of each; the table can be sorted and taken along.
 * @template Spec, Answer
 */
export class RowsPanel extends CyclePanel {
  static properties = { ...CyclePanel.properties, items: { state: true }, said: { state: true } };

  #rows = /** @type {Rows<Spec, Answer>} */ (new Rows());
  #frame = 0;

  constructor() {
    super();
    this.items = this.#rows.items;
    /** What came of a wish to take the table along. */ this.said = '';
  }

  disconnectedCallback() {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    super.disconnectedCallback();
  }

  /** Which rows there are to be; null for none. @returns {{ key: string, shape: string, specs: readonly Spec[] } | null} */
  wanted() {
    return null;
  }

  /** @param {Spec} _spec @param {Answer | null} _before @returns {Answer | null} */
  answer(_spec, _before) {
    return null;
  }

  get isDone() {
    return this.#rows.isDone;
  }

  /** @param {import('../../run/scene.js').Scene} scene @param {import('../../style/theme.js').Theme} theme */
  draw(scene, theme) {
    super.draw(scene, theme);
    const wanted = this.isVeiled ? null : this.wanted();
    if (!wanted) return;
    // The gear of this very moment is asked, not the one of when it is answered.
    this.#rows.look(wanted, (spec, before) => this.answer(spec, before), performance.now());
    if (!this.#rows.isDone) this.#frame ||= requestAnimationFrame(this.#advance);
  }

  #advance = () => {
    this.#frame = 0;
    if (this.isVeiled || !this.isConnected) return;
    this.#rows.advance(slice);
    this.items = this.#rows.items;
    if (!this.#rows.isDone) this.#frame = requestAnimationFrame(this.#advance);
  };

  /** Sets values of the gear, those alone that are others: what follows others need not be parted from them. @param {Readonly<Record<string, number>>} values */
  setOthers(values) {
    const others = Object.fromEntries(Object.entries(values).filter(([name, value]) => name in (this.scene?.parameters ?? {}) && this.scene?.parameters[name] !== value));
    if (Object.keys(others).length > 0) this.put(others);
  }

  /** Whether the gear has these values. @param {Readonly<Record<string, number>>} values */
  isNow(values) {
    return Object.entries(values).every(([name, value]) => this.scene?.parameters[name] === value);
  }

  /**
   * The table as a file, sorted as it is seen.
   * @template Row
   * @param {'csv' | 'png' | 'svg'} format @param {Omit<import('./table-out.js').Taken<Row>, 'link'>} taken @param {string} sorting @param {Voice} voice
   */
  async take(format, taken, sorting, voice) {
    if (!this.theme) return;
    this.said = '';
    this.said = await takeTable(format, { ...taken, rows: sorted(taken.rows, taken.columns, sorting), link: address() }, this.theme, voice);
  }
}

/** Of the page with its state; of a file on this machine its name alone. */
function address() {
  const { protocol, href, pathname, hash } = location;
  return protocol === 'file:' ? pathname.slice(pathname.lastIndexOf('/') + 1) + hash : href;
}
