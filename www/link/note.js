/**
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {import('./read.js').Problem} Problem
 */

/**
 * What of a link could not be read, in words; null where all could.
 * @param {Problem[]} problems
 * @param {Voice} voice
 * @returns {import('../story/strip.js').Note | null}
 */
export function noteOn(problems, voice) {
  if (problems.length === 0) return null;
  const list = problems.map(({ key, value, reason, instead }) => {
    const problem = voice.say(`link.${reason}`, { key, value });
    return instead === undefined ? problem : voice.say('link.instead', { problem, instead });
  }).join('; ');
  return { text: voice.say('link.some', { list }), isAlert: true };
}
