import { linkOfRun } from './link-of-run.js';

/**
 * The address of a saved run, or in words why there is none.
 * @param {{ name: string, text: string }} file
 * @param {import('../words/voice.js').Voice} voice
 * @returns {{ link: string, said: string }} one of the two is empty
 */
export function linkOfFile({ name, text }, voice) {
  try {
    return { link: linkOfRun(text), said: '' };
  } catch {
    return { link: '', said: voice.say('out.notARun', { file: name }) };
  }
}
