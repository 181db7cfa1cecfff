import { html } from 'lit';
import { tell } from '../../command.js';
import { withUnit } from '../../controls/quantity.js';
import { isSameList } from '../../store.js';
import { drawRootLocus } from '../../view/root-locus.js';
import { locusChoices } from './locus-choices.js';
import { Loci } from './loci.js';
import { RangeFields } from './range-fields.js';
import { lineInTheory, lowerName, plainSymbol, shortNumber } from './say.js';
import { locusOf, thesisLocus, writeLocus } from './settings.js';
import { strangersNote, strangersOf } from './strangers.js';

/**
 * @typedef {import('./views.js').View} View
 * @typedef {import('../../words/voice.js').Voice} Voice
 */

/** The ways of the roots as a parameter is swept. @implements {View} */
export class LocusView {
  #lens;
  #loci = new Loci();
  /** What was drawn last, so that nothing is drawn twice. @type {unknown[]} */ #drawn = [];
  #ends;
  /** The names of what was other than in figure 5.5. */ #strange = '';

  /** @param {import('../stability.js').StabilityLens} lens */
  constructor(lens) {
    this.#lens = lens;
    this.#ends = new RangeFields(lens, 'locus');
  }

  get #locus() {
    const { settings, quantities } = this.#lens;
    return locusOf(settings.locus ?? '', quantities.map(({ parameter }) => parameter));
  }

  /** @type {View['template']} */
  template(voice) {
    const others = this.#strangers;
    return html`
      ${locusChoices(this.#lens, this.#locus, this.#lens.quantities, voice, this.#ends, others.length === 0)}
      ${writeLocus(this.#locus) === thesisLocus ? strangersNote(others, false, this.#put, voice) : ''}
      <shimmy-canvas .label=${this.#label(voice)} .paint=${this.#paint}></shimmy-canvas>`;
  }

  /** @type {View['line']} */
  line(voice) {
    const swept = this.#lens.quantity(this.#locus.sweep.parameter);
    const line = swept ? voice.say('locus.line', { sweep: lowerName(swept, voice) }) : '';
    return html`<p>${lineInTheory(line, this.#lens.leavesOut, voice)}</p>`;
  }

  stale() {
    this.#drawn = [];
  }

  /** What is other than in figure 5.5. */
  get #strangers() {
    const { sweep, family } = this.#locus;
    return this.#lens.isVeiled ? [] : strangersOf(this.#lens.quantities, this.#lens.scene?.parameters, [sweep.parameter, family?.parameter ?? '']);
  }

  #put = (/** @type {Record<string, number>} */ values) => {
    tell(this.#lens, 'point', { values, gesture: null });
    tell(this.#lens, 'settle');
  };

  /** @type {View['draw']} */
  draw(scene) {
    const { walk, theme, isVeiled } = this.#lens;
    const strange = this.#strangers.map(({ name }) => name).join();
    if (strange !== this.#strange) {
      this.#strange = strange;
      this.#lens.requestUpdate();
    }
    const wanted = [walk.roots, isVeiled ? null : this.#loci.look(scene, this.#locus), theme];
    if (isSameList(wanted, this.#drawn)) return;
    this.#drawn = wanted;
    this.#lens.canvas?.redraw();
  }

  /** @param {Voice} voice */
  #label(voice) {
    const { sweep, family } = this.#locus;
    const [swept, other] = [this.#lens.quantity(sweep.parameter), this.#lens.quantity(family?.parameter ?? '')];
    if (!swept) return '';
    const values = { sweep: lowerName(swept, voice), from: swept.write(sweep.from, voice), to: swept.write(sweep.to, voice) };
    return family && other ? voice.say('locus.name.family', { ...values, count: family.count, other: lowerName(other, voice) }) : voice.say('locus.name', values);
  }

  /** @type {import('../../view/canvas.js').Paint} */
  #paint = (context, size) => {
    const { voice, theme, scene, walk, isVeiled } = this.#lens;
    const { sweep, family } = this.#locus;
    const [swept, other] = [this.#lens.quantity(sweep.parameter), this.#lens.quantity(family?.parameter ?? '')];
    const found = scene && !isVeiled ? this.#loci.look(scene, this.#locus) : null;
    if (!voice || !theme || !swept || !(found || isVeiled)) return;
    drawRootLocus(context, size, {
      ways: (found?.ways ?? []).map(({ value, at, paths }) => ({
        paths, shares: at.map((swept) => (swept - sweep.from) / (sweep.to - sweep.from)),
        label: other && value !== null ? `${plainSymbol(other)} ${withUnit(shortNumber(other, value, voice), other.unit)}` : '',
      })),
      roots: walk.roots, limits: found?.limits ?? unseen,
      sweep: { symbol: plainSymbol(swept), from: shortNumber(swept, sweep.from, voice), to: withUnit(shortNumber(swept, sweep.to, voice), swept.unit) }, veiled: isVeiled,
    }, theme, voice);
  };
}

/** Axes under a veil tell nothing of what is under it. */
const unseen = { left: -100, right: 25, top: 500 };
