import { html } from 'lit';
import { tell } from '../../command.js';
import { runJob } from '../../engine/workers.js';
import '../../view/canvas.js';
import { drawBifurcation } from '../../view/bifurcation.js';
import { drawRollHistory } from '../../view/roll-history.js';
import { drawRunway } from '../../view/runway.js';
import { roundLimit } from '../../view/scale.js';
import { heightsOf, highest, turnsOf } from '../cycles/branches.js';
import { pointsOf, restOf } from '../cycles/diagram.js';
import { isVelocityUnit } from '../../controls/unit.js';
import { Panel } from '../stability/panel.js';
import { isSameList } from '../../store.js';
import { branchSpec } from './ask.js';
import { gearOf, isLive, rollNow } from './gear.js';
import { amplitudesOf, windowOf } from './roll.js';
import { RollFields } from './roll-fields.js';
import { RollWork } from './roll-work.js';
import { reasonsInWords, speedOf, summaryOf } from './say.js';

/**
 * @typedef {import('../../run/scene.js').Scene} Scene
 * @typedef {import('../../style/theme.js').Theme} Theme
 * @typedef {import('../../words/voice.js').Voice} Voice
 */

const degree = Math.PI / 180;
/** The window around now, in s. */
const span = /** @type {[number, number]} */ ([-0.08, 0.04]);
/** Samples that are enough for it. */
const windowSamples = 240;
/** One arrow key moves the time by this share of the roll. */
const keyStep = 0.01;
/** While its height would tell how wide it swings, an axis ends here, in rad. */
const veiledLimit = 20 * degree;
/** Swings below it are drawn as if they were as wide, or rest would look like shimmy, in rad. */
const leastLimit = 2 * degree;

/**
 * The landing roll: the runway, the torsion angle in full, the speed over the branches of cycles, and why. Dragging over runway or
 * history, or arrow keys, move the time. Commands: `view` with another landing, `seek` and `settle` where the gear on the stage lands.
 */
export class LandingRoll extends Panel {
  #work = new RollWork(runJob);
  #fields = new RollFields(this);
  /** The time that is looked at while the gear on the stage does not land, in s; null for that of the widest swing. @type {number | null} */ #looked = null;
  /** Where a hand meets the pictures. @type {Record<string, ((x: number) => number) | null>} */ #from = {};
  /** @type {Map<string, readonly unknown[]>} */ #drawn = new Map();

  constructor() {
    super();
    this.#work.onChange = () => this.requestUpdate();
  }

  disconnectedCallback() {
    this.#work.stop();
    super.disconnectedCallback();
  }

  get velocityUnit() {
    const unit = this.quantity('velocity')?.unit;
    return isVelocityUnit(unit) ? unit : 'm/s';
  }

  get #roll() {
    return rollNow(this.scene, this.settings);
  }

  /** Which time of the roll is looked at, in s: that of the gear on the stage where it lands. */
  get #time() {
    const { stop, widest } = this.#work.seen?.shimmy ?? {};
    const time = this.scene && isLive(this.scene) ? this.scene.time : this.#looked ?? (this.isVeiled ? 0 : widest?.time ?? 0);
    return Math.min(time, stop?.time ?? 0);
  }

  /** The speed of a gear that lands is another in each frame, and nothing in words but the place. @param {Scene} scene @param {Theme} theme */
  draw(scene, theme) {
    if (scene.landing && this.scene?.landing === scene.landing && this.theme === theme) {
      Object.assign(this, { scene });
      this.#tellPlace();
    } else super.draw(scene, theme);
    if (!this.isVeiled) this.#work.look(gearOf(scene), this.#roll);
    const { seen, isOld, diagram, isDiagramOld } = this.#work;
    const from = [seen, isOld, diagram, isDiagramOld, this.#time, this.voice, this.quantities, this.isVeiled, theme];
    for (const name of ['runway', 'history', 'under']) this.#redrawWhere(`.roll-${name} shimmy-canvas`, from);
  }

  /** Where it is now, for those who hear it. */
  #tellPlace() {
    const quantity = this.quantity('velocity');
    if (!this.voice || !quantity) return;
    for (const grip of this.querySelectorAll('.roll-grip')) {
      grip.setAttribute('aria-valuenow', this.#time.toFixed(2));
      grip.setAttribute('aria-valuetext', this.#place(quantity, this.voice));
    }
  }

  /** @param {string} selector @param {readonly unknown[]} from */
  #redrawWhere(selector, from) {
    if (isSameList(this.#drawn.get(selector) ?? [], from)) return;
    this.#drawn.set(selector, from);
    /** @type {import('../../view/canvas.js').Canvas | null} */ (this.querySelector(selector))?.redraw();
  }

  updated() {
    this.#drawn.clear();
    if (this.scene && this.theme) this.draw(this.scene, this.theme);
  }

  render() {
    const { voice, scene } = this;
    if (!voice || !scene) return html``;
    const quantity = this.quantity('velocity');
    if (!quantity) return html`<p class="panel-empty">${voice.say('landing.foreign')}</p>`;
    return html`
      <div class="landing-roll">
        ${this.#fields.template(this.#roll, (roll) => tell(this, 'landing', roll), this.#touchdown(voice), voice)}
        ${this.isVeiled ? this.veil(voice) : this.#words(quantity, voice)}
        ${['runway', 'history'].map((name) => html`
          <div class="roll-${name} roll-grip" role="slider" tabindex="0" aria-label=${voice.say(name === 'runway' ? 'landing.runway' : 'landing.history')} aria-description=${voice.say('landing.seek')}
            aria-valuemin="0" aria-valuemax=${(this.#work.seen?.shimmy.stop.time ?? 0).toFixed(2)} aria-valuenow=${this.#time.toFixed(2)} aria-valuetext=${this.#place(quantity, voice)}
            @pointerdown=${this.#grab} @pointermove=${this.#move} @pointerup=${this.#release} @keydown=${this.#key}>
            <shimmy-canvas aria-hidden="true" .paint=${name === 'runway' ? this.#paintRunway : this.#paintHistory}></shimmy-canvas>
          </div>`)}
        <div class="roll-under"><shimmy-canvas .label=${voice.say(this.isVeiled ? 'landing.under.veiled' : 'landing.under')} .paint=${this.#paintUnder}></shimmy-canvas></div>
      </div>`;
  }

  /** @param {Voice} voice */
  #touchdown(voice) {
    return html`<button type="button" class="framed touchdown" title=${voice.say('landing.touch.does')} @click=${() => tell(this, 'land')}>${voice.say('landing.touch')}</button>`;
  }

  /** @param {import('../../controls/quantity.js').Quantity} quantity @param {Voice} voice */
  #words(quantity, voice) {
    const { seen, isFailed, isOld, reasons } = this.#work;
    if (isFailed) return html`<p class="roll-words">${voice.say('landing.failed')}</p>`;
    if (!seen) return html`<p class="roll-words" role="status">${voice.say('landing.working')}</p>`;
    const why = reasonsInWords(reasons, seen.threshold, quantity, voice);
    return html`
      <div class="roll-words ${isOld ? 'old' : ''}" role="status">
        <p class=${seen.shimmy.begins ? 'is-unstable' : ''}><b>${summaryOf(seen.shimmy, seen.threshold, quantity, voice)}</b></p>
        <p class="theory">${why.join(' ')}</p>
      </div>`;
  }

  /** Where the time is, for those who do not see it. @param {import('../../controls/quantity.js').Quantity} quantity @param {Voice} voice */
  #place(quantity, voice) {
    const { seen } = this.#work;
    if (!seen) return '';
    const { time, velocity, distance } = seen.at(this.#time);
    return voice.say('landing.place', { time: voice.number(time, 1), speed: speedOf(velocity, quantity, voice), distance: voice.number(distance, 0) });
  }

  /** The end of axes of ψ. */
  get #limit() {
    const { seen } = this.#work;
    return this.isVeiled || !seen ? veiledLimit : Math.max(leastLimit, roundLimit(seen.shimmy.widest.angle / degree) * degree);
  }

  /** @type {import('../../view/canvas.js').Paint} */
  #paintRunway = (context, size) => {
    const { voice, theme, isVeiled } = this;
    const quantity = this.quantity('velocity');
    const { seen, isOld } = this.#work;
    if (!voice || !theme || !quantity) return;
    const roll = this.#roll;
    const usual = { length: (roll.touchdownVelocity ** 2 - roll.finalVelocity ** 2) / (2 * roll.deceleration), distance: [], low: [], high: [], limit: 1, shimmy: null, flags: [], now: null, fastest: roll.touchdownVelocity, isOld: false, veiled: isVeiled };
    const places = drawRunway(context, size, seen ? this.#runway(seen, isOld, quantity, voice) : usual, theme, voice);
    this.#from.runway = places && seen ? (x) => timeAt(seen, places.from(x)) : null;
  };

  /** @param {import('./roll-work.js').Seen} seen @param {boolean} isOld @param {import('../../controls/quantity.js').Quantity} quantity @param {Voice} voice @returns {import('../../view/runway.js').Shown} */
  #runway({ shimmy, stretches, at }, isOld, quantity, voice) {
    const { touchdown, stop, begins, ends } = shimmy;
    const flag = (/** @type {'touchdown' | 'begins' | 'ends' | 'stop'} */ key, /** @type {{ distance: number, velocity: number }} */ moment) => ({
      distance: moment.distance, kind: /** @type {'plain' | 'shimmy'} */ (key === 'begins' || key === 'ends' ? 'shimmy' : 'plain'),
      text: `${voice.say(`landing.flag.${key}`)} ${speedOf(moment.velocity, quantity, voice)}`,
    });
    return {
      length: stop.distance, distance: stretches.distance, low: stretches.low, high: stretches.high, limit: 1.25 * this.#limit,
      shimmy: begins && [begins.distance, (ends ?? stop).distance], now: at(this.#time), fastest: touchdown.velocity, isOld, veiled: this.isVeiled,
      flags: [flag('touchdown', touchdown), ...(begins ? [flag('begins', begins)] : []), ...(ends ? [flag('ends', ends)] : []), flag('stop', stop)],
    };
  }

  /** @type {import('../../view/canvas.js').Paint} */
  #paintHistory = (context, size) => {
    const { voice, theme, scene } = this;
    const quantity = this.quantity('velocity');
    const { seen, isOld } = this.#work;
    if (!voice || !theme || !scene || !quantity || !seen) return;
    const { shimmy, stretches, threshold, roll } = seen;
    const { touchdown, stop } = shimmy;
    const unit = quantity.toSI(10);
    const speeds = Array.from({ length: Math.floor(touchdown.velocity / unit) + 1 }, (_, i) => Math.floor(touchdown.velocity / unit) * unit - i * unit)
      .filter((speed) => speed >= stop.velocity).map((speed) => ({ time: timeOfSpeed(seen, speed), text: voice.number(quantity.toShown(speed), 0) }));
    if (speeds[0]) speeds[0].text += ` ${quantity.unit}`;
    const places = drawRollHistory(context, size, {
      from: touchdown.time, to: stop.time, band: stretches, limit: this.#limit, threshold, freeplay: scene.parameters.freeplayAngle ?? 0, now: this.#time,
      speeds, window: windowOf(roll, this.#time + span[0], this.#time + span[1], windowSamples), span, isOld, veiled: this.isVeiled,
    }, theme, voice);
    this.#from.history = places?.from ?? null;
  };

  /** @type {import('../../view/canvas.js').Paint} */
  #paintUnder = (context, size) => {
    const { voice, theme, scene, isVeiled } = this;
    const quantity = this.quantity('velocity');
    if (!voice || !theme || !scene || !quantity) return;
    const { seen, isOld, diagram, isDiagramOld } = this.#work;
    const { from, to } = branchSpec(gearOf(scene), this.#roll);
    const limit = Math.max(this.#limit, diagram && !isVeiled ? roundLimit(highest(diagram, 'torsionAngle') / degree) * degree : 0);
    const now = seen?.at(this.#time);
    const amplitudes = seen && amplitudesOf(seen.stretches);
    drawBifurcation(context, size, {
      quantity, from, to, height: 'torsionAngle', limit, law: null, sweep: [], cursor: null, isOld: isDiagramOld, message: '', veiled: isVeiled,
      rest: diagram && restOf(diagram, 'torsionAngle', scene.parameters['friction.moment'] ?? 0),
      branches: diagram?.cycles.map((branch, i) => ({ across: branch.velocity, up: heightsOf(branch, 'torsionAngle'), stable: branch.stable, turns: turnsOf(diagram, i) })) ?? [],
      points: diagram ? pointsOf(diagram, { height: 'torsionAngle', quantity, isRubbed: scene.linear.isRubbed }, voice) : [],
      now: { value: now?.velocity ?? this.#roll.touchdownVelocity, motion: now && amplitudes && seen ? amplitudes[placeOf(seen, now.time)] : null, cycle: null },
      path: seen && amplitudes ? { across: seen.stretches.velocity, up: amplitudes, text: voice.say('landing.path'), isOld } : undefined,
    }, theme, voice);
  };

  /** @param {PointerEvent} event */
  #grab(event) {
    if (event.button !== 0) return;
    /** @type {HTMLElement} */ (event.currentTarget).setPointerCapture(event.pointerId);
    this.#drag(event);
  }

  /** @param {PointerEvent} event */
  #move(event) {
    if (/** @type {HTMLElement} */ (event.currentTarget).hasPointerCapture(event.pointerId)) this.#drag(event);
  }

  #release() {
    if (this.scene && isLive(this.scene)) tell(this, 'settle');
  }

  /** @param {PointerEvent} event */
  #drag(event) {
    const grip = /** @type {HTMLElement} */ (event.currentTarget);
    const from = this.#from[grip.classList.contains('roll-runway') ? 'runway' : 'history'];
    if (from) this.#goTo(from(event.clientX - grip.getBoundingClientRect().left));
  }

  /** @param {KeyboardEvent} event */
  #key(event) {
    const end = this.#work.seen?.shimmy.stop.time ?? 0;
    const step = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1 }[event.key];
    const to = step ? this.#time + step * keyStep * end * (event.shiftKey ? 10 : 1) : { Home: 0, End: end }[event.key];
    if (to === undefined || this.isVeiled) return;
    event.preventDefault();
    event.stopPropagation();
    this.#goTo(to);
  }

  /** @param {number} time in s */
  #goTo(time) {
    if (this.isVeiled) return;
    const wanted = Math.min(Math.max(time, 0), this.#work.seen?.shimmy.stop.time ?? 0);
    if (this.scene && isLive(this.scene)) tell(this, 'seek', wanted);
    this.#looked = wanted;
    this.requestUpdate();
  }
}

/** Which stretch a time is in. @param {import('./roll-work.js').Seen} seen @param {number} time */
function placeOf({ stretches, shimmy }, time) {
  const count = stretches.time.length;
  return Math.min(count - 1, Math.max(0, Math.floor((time / shimmy.stop.time) * count)));
}

/** When it was so far. @param {import('./roll-work.js').Seen} seen @param {number} distance in m */
function timeAt({ at, shimmy }, distance) {
  return whereOf((time) => at(time).distance < distance, shimmy.stop.time);
}

/** When it was so fast. @param {import('./roll-work.js').Seen} seen @param {number} velocity in m/s */
function timeOfSpeed({ at, shimmy }, velocity) {
  return whereOf((time) => at(time).velocity > velocity, shimmy.stop.time);
}

/** Until when something holds that holds at first and then no more. @param {(time: number) => boolean} holds @param {number} end in s */
function whereOf(holds, end) {
  let [before, after] = [0, end];
  for (let i = 0; i < 40; i++) {
    const middle = (before + after) / 2;
    if (holds(middle)) before = middle;
    else after = middle;
  }
  return (before + after) / 2;
}

customElements.define('shimmy-landing-roll', LandingRoll);
