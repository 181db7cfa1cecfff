import { swing } from '../stage/verdict-line.js';
import { guesses } from './outcome.js';

/**
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {import('../store.js').State} State
 */

/**
 * What was said, and whether it came so.
 * @param {NonNullable<State['predict']>} predict
 * @param {Voice} voice
 */
export function said({ guess, outcome }, voice) {
  if (!outcome) return '';
  const truth = voice.say(`predict.becomes.${outcome.becomes}`, { amplitude: swing(outcome.amplitude, voice) });
  if (guess === null) return truth;
  const words = voice.say(`predict.said.${guess}`, { number: guesses.indexOf(guess) + 1 });
  return `${words} ${guess === outcome.truth ? voice.say('predict.right') : voice.say('predict.wrong', { truth })}`;
}
