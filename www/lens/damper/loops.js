import { html } from 'lit';
import { parseList } from '../../words/list.js';
import '../../view/canvas.js';
import { drawCylinder, shareOf } from '../../view/damper/cylinder.js';
import { drawLoops } from '../../view/damper/loops.js';
import { drawSchematic } from '../../view/damper/schematic.js';
import { roundLimit } from '../../view/scale.js';
import { Bench } from './bench.js';
import { DamperHand } from './hand.js';
import { DamperPanel } from './panel.js';
import { isCurrents, mostCurrents } from './settings.js';

/**
 * @typedef {import('../../words/voice.js').Voice} Voice
 * @typedef {import('../../run/damper-looks.js').Cycle} Cycle
 */

/** Fractions of the stroke that a press of a key moves the piston. */
const keyStep = 0.1;
/** After a hand has let go the bench goes on, in ms. */
const patience = 2500;

/**
 * A damper's loops at several commands while its piston goes to and fro, with the point of now, and above them the model at work; beneath the damper itself, whose piston a hand can move.
 * Commands: `view` with the damper, its motion, the commands and which of them is chosen.
 */
export class DamperLoops extends DamperPanel {
  static properties = { ...DamperPanel.properties, refused: { state: true }, heard: { state: true } };

  #bench = new Bench();
  #hand = new DamperHand();
  /** Where the pointer took hold, in px. */ #from = 0;
  #frame = 0;
  #timer = 0;
  /** Axes hold while a slider moves, and are fitted anew once the loops are much smaller. @type {{ of: string, limits: import('../../view/damper/loops.js').Place }} */
  #axes = { of: '', limits: { displacement: 1, velocity: 1, force: 1 } };

  constructor() {
    super();
    /** A list of commands that was not taken. */ this.refused = '';
    /** What the piston in the hand says of itself. */ this.heard = '';
  }

  disconnectedCallback() {
    this.#letBe();
    super.disconnectedCallback();
  }

  /** The commands with their cycles. */
  get #loops() {
    const { table } = this;
    return table ? this.currents.map((command) => ({ command, cycle: this.cycleOf({ model: table.name, command }) })).filter((one) => one.cycle !== null) : [];
  }

  /** @param {Voice} voice */
  content(voice) {
    const { table, isVeiled, currents, chosen } = this;
    if (!table) return html``;
    return html`
      <div class="damper-loops">
        <div class="plane-choices">
          ${this.modelChoice(voice)}
          <span class="commands" role="group" aria-label=${voice.say('damper.currents')}>
            ${currents.map((command, i) => html`<button type="button" class="framed" aria-pressed=${i === chosen ? 'true' : 'false'} @click=${() => this.choose('damperCurrent', String(command))}>${this.commandOf(command, voice)}</button>`)}
          </span>
          <input type="text" class="list" inputmode="decimal" autocomplete="off" aria-label=${voice.say('damper.currents.list')} title=${voice.say('damper.currents.list')} aria-invalid=${this.refused ? 'true' : 'false'}
            aria-describedby="damper-currents-why" .value=${this.refused || currents.map((one) => this.#bare(one, voice)).join('; ')} @change=${this.#listed} />
          <p class="why-refused" id="damper-currents-why" role="alert">${this.refused ? voice.say('damper.currents.refused', { most: mostCurrents, min: voice.number(table.command.min, 2), max: voice.number(table.command.max, 2), unit: table.command.unit }) : ''}</p>
        </div>
        <shimmy-canvas class="damper-schematic" .label=${voice.say(this.#isSeries ? 'damper.schematic.series' : 'damper.schematic.parallel')} .paint=${this.#paintSchematic}></shimmy-canvas>
        <shimmy-canvas class="damper-plots" .label=${isVeiled ? voice.say('damper.loops.veiled') : this.#label(voice)} .paint=${this.#paintLoops}></shimmy-canvas>
        <div class="damper-cylinder" role="slider" tabindex="0" aria-label=${voice.say('damper.hand')} title=${voice.say('damper.hand')} aria-orientation="horizontal"
          aria-valuemin="-100" aria-valuemax="100" aria-valuenow=${Math.round(100 * this.#shareNow)} aria-valuetext=${this.heard || voice.say('damper.hand.free')}
          @pointerdown=${this.#grab} @pointermove=${this.#drag} @pointerup=${this.#drop} @pointercancel=${this.#drop} @keydown=${this.#key} @blur=${this.#drop}>
          <shimmy-canvas .paint=${this.#paintCylinder} aria-hidden="true"></shimmy-canvas>
        </div>
        <p class="damper-rate">${voice.say('damper.rate', { seconds: voice.number(this.#bench.secondsACycle, 0), true: voice.number(1 / this.motion.frequency, 3) })}</p>
        ${this.motionKnobs(voice)}
      </div>`;
  }

  get #isSeries() {
    return this.table?.state.some(({ name }) => name === 'internalDisplacement') ?? false;
  }

  /** @param {number} command @param {Voice} voice */
  #bare = (command, voice) => this.commandOf(command, voice).split(' ')[0];

  /** @param {Event} event */
  #listed = (event) => {
    const { value } = /** @type {HTMLInputElement} */ (event.target);
    const { values, stranger } = parseList(value);
    const command = this.table?.command;
    const isTaken = stranger === null && values.length > 0 && isCurrents(values.join(',')) && command !== undefined && values.every((one) => one >= command.min && one <= command.max);
    this.refused = isTaken ? '' : value;
    if (isTaken) this.choose('damperCurrents', [...new Set(values)].sort((one, other) => one - other).join(','));
  };

  /** What the loops are, in numbers. @param {Voice} voice */
  #label(voice) {
    const list = this.#loops.map(({ command, cycle }) => `${this.commandOf(command, voice)}: ±${voice.number(mostOf(/** @type {Cycle} */ (cycle).force), 0)} N`).join('; ');
    return voice.say('damper.loops.name', { list: list || '–' });
  }

  /** The point goes on with the page's clock. @param {import('../../run/scene.js').Scene} scene @param {import('../../style/theme.js').Theme} theme */
  draw(scene, theme) {
    const before = this.scene;
    super.draw(scene, theme);
    if (!before) this.requestUpdate();
    this.#bench.follow(scene, performance.now());
    this.#redraw();
  }

  #redraw() {
    const { grip, isHeld } = this.#hand;
    for (const name of ['.damper-schematic', '.damper-plots', '.damper-cylinder shimmy-canvas'])
      this.redrawWhere(name, [this.#bench.phase, grip, isHeld, this.settings, this.voice, this.theme, this.isVeiled, this.scene?.scales]);
  }

  /** The damper in the hand. */
  get #chosenDamper() {
    const { table, currents, chosen } = this;
    return table && { model: table.name, command: currents[chosen] };
  }

  #take() {
    const { scene } = this;
    const damper = this.#chosenDamper;
    if (!scene || !damper || this.isVeiled) return false;
    clearTimeout(this.#timer);
    if (!this.#hand.grip) this.#hand.hold(scene.dampers, damper);
    this.#hand.isHeld = true;
    if (!this.#frame) this.#frame = requestAnimationFrame(this.#tick);
    return true;
  }

  #tick = (/** @type {number} */ now) => {
    this.#frame = 0;
    this.#hand.step(now);
    this.#redraw();
    const { grip, isMoving } = this.#hand;
    if (grip && this.voice) this.heard = this.voice.say('damper.hand.says', { displacement: this.voice.number(1000 * grip.displacement, 1), force: this.voice.number(grip.force, 0) });
    if (isMoving && this.isConnected) this.#frame = requestAnimationFrame(this.#tick);
  };

  /** @param {PointerEvent} event */
  #grab = (event) => {
    const element = /** @type {HTMLElement} */ (event.currentTarget);
    if (!this.#take()) return;
    element.setPointerCapture(event.pointerId);
    this.#from = event.clientX - this.#pixels(this.#hand.target);
  };

  /** @param {PointerEvent} event */
  #drag = (event) => {
    if (this.#hand.isHeld && event.buttons > 0) this.#aim((event.clientX - this.#from) / this.#pixels(1));
  };

  #drop = () => {
    if (!this.#hand.isHeld) return;
    this.#hand.release();
    clearTimeout(this.#timer);
    this.#timer = window.setTimeout(() => this.#letBe(), patience);
  };

  /** @param {KeyboardEvent} event */
  #key = (event) => {
    const steps = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1 }[event.key];
    if (event.key === 'Escape' && this.#hand.grip) {
      event.stopPropagation();
      this.#letBe();
    }
    if (!steps || !this.#take()) return;
    event.preventDefault();
    event.stopPropagation();
    this.#aim(this.#hand.target + steps * keyStep * (event.shiftKey ? 5 : 1) * this.motion.amplitude);
  };

  /** @param {number} target in m */
  #aim(target) {
    const most = this.#axes.limits.displacement;
    this.#hand.target = Math.min(most, Math.max(-most, target));
  }

  /** A displacement on the drawing, in px. @param {number} displacement in m */
  #pixels(displacement) {
    const size = /** @type {import('../../view/canvas.js').Canvas | null} */ (this.querySelector('.damper-cylinder shimmy-canvas'))?.size ?? { width: 1, height: 1 };
    return displacement / (this.#axes.limits.displacement * shareOf(size, 1));
  }

  #letBe() {
    cancelAnimationFrame(this.#frame);
    clearTimeout(this.#timer);
    this.#frame = 0;
    this.#hand.letBe();
    this.heard = '';
    this.#redraw();
  }

  /** Where the piston is, as a share of the axis. */
  get #shareNow() {
    const place = this.#place();
    return place ? place.displacement / this.#axes.limits.displacement : 0;
  }

  /** Where piston and force are: in the hand, else on the bench. */
  #place() {
    const { grip } = this.#hand;
    if (grip) return grip;
    const now = this.#now();
    if (!now) return null;
    const { cycle, at } = now;
    return { displacement: cycle.displacement[at], velocity: cycle.velocity[at], force: cycle.force[at], hysteresis: cycle.hysteresis[at], internalDisplacement: cycle.internalDisplacement[at] };
  }

  /** @param {Map<string, unknown>} changed */
  willUpdate(changed) {
    // Under the hand the fluid stiffens at once; another damper is another piston.
    if (!changed.has('settings') || !this.#hand.grip) return;
    const before = /** @type {typeof this.settings | undefined} */ (changed.get('settings'));
    if (before?.damperModel !== this.settings.damperModel || this.isVeiled) this.#letBe();
    else this.#hand.command(this.currents[this.chosen]);
  }

  /** The chosen cycle, where the piston is in it, and the most of each of its columns. */
  #now() {
    const { chosen } = this;
    const loop = this.#loops.find(({ command }) => command === this.currents[chosen]);
    if (!loop?.cycle) return null;
    const { cycle } = loop;
    const at = Math.floor(this.#bench.phase * cycle.force.length) % cycle.force.length;
    return { command: loop.command, cycle, at };
  }

  /** @type {import('../../view/canvas.js').Paint} */
  #paintSchematic = (context, size) => {
    const { voice, theme, table } = this;
    if (!voice || !theme || !table) return;
    const now = this.#now();
    const place = this.#place();
    const share = (/** @type {'displacement' | 'internalDisplacement' | 'hysteresis' | 'force'} */ name) => (now && place ? Math.min(1.3, Math.max(-1.3, place[name] / (mostOf(now.cycle[name]) || 1))) : 0);
    const pose = { x: share('displacement'), w: share('internalDisplacement'), z: share('hysteresis'), force: this.isVeiled ? 0 : share('force'), command: (now?.command ?? 0) / Math.min(table.command.max, 1.5) };
    const words = { element: voice.say('damper.part.element'), dashpot: voice.say('damper.part.dashpot'), spring: voice.say('damper.part.spring'), seriesDashpot: voice.say('damper.part.dashpot'), outerSpring: voice.say('damper.part.outerSpring') };
    drawSchematic(context, size, { isSeries: this.#isSeries, pose, words }, theme);
  };

  /** @type {import('../../view/canvas.js').Paint} */
  #paintLoops = (context, size) => {
    const { voice, theme, scene, currents, chosen } = this;
    if (!voice || !theme || !scene) return;
    const loops = this.#loops.map(({ command, cycle }) => ({ .../** @type {Cycle} */ (cycle), label: this.commandOf(command, voice), isChosen: command === currents[chosen] }));
    this.#hold(loops, scene.scales);
    const { trail } = this.#hand;
    const column = (/** @type {'displacement' | 'velocity' | 'force'} */ name) => trail.map((one) => one[name]);
    drawLoops(context, size, {
      loops, limits: this.#axes.limits, now: this.isVeiled ? null : this.#place(), veiled: this.isVeiled,
      trail: trail.length > 1 ? { displacement: column('displacement'), velocity: column('velocity'), force: column('force') } : null,
    }, theme, voice);
  };

  /** @type {import('../../view/canvas.js').Paint} */
  #paintCylinder = (context, size) => {
    const { theme, table, currents, chosen } = this;
    if (!theme || !table) return;
    const place = this.#place();
    const force = this.isVeiled || !place ? 0 : Math.min(1, Math.max(-1, place.force / this.#axes.limits.force));
    drawCylinder(context, size, { x: this.#shareNow, force, command: (currents[chosen] ?? 0) / Math.min(table.command.max, 1.5), isHeld: this.#hand.isHeld }, theme);
  };

  /** @param {readonly Pick<Cycle, 'displacement' | 'velocity' | 'force'>[]} loops @param {object} scales another after "Fit" */
  #hold(loops, scales) {
    const names = /** @type {const} */ (['displacement', 'velocity', 'force']);
    const most = (/** @type {typeof names[number]} */ name) => Math.max(1e-12, ...loops.map((loop) => mostOf(loop[name])));
    const of = this.table?.name ?? '';
    const isSame = this.#axes.of === of && this.#scales === scales;
    this.#scales = scales;
    const fits = names.every((name) => most(name) <= this.#axes.limits[name] && most(name) > 0.3 * this.#axes.limits[name]);
    if (isSame && fits) return;
    this.#axes = { of, limits: /** @type {import('../../view/damper/loops.js').Place} */ (Object.fromEntries(names.map((name) => [name, roundLimit(most(name))]))) };
  }

  #scales = /** @type {object | null} */ (null);
}

/** @param {Float64Array} values */
export const mostOf = (values) => values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);

customElements.define('shimmy-damper-loops', DamperLoops);
