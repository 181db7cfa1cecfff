/**
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {import('./read.js').Problem} Problem
 */

/** More than these nobody reads, nor more of each. */
const mostTold = 5;
const longestTold = 40;

/** @param {string} text */
const short = (text) => (text.length > longestTold ? `${text.slice(0, longestTold)}…` : text);

/**
 * What of a link could not be read, in words; null where all could.
 * @param {Problem[]} problems
 * @param {Voice} voice
 * @returns {import('../story/strip.js').Note | null}
 */
export function noteOn(problems, voice) {
  if (problems.length === 0) return null;
  const told = problems.slice(0, mostTold).map(({ key, value, reason, instead }) => {
    const problem = voice.say(`link.${reason}`, { key: short(key), value: short(value) });
    return instead === undefined ? problem : voice.say('link.instead', { problem, instead });
  });
  const left = problems.length - told.length;
  const list = [...told, ...(left > 0 ? [voice.say('link.more', { count: left })] : [])].join('; ');
  return { text: voice.say('link.some', { list }), isAlert: true };
}
