/** The step of a story in words, for the strip. A sentence is made once a step and language, for the engine computes its numbers. */

import { isAnswered, neighbor, told } from './player.js';
import { lookOf, sentenceOf, titleOf } from './title.js';

/**
 * @typedef {import('../app.js').App} App
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {import('./story.js').Story} Story
 * @typedef {import('./strip.js').Telling} Telling
 */

export class Teller {
  #key = '';
  #sentence = '';

  /** @param {App} app @returns {Telling | null} null without a story */
  tell(app) {
    const { engine, voice, state } = app;
    const now = told(app);
    if (!engine || !now) return null;
    const { story, at, step } = now;
    const key = `${voice.language} ${story.name} ${at}`;
    if (key !== this.#key) {
      this.#key = key;
      this.#sentence = sentenceOf(story, at, engine, voice);
    }
    return {
      place: placeOf(story, at, voice),
      sentence: this.#sentence,
      isFigure: story.kind === 'figure',
      isQuestion: step.asks !== undefined,
      isAsking: step.asks !== undefined && !state.predict && !isAnswered(app),
      following: neighborPlace(app, 1),
      preceding: neighborPlace(app, -1),
    };
  }
}

/** @param {App} app @param {1 | -1} by */
function neighborPlace(app, by) {
  const next = neighbor(app, by);
  return next && placeOf(next.story, next.at, app.voice);
}

/** "First look · 2 of 5", "Figure 5.88a · orbit in space". @param {Story} story @param {number} at @param {Voice} voice */
function placeOf(story, at, voice) {
  const title = titleOf(story, voice);
  const look = story.entry && lookOf(story.entry, voice);
  if (story.entry) return look ? `${title} · ${look}` : title;
  return voice.say('story.place', { title, at: at + 1, steps: story.steps.length });
}
