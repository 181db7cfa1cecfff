import { docs } from './tr/docs.js';

/** @typedef {import('./number.js').Language} Language */

/**
 * What a parameter means and which values it takes. The engine's table says it in English; other languages have it here,
 * by the parameter's name, and where the same name means another thing on another damper, by both.
 * @param {{ name: string, doc: string, of?: string }} parameter `of`: the damper whose it is
 * @param {Language} language
 */
export function docOf({ name, doc, of }, language) {
  return language === 'tr' ? docs[`${of}/${name}`] ?? docs[name] ?? doc : doc;
}
