import { download } from './download.js';
import { fileOf } from './file-of.js';

/**
 * Does what the sheet wishes for, and tells in words what came of it.
 * @param {import('./sheet.js').Wish} wish
 * @param {import('./file-of.js').Material} material
 * @param {import('../words/voice.js').Voice} voice
 * @param {import('./download.js').Place} [place]
 * @returns {Promise<string>}
 */
export async function grant({ what, view }, material, voice, place = window) {
  if (what === 'link') {
    const isCopied = await place.navigator.clipboard?.writeText(material.link).then(() => true, () => false);
    return voice.say(isCopied ? 'out.copied' : 'out.copied.not');
  }
  try {
    const { blob, name } = await fileOf(what, view, material);
    const outcome = await download(blob, name, place);
    return outcome === 'cancelled' ? '' : voice.say(`out.${outcome}`, { file: name });
  } catch (error) {
    return voice.say('out.failed', { reason: error instanceof Error ? error.message : String(error) });
  }
}
