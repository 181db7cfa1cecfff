import { docs } from './tr/docs.js';

/** @typedef {import('./number.js').Language} Language */

/**
 * What a parameter means and which values it takes. The engine's table says it in English; other languages have it here,
 * by the parameter's name.
 * @param {{ name: string, doc: string }} parameter
 * @param {Language} language
 */
export function docOf({ name, doc }, language) {
  return language === 'tr' ? docs[name] ?? doc : doc;
}
