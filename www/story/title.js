/**
 * Titles and sentences of stories in the language of the page. The engine lists the thesis' figures with English titles;
 * here they are read clause by clause and said anew.
 *
 * @typedef {import('./story.js').AtlasEntry} AtlasEntry
 * @typedef {import('../engine/engine.js').Engine} Engine
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {import('../words/voice.js').Key} Key
 * @typedef {import('./story.js').Story} Story
 */

import { decimalsOf } from '../words/number.js';
import { isWord } from '../words/voice.js';
import { factsOf } from './facts.js';

/** What a figure's title begins with. @type {Readonly<Record<string, Key>>} */
const subjects = {
  'side force over vertical force against slip angle': 'atlas.sideForce',
  'side force and aligning moment over vertical force by the Magic Formula': 'atlas.bothForces',
  'aligning moment over vertical force against slip angle': 'atlas.aligningMoment',
  'eigenvalues as caster length and velocity vary': 'atlas.eigenvalues',
  'stability in the e-v plane': 'atlas.stabilityOverCaster',
  'stability in the c-v plane': 'atlas.stabilityOverDamping',
  'torsion angle': 'atlas.torsionAngle',
  torsionAngle: 'atlas.torsionAngle',
  'lateral tire deformation': 'atlas.lateralDeformation',
  lateralDeformation: 'atlas.lateralDeformation',
  'limit cycle': 'atlas.limitCycle',
  'limit cycle amplitudes': 'atlas.cycleAmplitudes',
  'modeling of freeplay: restoring moment against torsion angle': 'atlas.freeplayLaw',
  'torsion angle in the landing roll': 'atlas.landingRoll',
  'simple Bouc-Wen model: schematic and loops': 'atlas.simpleBoucWen',
  'modified Bouc-Wen model: schematic and loops': 'atlas.modifiedBoucWen',
  'Lorenz system': 'atlas.lorenz',
  'chemical oscillator': 'atlas.chemicalOscillator',
  'van der Pol oscillator': 'atlas.vanDerPol',
};

/** What a clause after it may be. @type {Readonly<Record<string, Key>>} */
const phrases = { 'linear model': 'atlas.linear', nonlinear: 'atlas.nonlinear', 'MR damper': 'atlas.damper' };

/** @type {Readonly<Record<string, string>>} */
const symbols = { sigma: 'σ', mu: 'μ', 'psi(0)': 'ψ(0)', F_z: 'Fz' };

/**
 * What a story is called: "First look", "Figure 5.88a".
 * @param {Story} story @param {Voice} voice
 */
export function titleOf({ name, entry }, voice) {
  if (!entry) return voice.say(/** @type {Key} */ (`preset.${name}`));
  const [kind, number] = entry.id.split(' ');
  const key = `atlas.${kind}`;
  return isWord(key) ? voice.say(key, { number }) : entry.id;
}

/**
 * How a figure shows its run; empty where its title says it all.
 * @param {AtlasEntry} entry @param {Voice} voice
 */
export function lookOf({ view, show }, voice) {
  const key = `look.${view === 'time-history' ? show?.[0] : view}`;
  return isWord(key) ? voice.say(key) : '';
}

/**
 * What it tells, in one sentence.
 * @param {Story} story @param {Voice} voice
 */
export function gistOf({ name, entry }, voice) {
  return entry ? figureTitle(entry, voice) : voice.say(/** @type {Key} */ (`preset.${name}.tells`));
}

/**
 * The sentence of a step.
 * @param {Story} story @param {number} step @param {Engine} engine @param {Voice} voice
 */
export function sentenceOf(story, step, engine, voice) {
  if (story.entry) return figureTitle(story.entry, voice);
  return voice.say(/** @type {Key} */ (`preset.${story.name}.${step + 1}`), factsOf(engine, story.steps[step], voice));
}

/**
 * A title of the atlas in the language of the page; as it is where a phrase is not known.
 * @param {AtlasEntry} entry @param {Voice} voice
 */
export function figureTitle({ id, title }, voice) {
  const whole = `atlas.${id.toLowerCase().replace(' ', '-')}`;
  if (isWord(whole)) return voice.say(whole);
  const [subject, ...clauses] = title.split(', ').map((clause, i) => (i === 0 ? subjectOf(clause, voice) : clauseOf(clause, voice)));
  return subject === null || clauses.includes(null) ? title : [subject, ...clauses].join(', ');
}

/** @param {string} text @param {Voice} voice */
function subjectOf(text, voice) {
  return withFreeplay(text, voice, (what) => (Object.hasOwn(subjects, what) ? voice.say(subjects[what]) : null));
}

/** A value with its symbol and unit is never parted at the end of a line. @param {string} text @param {Voice} voice */
function clauseOf(text, voice) {
  const [, symbol, value, unit] = text.match(/^(?:(\S+) = )?(-?[\d.]+)( .+)?$/) ?? [];
  if (value) return `${symbol ? `${symbols[symbol] ?? symbol} = ` : ''}${written(value, voice)}${unit ?? ''}`.replaceAll(' ', '\u00a0');
  return withFreeplay(text, voice, (what) => (Object.hasOwn(phrases, what) ? voice.say(phrases[what]) : null));
}

/**
 * `limit cycle with freeplay 0.5 deg`
 * @param {string} text @param {Voice} voice @param {(what: string) => string | null} say
 */
function withFreeplay(text, voice, say) {
  const [, what, angle] = text.match(/^(.+) (?:with|and) freeplay ([\d.]+) deg$/) ?? [];
  const said = say(what ?? text);
  return said !== null && angle ? voice.say('atlas.withFreeplay', { what: said, angle: written(angle, voice) }) : said;
}

/** @param {string} text @param {Voice} voice */
function written(text, voice) {
  const value = Number(text);
  return voice.number(value, decimalsOf(value, 0));
}
