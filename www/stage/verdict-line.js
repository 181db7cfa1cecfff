/**
 * @typedef {import('../engine/engine.js').Outlook} Outlook
 * @typedef {import('../words/voice.js').Voice} Voice
 */

const degrees = 180 / Math.PI;

/**
 * The line under the verdict, part by part; an extra one is left out where there is little room.
 * @param {Outlook} outlook
 * @param {Voice} voice
 * @returns {{ text: string, isExtra?: boolean }[]}
 */
export function numbersOf({ verdict, settled, amplitude, frequency, present }, voice) {
  if (verdict === 'rests') return [{ text: voice.say('verdict.rests.hint') }];
  const beat = present.frequency ?? frequency;
  const hertz = beat ? [{ text: `${voice.number(beat, 1)} Hz` }] : [];
  if (settled) return [{ text: swing(amplitude.torsionAngle, voice) }, ...hertz, { text: voice.say('verdict.settled') }];
  const now = swing(present.amplitude, voice);
  const trend = present.trend === 'growing' ? voice.say('verdict.growing', { amplitude: now })
    : present.trend === 'falling' ? voice.say('verdict.falling', { amplitude: now }) : now;
  if (verdict === 'grows') return [{ text: trend }, ...hertz, { text: voice.say('verdict.limit'), isExtra: true }];
  const goal = swing(verdict === 'dies-out' ? 0 : amplitude.torsionAngle, voice);
  return [{ text: trend }, ...hertz, { text: voice.say('verdict.heads', { amplitude: goal }), isExtra: true }];
}

/**
 * ± an angle, with as many decimals as tell small swings apart.
 * @param {number} radians
 * @param {Voice} voice
 */
function swing(radians, voice) {
  const angle = radians * degrees;
  if (angle === 0) return '0°';
  if (angle < 0.005) return `< ±${voice.number(0.01, 2)}°`;
  return `±${voice.number(angle, angle < 2 ? 2 : 1)}°`;
}
