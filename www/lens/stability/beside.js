import { html, nothing } from 'lit';
import { tell } from '../../command.js';
import { symbolOf } from '../../controls/symbol.js';
import { withUnit } from '../../controls/quantity.js';
import { download } from '../../out/download.js';
import { tableCsv } from '../../out/table-csv.js';
import '../../view/canvas.js';
import { drawPlanesBeside, layBeside, layGrid, widthOfEnds, widthOfHeads, widthOfWords } from '../../view/planes-beside.js';
import { besideChoices } from './beside-choices.js';
import { besideOf, readyBesides, writeBeside } from './beside-settings.js';
import { figuresTable, sorted } from './figures-table.js';
import { Panel } from './panel.js';
import { PlanesBeside } from './planes-beside.js';
import { PlanePictures } from './plane-pictures.js';
import { plainSymbol, rangeInWords, shortNumber } from './say.js';
import { planeOf, writePlane } from './settings.js';
import { strangersNote, strangersOf } from './strangers.js';

/**
 * @typedef {import('./beside-settings.js').Beside} Beside
 * @typedef {import('./planes-beside.js').Item} Item
 * @typedef {import('../../words/voice.js').Voice} Voice
 */

/** So long a frame may work on planes, in ms. */
const slice = 6;
/** A grid that is too wide is written smaller on a projector, down to this share and to this size in px, before it is scrolled. */
const [smallest, readable] = [0.8, 13];

/**
 * The plane for a list of values, side by side, each with its stable share, and all shares in a table. Commands: `view` with
 * what is compared, `point` and `view` to go to a plane.
 */
export class BesidePlanes extends Panel {
  static properties = { ...Panel.properties, width: { state: true }, items: { state: true }, said: { state: true }, refusal: { state: true } };

  #planes = new PlanesBeside();
  #pictures = new PlanePictures();
  #observer = new ResizeObserver(([{ contentRect }]) => { this.width = contentRect.width; });
  /** @type {Element | null} */ #observed = null;
  #ruler = document.createElement('canvas').getContext('2d');
  #frame = 0;

  constructor() {
    super();
    /** Of the planes together, in px. */ this.width = 0;
    /** @type {readonly Item[]} */ this.items = [];
    /** What came of a wish to take the table along. */ this.said = '';
    /** Why what was typed is not taken. @type {import('./beside-choices.js').Refusal | null} */ this.refusal = null;
  }

  disconnectedCallback() {
    cancelAnimationFrame(this.#frame);
    this.#frame = 0;
    this.#observer.disconnect();
    this.#observed = null;
    super.disconnectedCallback();
  }

  get #beside() {
    return besideOf(this.settings.beside ?? '', this.quantities.map(({ parameter }) => parameter));
  }

  /** @param {Map<string, unknown>} changed */
  willUpdate(changed) {
    if (changed.has('settings')) this.refusal = null;
  }

  /** @param {Voice} voice */
  content(voice) {
    const beside = this.#beside;
    const { items } = this;
    if (!beside) return html`<p class="panel-empty">${voice.say('beside.foreign')}</p>`;
    const layout = this.#layout(beside, voice);
    return html`
      <div class="panel-scroll beside" tabindex="0" role="group" aria-label=${voice.say('stability.view.beside')}>
        ${besideChoices(this, beside, voice)}
        ${this.#strangers(beside, voice)}
        <div class="planes-beside">
          <div class="planes" style="width: ${layout ? `${layout.width}px` : '100%'}; height: ${layout?.height ?? 200}px">
            <shimmy-canvas .label=${this.#label(beside, voice)} .paint=${this.#paint}></shimmy-canvas>
            ${layout?.boxes.map(({ left, right, top, bottom }, i) => {
              const does = items[i] ? `${this.#nameInWords(items[i], voice)}, ${this.#shareInWords(items[i], voice)}. ${voice.say('beside.open')}` : '';
              return html`<button type="button" aria-label=${does} title=${does} style="left: ${left}px; top: ${top}px; width: ${right - left}px; height: ${bottom - top}px"
                @click=${() => this.#open(items[i], beside)}></button>`;
            })}
          </div>
        </div>
        ${figuresTable(this, {
          caption: voice.say('beside.table'), columns: this.#columns(beside, voice), rows: items, of: 'besideSort', sorting: this.settings.besideSort ?? '',
          classOf: (item) => (this.#isNow(item) ? 'now' : ''),
        }, voice)}
        <p class="table-out">
          <span>${this.#ranges(beside, voice)}</span>
          <button type="button" class="framed" @click=${() => this.#takeAlong(beside, voice)}>${voice.say('table.csv')}</button>
          <span role="status">${this.said}</span>
        </p>
      </div>`;
  }

  updated() {
    const place = this.querySelector('.planes-beside');
    if (place !== this.#observed) {
      this.#observer.disconnect();
      if (place) this.#observer.observe(place);
      this.#observed = place;
    }
    super.updated();
  }

  /** @param {import('./panel.js').Scene} scene @param {import('./panel.js').Theme} theme */
  draw(scene, theme) {
    super.draw(scene, theme);
    const beside = this.#beside;
    if (!beside || this.isVeiled) return;
    this.#planes.look(scene, beside);
    if (!this.#planes.isDone && !this.#frame) this.#advance();
  }

  /** Some planes now, the others in the frames to come. */
  #advance = () => {
    this.#frame = 0;
    if (this.isVeiled) return;
    this.#planes.advance(slice);
    this.items = this.#planes.items;
    if (!this.#planes.isDone && !this.#frame) this.#frame = requestAnimationFrame(this.#advance);
  };

  /** @param {Beside} beside @param {Voice} voice */
  #layout(beside, voice) {
    const { theme, width } = this;
    if (!theme || !this.#ruler || !(width > 0)) return null;
    const ruler = this.#ruler;
    const [count, others] = beside.lists.map(({ values }) => values.length);
    if (others) {
      const heads = this.#heads(beside, voice);
      const lay = (/** @type {import('./panel.js').Theme} */ theme) => ({ theme, ...layGrid(width, [count, others], theme, {
        heads: [widthOfHeads(ruler, heads[0], theme), widthOfHeads(ruler, heads[1], theme)], ends: widthOfEnds(ruler, this.#endsOf(beside.y, voice), theme),
      }) });
      const usual = lay(theme);
      return usual.width <= width ? usual : lay({ ...theme, size: Math.min(theme.size, Math.max(smallest * theme.size, readable)) });
    }
    const ends = widthOfEnds(ruler, this.#endsOf(beside.y, voice), theme);
    const low = { theme, ...layBeside(width, count, theme, { isTall: false, ends }) };
    const room = low.boxes[0].right - low.boxes[0].left;
    const isTall = this.items.some((item) => widthOfWords(ruler, { label: this.#labelOf(item, voice), share: this.#shareInWords(item, voice) }, theme) > room);
    return isTall ? { theme, ...layBeside(width, count, theme, { isTall, ends }) } : low;
  }

  /** @type {import('../../view/canvas.js').Paint} */
  #paint = (context, size) => {
    const { voice, scene, items } = this;
    const beside = this.#beside;
    const layout = beside && voice && this.#layout(beside, voice);
    if (!voice || !scene || !layout) return;
    const { theme } = layout;
    const { x, y } = beside;
    // The ranges are read where one stands, however far the planes can be scrolled.
    drawPlanesBeside(context, { ...size, width: Math.min(size.width, this.width) }, {
      x, y, ranges: [voice.say('beside.ranges', this.#rangesOf(beside, voice)), this.#ranges(beside, voice)],
      heads: layout.grid ? this.#heads(beside, voice) : null, ends: { x: this.#endsOf(x, voice), y: this.#endsOf(y, voice) },
      point: { x: scene.parameters[x.parameter], y: scene.parameters[y.parameter] },
      planes: items.map((item, i) => ({
        ...(item.map && layout.plots[i] ? this.#pictures.of(item.map, layout.plots[i], theme) : { image: null, hatch: null }),
        boundary: item.boundary, label: layout.grid ? [] : this.#labelOf(item, voice), share: this.#shareInWords(item, voice), isOld: item.isOld, isNow: this.#isNow(item),
      })),
    }, layout, theme);
  };

  /** What is said where a comparison of the thesis is made of another gear. @param {Beside} beside @param {Voice} voice */
  #strangers(beside, voice) {
    const text = writeBeside(beside);
    if (!readyBesides.some((one) => one.text === text)) return nothing;
    const varied = [beside.x, beside.y, ...beside.lists].map(({ parameter }) => parameter);
    return strangersNote(strangersOf(this.quantities, this.scene?.parameters, varied), this.isGapped && varied.includes('torsionalStiffness'), (values) => this.put(values), voice);
  }

  /** Whether the gear has these values. @param {Item} item */
  #isNow({ values }) {
    return Object.entries(values).every(([name, value]) => this.scene?.parameters[name] === value);
  }

  /** What the rows and the columns of a grid are of. @param {Beside} beside @param {Voice} voice */
  #heads({ lists }, voice) {
    return lists.map(({ parameter, values }) => values.map((value) => this.#labelOf({ values: { [parameter]: value } }, voice)));
  }

  /** @param {import('../../run/linear-looks.js').Range} range @param {Voice} voice */
  #endsOf({ parameter, from, to }, voice) {
    const quantity = this.quantity(parameter);
    return [from, to].map((value) => (quantity ? shortNumber(quantity, value, voice) : ''));
  }

  /** What sets a plane apart: `e 0.105 m · σ 0.02 m`. @param {Pick<Item, 'values'>} item @param {Voice} voice @returns {import('../../view/text.js').Run[]} */
  #labelOf({ values }, voice) {
    const names = Object.keys(values);
    return names.flatMap((name, i) => {
      const quantity = this.quantity(name);
      if (!quantity) return [];
      const [symbol, sub] = quantity.parameter.symbol.split('_');
      const number = shortNumber(quantity, values[name], voice);
      return [...(i > 0 ? [{ text: '  ' }] : []), { symbol, sub }, { text: ` ${names.length > 1 ? number : withUnit(number, quantity.unit)}` }];
    });
  }

  /** @param {Item} item @param {Voice} voice */
  #nameInWords({ values }, voice) {
    return Object.entries(values).map(([name, value]) => {
      const quantity = this.quantity(name);
      return quantity ? `${plainSymbol(quantity)} ${withUnit(shortNumber(quantity, value, voice), quantity.unit)}` : '';
    }).join(', ');
  }

  /** @param {Item} item @param {Voice} voice */
  #shareInWords({ share, isOld }, voice) {
    if (share === null) return isOld ? '' : voice.say('beside.none');
    return voice.say('beside.share', { share: voice.number(share, 2) });
  }

  /** @param {Beside} beside @param {Voice} voice */
  #rangesOf({ x, y }, voice) {
    const [across, up] = [this.quantity(x.parameter), this.quantity(y.parameter)];
    return { x: across ? rangeInWords(across, x, voice) : '', y: up ? rangeInWords(up, y, voice) : '' };
  }

  /** @param {Beside} beside @param {Voice} voice */
  #ranges(beside, voice) {
    const { x, y } = this.#rangesOf(beside, voice);
    return `→ ${x}, ↑ ${y}`;
  }

  /** @param {Beside} beside @param {Voice} voice */
  #label(beside, voice) {
    return voice.say('beside.name', { count: this.items.length, ...this.#rangesOf(beside, voice) });
  }

  /** @param {Beside} beside @param {Voice} voice @returns {import('./figures-table.js').Column<Item>[]} */
  #columns({ lists }, voice) {
    return [
      ...lists.flatMap(({ parameter }, i) => {
        const quantity = this.quantity(parameter);
        if (!quantity) return [];
        const text = (/** @type {Item} */ { values }) => shortNumber(quantity, values[parameter], voice);
        return [{
          name: parameter, title: html`${symbolOf(quantity.parameter.symbol)}${quantity.unit ? html` <span class="unit">${quantity.unit}</span>` : nothing}`,
          value: (/** @type {Item} */ { values }) => values[parameter],
          show: (/** @type {Item} */ item) => (i > 0 ? text(item) : html`<button type="button" class="plain" title=${voice.say('beside.open')} @click=${() => this.#open(item, this.#beside)}>${text(item)}</button>`),
        }];
      }),
      { name: 'share', title: voice.say('beside.column'), value: ({ share }) => share, show: ({ share }) => (share === null ? '–' : voice.number(share, 4)) },
    ];
  }

  /** Goes to a plane: the gear gets its values, and it is seen large. @param {Item} item @param {Beside | null} beside */
  #open({ values }, beside) {
    if (!beside) return;
    const { coloring } = planeOf(this.settings.plane ?? '', this.quantities.map(({ parameter }) => parameter));
    this.put(values);
    tell(this, 'view', { of: 'plane', shows: writePlane({ x: beside.x, y: beside.y, coloring }) });
    tell(this, 'view', { of: 'stability', shows: 'plane' });
  }

  /** The table as a file: the values and the share, with the ranges that it is of and what the gear has besides, in SI. @param {Beside} beside @param {Voice} voice */
  async #takeAlong(beside, voice) {
    const { x, y, lists } = beside;
    const named = (/** @type {string} */ parameter, what = '') => ({ name: parameter + what, unit: this.quantity(parameter)?.parameter.unit ?? '' });
    const varied = [x, y, ...lists].map(({ parameter }) => parameter);
    const fixed = this.quantities.filter(({ name }) => !varied.includes(name)).map(({ name }) => ({ name, value: this.scene?.parameters[name] ?? null }));
    const columns = [
      ...lists.map(({ parameter }) => named(parameter)), { name: 'stableShare', unit: '%' },
      ...[x, y].flatMap(({ parameter }) => [named(parameter, ' from'), named(parameter, ' to')]),
      ...fixed.map((one) => named(one.name)),
    ];
    const rows = sorted(this.items, this.#columns(beside, voice), this.settings.besideSort ?? '')
      .map(({ values, share }) => [...Object.values(values), share, x.from, x.to, y.from, y.to, ...fixed.map(({ value }) => value)]);
    const name = `shimmy-stable-share-${lists.map(({ parameter }) => parameter).join('-')}.csv`;
    const outcome = await download(new Blob([tableCsv(columns, rows)], { type: 'text/csv' }), name);
    this.said = outcome === 'cancelled' ? '' : voice.say(`out.${outcome}`, { file: name });
    await this.updateComplete;
    // The panel may end above it.
    if (this.said) this.querySelector('.table-out [role="status"]')?.scrollIntoView({ block: 'nearest' });
  }
}

customElements.define('shimmy-beside', BesidePlanes);
