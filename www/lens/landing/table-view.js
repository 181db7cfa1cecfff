import { html } from 'lit';
import { tell } from '../../command.js';
import { figureTitle } from '../../story/title.js';
import { figureColumn, parameterColumn } from '../cycles/columns.js';
import { tableOutButtons, takeTable } from '../cycles/table-out.js';
import { figuresTable, sorted } from '../stability/figures-table.js';
import { addressOfPage } from './address.js';
import { angleOf, speedOf } from './say.js';
import { SetPanel } from './set-panel.js';

/**
 * @typedef {import('../../words/voice.js').Voice} Voice
 * @typedef {import('./roll-set.js').Item} Row
 */

const degrees = 180 / Math.PI;

/** Table 7.4, computed when it is looked at: when each landing shimmies and how wide. A press has that gear land: command `land`. */
export class LandingTable extends SetPanel {
  static properties = { ...SetPanel.properties, said: { state: true } };

  constructor() {
    super();
    /** What came of a wish to take the table along. */ this.said = '';
  }

  /** @param {Voice} voice */
  content(voice) {
    const damping = this.quantity('dampingConstant');
    const velocity = this.quantity('velocity');
    if (!damping || !velocity) return html`<p class="panel-empty">${voice.say('landing.foreign')}</p>`;
    const columns = this.#columns(damping, velocity, voice);
    const rows = this.rolls?.items ?? [];
    const sorting = this.settings.landingSort ?? '';
    const caption = `${voice.say('atlas.Table', { number: '7.4' })}: ${figureTitle({ id: 'Table 7.4', title: 'MR damper during the landing roll', view: 'table' }, voice)}`;
    const note = this.#note(velocity, voice);
    return html`
      <div class="panel-scroll cycle-tables" tabindex="0" role="group" aria-label=${voice.say('landing.view.table')}>
        <p>${caption}</p>
        ${figuresTable(this, { caption, columns, rows, of: 'landingSort', sorting, classOf: ({ spec, isOld }) => [this.isNow(spec) ? 'now' : '', isOld ? 'old' : ''].join(' ') }, voice)}
        <p class="table-out">
          ${tableOutButtons({ said: this.said, take: async (format) => {
            if (!this.theme) return;
            this.said = await takeTable(format, { file: 'shimmy-table-7.4', title: caption, note, link: addressOfPage(), columns, rows: sorted(rows, columns, sorting) }, this.theme, voice);
          } }, voice)}
        </p>
        <p class="theory">${note}</p>
      </div>`;
  }

  /** @param {import('../../controls/quantity.js').Quantity} velocity @param {Voice} voice */
  #note(velocity, voice) {
    const { touchdownVelocity, deceleration, finalVelocity, torsionAngle } = this.roll;
    return voice.say('landing.table.note', {
      from: speedOf(touchdownVelocity, velocity, voice), to: speedOf(finalVelocity, velocity, voice), braking: voice.number(deceleration, 1), start: angleOf(torsionAngle, voice, 2),
      threshold: angleOf(this.rolls?.items[0]?.answer?.threshold ?? 1 / degrees, voice),
    });
  }

  /** @param {import('../../controls/quantity.js').Quantity} damping @param {import('../../controls/quantity.js').Quantity} velocity @param {Voice} voice @returns {import('../cycles/table-out.js').OutColumn<Row>[]} */
  #columns(damping, velocity, voice) {
    const press = {
      does: (/** @type {Row} */ { spec }) => voice.say('landing.table.press', { damping: damping.write(spec.dampingConstant, voice), current: voice.number(spec.current, 2) }),
      set: (/** @type {Row} */ { spec }) => tell(this, 'land', spec),
    };
    /** @param {string} name @param {string} head @param {string} unit @param {(shimmy: import('./roll.js').Shimmy) => number | null} value @param {number} [perSI] */
    const figure = (name, head, unit, value, perSI = 1, digits = 3) => figureColumn({ name, unit, head, digits, perSI, value: (/** @type {Row} */ { answer }) => (answer ? value(answer.shimmy) : null) }, voice);
    const speeds = velocity.toShown(1);
    return [
      parameterColumn(damping, (/** @type {Row} */ { spec }) => spec.dampingConstant, voice, press),
      figureColumn({ name: 'current', unit: 'A', head: 'I, A', digits: 3, value: (/** @type {Row} */ { spec }) => spec.current }, voice),
      figure('begins', voice.say('landing.table.begins', { unit: velocity.unit }), 'm/s', ({ begins }) => begins?.velocity ?? null, speeds),
      figure('ends', voice.say('landing.table.ends', { unit: velocity.unit }), 'm/s', ({ ends }) => ends?.velocity ?? null, speeds),
      figure('widest', 'ψ, °', 'rad', ({ begins, widest }) => (begins ? widest.angle : 0), degrees, 4),
      figure('at', voice.say('landing.table.at', { unit: velocity.unit }), 'm/s', ({ begins, widest }) => (begins ? widest.velocity : null), speeds),
    ];
  }
}

customElements.define('shimmy-landing-table', LandingTable);
