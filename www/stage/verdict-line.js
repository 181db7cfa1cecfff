import { trusted } from '../run/trusted.js';
import { mannerOf } from './manner.js';

/**
 * @typedef {import('../engine/engine.js').Outlook} Outlook
 * @typedef {import('../words/voice.js').Voice} Voice
 */

const degrees = 180 / Math.PI;
/** Less is straight ahead in every number shown, in rad. */
const least = 0.005 / degrees;

/**
 * The line under the verdict, part by part; an extra one is left out where there is little room.
 * @param {Outlook} outlook
 * @param {Voice} voice
 * @returns {{ text: string, isExtra?: boolean }[]}
 */
export function numbersOf(outlook, voice) {
  const { verdict, settled, held, amplitude, frequency, present } = outlook;
  const manner = mannerOf(outlook);
  const aside = (/** @type {number} */ angle) => ({ angle: swing(angle, voice).replace('±', '') });
  const isAside = amplitude.torsionAngle > least;
  const stopped = aside(amplitude.torsionAngle);
  if (held && manner === 'rests') return [{ text: voice.say('verdict.sticks.aside', stopped) }];
  if (held && (manner === 'stops' || manner === 'creeps')) return [{ text: voice.say('verdict.sticks.at', stopped) }];
  if (manner === 'rests') return [{ text: isAside && !settled ? voice.say('verdict.rests.aside', aside(amplitude.torsionAngle)) : voice.say('verdict.rests.hint') }];
  if (manner === 'stops' || (manner === 'creeps' && isAside)) return [{ text: voice.say('verdict.rests.at', aside(amplitude.torsionAngle)) }];
  if (manner === 'creeps') return [{ text: voice.say('verdict.creeping', aside(present.amplitude)) }];
  const beat = present.frequency ?? frequency;
  const hertz = beat ? [{ text: `${voice.number(beat, 1)} Hz` }] : [];
  const now = swing(present.amplitude, voice);
  const goal = swing(verdict === 'dies-out' ? 0 : amplitude.torsionAngle, voice);
  const limit = { text: voice.say('verdict.limit') };
  if (present.stable === false && verdict !== 'grows') {
    return [{ text: now }, ...hertz, { text: voice.say('verdict.unstable') }, { text: voice.say('verdict.unstable.hint'), isExtra: true }];
  }
  if (hasSettled(outlook, voice))
    return [{ text: goal }, ...hertz, amplitude.torsionAngle > trusted ? limit : { text: voice.say('verdict.settled') }];
  const trend = present.trend === 'growing' ? voice.say('verdict.growing', { amplitude: now })
    : present.trend === 'falling' ? voice.say('verdict.falling', { amplitude: now }) : now;
  if (verdict === 'grows') return [{ text: trend }, ...hertz, { ...limit, isExtra: true }];
  if (present.amplitude > trusted) return [{ text: trend }, ...hertz, limit];
  return [{ text: trend }, ...hertz, { text: voice.say('verdict.heads', { amplitude: goal }), isExtra: true }];
}

/** The verdict's word: a wheel that friction holds does not just rest. @param {Outlook} outlook @returns {import('../words/voice.js').Key} */
export function wordOf(outlook) {
  const manner = mannerOf(outlook);
  return outlook.held && manner === 'rests' ? 'verdict.sticks' : `verdict.${manner}`;
}

/**
 * Whether the swing has come to where it goes: what no longer changes in any number shown has settled, for all that can be
 * seen; but a swing on an unstable cycle has not.
 * @param {Outlook} outlook
 * @param {Voice} voice
 */
export function hasSettled({ verdict, settled, amplitude, present }, voice) {
  return verdict !== 'grows' && present.stable !== false && (settled || swing(present.amplitude, voice) === swing(verdict === 'dies-out' ? 0 : amplitude.torsionAngle, voice));
}

/**
 * The line while a hand holds the wheel: how far it is turned, and what letting go does.
 * @param {number} angle in rad
 * @param {Voice} voice
 */
export function heldLine(angle, voice) {
  const hint = voice.say(Math.abs(angle) > trusted ? 'verdict.limit' : 'verdict.held.hint');
  return `${voice.number(angle * degrees, 1)}° · ${hint}`;
}

/**
 * ± an angle, with as many decimals as tell small swings apart.
 * @param {number} radians
 * @param {Voice} voice
 */
export function swing(radians, voice) {
  const angle = radians * degrees;
  if (angle === 0) return '0°';
  if (angle < 0.005) return `< ±${voice.number(0.01, 2)}°`;
  return `±${voice.number(angle, angle < 2 ? 2 : 1)}°`;
}
