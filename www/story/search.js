/**
 * What is found for what is typed: by words, by a figure's number, by values (`v 50 c 100`, `freeplay 1 deg`), in both
 * languages whatever the page speaks.
 *
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {import('./story.js').Story} Story
 * @typedef {{ story: Story, words: string[], number: string, settings: Record<string, number>[] }} Indexed
 *   `number`: of a figure or table, '' for others; `settings`: the values of each step, angles in degrees
 */

import { tableNumbers } from '../lens/cycles/thesis-tables.js';
import { isWord } from '../words/voice.js';
import { gistOf, lookOf, titleOf } from './title.js';

const degrees = 180 / Math.PI;

/** What a number behind a word or symbol is. */
const names = new Map(Object.entries({
  velocity: ['v', 'velocity', 'speed', 'hiz'],
  dampingConstant: ['c', 'damping', 'sonum'],
  casterLength: ['e', 'caster', 'kaster'],
  torsionalStiffness: ['k', 'stiffness', 'rijitlik'],
  freeplayAngle: ['freeplay', 'gap', 'bosluk'],
  torsionAngle: ['psi', 'ψ', 'psi(0)', 'ψ(0)'],
}).flatMap(([name, words]) => words.map((word) => /** @type {[string, string]} */ ([word, name]))));

/** Units say nothing of their own. */
const units = /(?<=\d\s*)(m\/s|n m s\/rad|n m\/rad|deg(rees)?\b|derece\b|°|rad\b)/g;
const token = /[abc]\.\d+|\d+(?:\.\d+)?[a-d]?|[\p{L}(][\p{L}\d()]*/gu;

/** @param {readonly Story[]} stories @param {readonly Voice[]} voices @returns {Indexed[]} */
export function indexOf(stories, voices) {
  return stories.map((story) => {
    const { entry, steps } = story;
    const text = voices.flatMap((voice) => [titleOf(story, voice), gistOf(story, voice), entry ? lookOf(entry, voice) : '']).join(' ');
    const words = [...tokensOf(text), ...voices.flatMap((voice) => tokensOf(entry ? methodsOf(entry, voice) : themesOf(story.name, voice)))];
    // The name of the thing is written as it is heard, and called by other names.
    const others = words.includes('shimmy') ? voices.flatMap((voice) => tokensOf(voice.say('search.shimmy'))) : [];
    return { story, words: [...words, ...others], number: entry?.id.split(' ')[1].toLowerCase() ?? '', settings: steps.map(valuesOf) };
  });
}

/** What people look for who look for a preset, where its own words do not say it. @param {string} name @param {Voice} voice */
function themesOf(name, voice) {
  const key = `search.${name}`;
  return isWord(key) ? voice.say(key) : '';
}

/** By what a figure is made, which people look for and its title does not say. @param {import('./story.js').AtlasEntry} entry @param {Voice} voice */
function methodsOf({ id, view, run }, voice) {
  const isPlanes = view === 'table' && /^Table 5\.[2-6]$/.test(id);
  const isCycles = view === 'table' && tableNumbers.includes(id.split(' ')[1]);
  const isCase = id === 'Table 5.7' || (view === 'time-history' && run?.model === 'torsional-linear');
  const key = `search.${isPlanes ? 'stability-map' : isCase ? 'cases' : isCycles ? 'cycle-table' : view}`;
  return isWord(key) ? voice.say(key) : '';
}

/**
 * Those that answer what was typed, in their order; all for nothing typed. A value is taken exactly where it occurs, else
 * by its beginning, as it is while one types.
 * @param {readonly Indexed[]} index
 * @param {string} query
 */
export function search(index, query) {
  const tokens = tokensOf(query);
  const exactly = index.filter((one) => answers(one, tokens, (value, text) => value === Number(text)));
  return exactly.length > 0 ? exactly : index.filter((one) => answers(one, tokens, (value, text) => String(value).startsWith(text)));
}

/** @param {Indexed} indexed @param {readonly string[]} tokens @param {(value: number, text: string) => boolean} isValue */
function answers({ words, number, settings }, tokens, isValue) {
  return tokens.every((text, i) => {
    const isNumber = /^\d/.test(text);
    const named = isNumber ? names.get(tokens[i - 1]) : undefined;
    if (named) return settings.some((values) => named in values && isValue(values[named], text));
    if (isNumber) return number.startsWith(text) || settings.some((values) => Object.values(values).some((value) => isValue(value, text)));
    if (names.has(text) && /^\d/.test(tokens[i + 1] ?? '')) return true;
    return number === text || words.some((word) => word.startsWith(text));
  });
}

/** Values of a step as people write them. @param {Story['steps'][number]} step @returns {Record<string, number>} */
function valuesOf({ state: { parameters, initial } }) {
  const { freeplayAngle, ...others } = parameters;
  return { ...others, ...initial, freeplayAngle: Number(((freeplayAngle ?? 0) * degrees).toPrecision(12)) };
}

/** @param {string} text @returns {string[]} */
const tokensOf = (text) => plain(text).match(token) ?? [];

/** Small letters without marks, decimal points for commas, no units. @param {string} text */
function plain(text) {
  const bare = text.toLowerCase().normalize('NFD').replaceAll(/\p{M}/gu, '').replaceAll('ı', 'i').replaceAll(/\s/g, ' ');
  return bare.replaceAll(/(?<=\d),(?=\d)/g, '.').replaceAll(units, ' ');
}
