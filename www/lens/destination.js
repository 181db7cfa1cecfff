import { mannerOf } from '../stage/manner.js';
import { swing } from '../stage/verdict-line.js';
import { decimalsFor } from '../words/number.js';

/**
 * @typedef {import('../engine/engine.js').Outlook} Outlook
 * @typedef {import('../words/voice.js').Voice} Voice
 */

const degrees = 180 / Math.PI;

/** What the orbit is that a motion goes to. @param {Outlook} outlook @param {Voice} voice */
export function orbitLabel(outlook, voice) {
  return voice.say(outlook.present.stable === false && outlook.verdict !== 'grows' ? 'phase.heads.unstable' : `phase.heads.${mannerOf(outlook)}`);
}

/**
 * The line under the phase portrait: where the motion goes.
 * @param {Outlook} outlook
 * @param {Voice} voice
 */
export function destination(outlook, voice) {
  const { verdict, amplitude, frequency, present } = outlook;
  const manner = mannerOf(outlook);
  if (manner === 'rests') return voice.say('phase.rest');
  if (manner === 'creeps') return voice.say('phase.creeps');
  if (manner === 'stops') return voice.say('phase.stops', { angle: swing(amplitude.torsionAngle, voice).replace('±', '') });
  if (manner === 'dies-out') return voice.say('phase.none');
  if (verdict === 'grows' || !frequency) return voice.say('phase.grows');
  const cycle = present.stable === false ? 'phase.unstable' : verdict === 'rattles' ? 'phase.rattle' : 'phase.cycle';
  return voice.say(cycle, {
    degrees: `±${voice.number(amplitude.torsionAngle * degrees, 3)}°`,
    radians: voice.number(amplitude.torsionAngle, decimalsFor(amplitude.torsionAngle, 5)),
    frequency: voice.number(frequency, 2),
  });
}
