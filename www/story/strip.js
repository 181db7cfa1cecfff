import { LitElement, html } from 'lit';
import { tell } from '../command.js';
import { mannerOf } from '../stage/manner.js';

/**
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {{ text: string, isAlert: boolean, isStop?: boolean, canUndo?: boolean }} Note `isStop`: stands as long as the run is stopped
 * @typedef {{ place: string, sentence: string, isFigure: boolean, isQuestion: boolean, isAsking: boolean, following: string | null, preceding: string | null }} Telling
 *   a step in words; `place`: which step of which story, or which figure; `following`, `preceding`: what Next and Back open, null at the ends;
 *   `isQuestion`: the sentence asks what comes, `isAsking`: and it is not answered yet
 */

/**
 * The strip above the lens: the step of a story, else what to try with the motion as it is; or a note in its place while
 * there is something to say. Commands: `next`, `previous`, `comeBack`, `endStory`, `open`, `undo`, `closeNotes`.
 */
export class Strip extends LitElement {
  static properties = {
    voice: { attribute: false },
    notes: { attribute: false },
    outlook: { attribute: false },
    telling: { attribute: false },
    canComeBack: { attribute: false },
    isVeiled: { attribute: false },
    isCommanded: { attribute: false },
  };

  constructor() {
    super();
    /** @type {Voice | null} */ this.voice = null;
    /** @type {Note[]} */ this.notes = [];
    /** @type {import('../engine/engine.js').Outlook | null} */ this.outlook = null;
    /** @type {Telling | null} */ this.telling = null;
    /** Whether what a visitor had before the story is kept. */
    this.canComeBack = false;
    /** Whether what would tell the future is hidden. */
    this.isVeiled = false;
    /** Whether there is a damper on the gear that a current stiffens. */ this.isCommanded = false;
  }

  createRenderRoot() {
    return this;
  }

  render() {
    const { voice, notes, telling } = this;
    if (!voice) return html``;
    if (notes.length > 0) return this.#notes(voice);
    return telling ? this.#story(telling, voice) : this.#hint(voice);
  }

  /** What to try with such a motion: one that comes to rest is woken, however it gets there. */
  get #advice() {
    const manner = this.outlook ? mannerOf(this.outlook) : 'shimmies';
    if (this.outlook?.held) return 'held';
    const advice = manner === 'creeps' || manner === 'stops' ? 'rests' : manner;
    return this.isCommanded && (advice === 'shimmies' || advice === 'rests') ? /** @type {const} */ (`${advice}.commanded`) : advice;
  }

  /** @param {Voice} voice */
  #notes(voice) {
    return html`
      <div class="story note">
        <div>${this.notes.map(({ text, isAlert, canUndo }) => html`<p role=${isAlert ? 'alert' : 'status'}>${text}</p>${canUndo ? html`
          <button type="button" class="framed" @click=${() => tell(this, 'undo')}>${voice.say('header.undo')}</button>` : ''}`)}</div>
        <button type="button" class="plain icon" aria-label=${voice.say('notice.close')} title=${voice.say('notice.close')}
          @click=${() => tell(this, 'closeNotes')}>✕</button>
      </div>`;
  }

  /** @param {Telling} telling @param {Voice} voice */
  #story({ place, sentence, isFigure, isAsking, following, preceding }, voice) {
    const next = voice.say(isAsking ? 'story.predict' : 'story.next');
    return html`
      <div class="story tale ${isFigure ? 'figure' : ''}" role="group" aria-label=${place}>
        <div aria-live="polite">
          <p class="story-title">${place}</p>
          <p>${sentence}</p>
        </div>
        ${this.#wayOut(voice)}
        <div class="story-walk">
          <button type="button" class="framed back" title=${preceding ?? ''} ?disabled=${preceding === null} @click=${() => tell(this, 'previous')}>${voice.say('story.back')}</button>
          <button type="button" class="primary next" title=${isAsking ? '' : following ?? ''} ?disabled=${following === null && !isAsking}
            @click=${() => tell(this, 'next')}>${next}</button>
        </div>
      </div>`;
  }

  /** @param {Voice} voice */
  #hint(voice) {
    return html`
      <div class="story">
        <div>
          <p class="story-title">${voice.say('story.title')}</p>
          <p>${this.isVeiled ? voice.say('story.veiled') : voice.say(`story.${this.#advice}`)}</p>
        </div>
        ${this.canComeBack ? this.#wayOut(voice) : ''}
        <div class="story-walk">
          <button type="button" class="framed" @click=${() => tell(this, 'next')}>${voice.say('preset.first-look')}</button>
        </div>
      </div>`;
  }

  /** @param {Voice} voice */
  #wayOut(voice) {
    const does = voice.say(this.canComeBack ? 'story.comeBack' : 'story.end');
    return html`<button type="button" class="way-out ${this.canComeBack ? 'come-back' : ''}" title=${does} @click=${() => tell(this, this.canComeBack ? 'comeBack' : 'endStory')}>${does}</button>`;
  }
}

customElements.define('shimmy-strip', Strip);
