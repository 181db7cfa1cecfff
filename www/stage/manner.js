/**
 * What a motion does, in the word of the verdict. The engine's outlook says where it goes; a wheel that comes to rest may
 * lie there already, or still be on its way, and then it may swing or creep.
 *
 * @typedef {import('../engine/engine.js').Outlook} Outlook
 * @typedef {Outlook['verdict'] | 'creeps' | 'stops'} Manner `creeps`: to rest without a beat; `stops`: it swings on to a rest
 *   away from straight ahead
 */

/** Angles nearer to each other than this look the same in every number shown, in rad. */
const alike = (0.005 * Math.PI) / 180;

/** @param {Pick<Outlook, 'verdict' | 'settled' | 'amplitude' | 'frequency' | 'present'>} outlook @returns {Manner} */
export function mannerOf({ verdict, settled, amplitude, frequency, present }) {
  const beats = Boolean(present.frequency ?? frequency);
  if (verdict === 'dies-out') return beats ? verdict : 'creeps';
  if (verdict !== 'rests' || settled) return verdict;
  if (Math.abs(present.amplitude - amplitude.torsionAngle) < alike) return 'rests';
  return beats ? 'stops' : 'creeps';
}
