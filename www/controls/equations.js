/**
 * The equations of the models, typeset: those that the engine computes (src/model/), written as its papers write them.
 * Each is asked for with the one symbol that is to be lit in it.
 *
 * A further model is a function here and its line in `models`, below; a damper's are in damper-equations.js.
 *
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {import('./mathml.js').Math} Math
 * @typedef {(symbol: string) => Math} Symbols writes a parameter as the engine's table names it: `c_Fα`
 * @typedef {{ symbol: string, word: import('../words/voice.js').Key }} Legend
 */

import { mathml, nothing } from 'lit';
import { fittingsOf } from '../object/fittings.js';
import { lands } from '../run/landing.js';
import { dampers, legendOfDamper } from './damper-equations.js';
import { bracketed, cases, compared, dotted, equal, fraction, minus, named, negative, number, of, plus, product, sign, size, square, twiceDotted, typeset, written } from './mathml.js';

/**
 * The equations of a model; none where the page has not got them.
 * @param {string} model
 * @param {string} lit the symbol of a parameter
 * @param {Voice} voice
 */
export function equationsOf(model, lit, voice) {
  const { gear, damper } = fittingsOf(model);
  const p = symbols(lit);
  const isDamped = dampers[damper] !== undefined;
  const all = [models[gear]?.equations(p, voice, isDamped) ?? [], dampers[damper]?.(p) ?? [], lands(model) ? landing(p, voice) : []];
  return all.flat().map(typeset);
}

/** The variables that are no parameters, and what each is. @param {string} model @returns {readonly Legend[]} */
export function legendOf(model) {
  const { gear, damper } = fittingsOf(model);
  return [...models[gear]?.legend ?? [], ...(dampers[damper] ? legendOfDamper(damper) : []), ...(lands(model) ? [{ symbol: 't', word: /** @type {const} */ ('equation.time') }] : [])];
}

/**
 * What a linked value is of those that it follows.
 * @param {string} name
 * @param {string} lit
 * @param {Voice} voice
 */
export function relationOf(name, lit, voice) {
  const relation = relations[name];
  return relation ? typeset(relation(symbols(lit), voice)) : nothing;
}

/** A symbol by itself. @param {string} symbol */
export function symbolInMath(symbol) {
  return typeset(written(symbol));
}

/** @type {readonly Legend[]} */
const motion = [
  { symbol: 'ψ', word: 'equation.torsionAngle' }, { symbol: 'y', word: 'equation.lateralDeformation' }, { symbol: 'R', word: 'equation.friction' },
];
/** @type {readonly Legend[]} */
const forces = [
  { symbol: 'α', word: 'equation.slipAngle' }, { symbol: 'F_y', word: 'equation.sideForce' },
  { symbol: 'M_z', word: 'equation.aligningMoment' }, { symbol: 's', word: 'equation.springAngle' },
];

/** @type {Readonly<Record<string, { equations: (p: Symbols, voice: Voice, isDamped: boolean) => Math[], legend: readonly Legend[] }>>} */
const models = {
  torsional: { equations: torsional, legend: [...motion, ...forces] },
  'torsional-linear': { equations: torsionalLinear, legend: motion },
};

/** @type {Readonly<Record<string, (p: Symbols, voice: Voice) => Math>>} */
const relations = {
  relaxationLength: (p) => equal(p('σ'), plus(number('3'), p('a'))),
  treadWidthMomentConstant: (p, voice) => equal(p('κ'), plus(number(voice.number(0.15, 2)), square(p('a')), p('c_Fα'), p('F_z'))),
};

/** @param {Symbols} p @param {Voice} voice @param {boolean} isDamped @returns {Math[]} */
function torsional(p, voice, isDamped) {
  const [psi, y, alpha] = ['ψ', 'y', 'α'].map(written);
  const [sideForce, aligningMoment] = ['F_y', 'M_z'].map(written);
  const beyond = mathml`<mtext>${voice.say('equation.beyond')}</mtext>`;
  const within = mathml`<mtext>${voice.say('equation.within')}</mtext>`;
  return [
    equal(product(p('I_z'), twiceDotted(psi)), minus(p('k'), of(written('s'), psi)), minus(p('c'), dotted(psi)),
      minus(fraction(p('κ'), p('v')), dotted(psi)), plus(aligningMoment), minus(p('e'), sideForce), minus(written('R')), ...damperMoment(isDamped)),
    kinematics(p),
    equal(alpha, plus(of(named('arctan'), compared(y, '/', p('σ'))))),
    equal(sideForce, cases(
      [product(p('c_Fα'), p('F_z'), alpha), compared(size(alpha), '≤', p('δ'))],
      [product(p('c_Fα'), p('F_z'), p('δ'), sign(alpha)), beyond],
    )),
    equal(aligningMoment, cases(
      [negative(product(p('c_Mα'), p('F_z'), fraction(p('α_g'), written('π')), named('sin'), fraction(product(written('π'), alpha), p('α_g')))), compared(size(alpha), '≤', p('α_g'))],
      [number('0'), beyond],
    )),
    equal(of(written('s'), psi), cases(
      [mathml`${psi}<mo>−</mo>${product(p('ψ_fp'), sign(psi))}`, compared(size(psi), '>', p('ψ_fp'))],
      [number('0'), within],
    )),
    friction(p),
  ];
}

/** @param {Symbols} p @param {Voice} _ @param {boolean} isDamped @returns {Math[]} */
function torsionalLinear(p, _, isDamped) {
  const psi = written('ψ');
  const slope = mathml`${p('c_Mα')}<mo>+</mo>${product(p('e'), p('c_Fα'))}`;
  return [
    equal(product(p('I_z'), twiceDotted(psi)), minus(p('k'), psi), minus(p('c'), dotted(psi)),
      minus(fraction(p('κ'), p('v')), dotted(psi)), minus(bracketed(slope), p('F_z'), fraction(written('y'), p('σ'))), minus(written('R')), ...damperMoment(isDamped)),
    kinematics(p),
    friction(p),
  ];
}

/** How speed and weight change as it rolls out. @param {Symbols} p @param {Voice} voice @returns {Math[]} */
function landing(p, voice) {
  const slowing = mathml`${p('v_0')}<mo>−</mo>${product(p('b'), written('t'))}`;
  const carried = mathml`${number('1')}<mo>−</mo>${product(p('λ'), square(bracketed(compared(p('v'), '/', p('v_0')))))}`;
  return [
    equal(p('v'), cases([slowing, compared(slowing, '>', p('v_f'))], [p('v_f'), mathml`<mtext>${voice.say('equation.afterwards')}</mtext>`])),
    equal(of(p('F_z'), p('v')), plus(p('F_z'), bracketed(carried))),
  ];
}

/** @param {boolean} isDamped */
const damperMoment = (isDamped) => (isDamped ? [minus(written('M_d'))] : []);

/** What dry friction does: at rest whatever holds the wheel, within its limits. @param {Symbols} p */
function friction(p) {
  const rate = dotted(written('ψ'));
  return equal(written('R'), cases(
    [product(p('M_f'), sign(rate)), compared(rate, '≠', number('0'))],
    [mathml`${negative(p('M_f'))}<mo>…</mo>${p('M_f')}`, compared(rate, '=', number('0'))],
  ));
}

/** How the leading contact point moves. @param {Symbols} p */
function kinematics(p) {
  const [psi, y] = ['ψ', 'y'].map(written);
  const lever = mathml`${p('e')}<mo>−</mo>${p('a')}`;
  return equal(dotted(y), plus(p('v'), psi), plus(bracketed(lever), dotted(psi)), minus(fraction(p('v'), p('σ')), y));
}

/** @param {string} lit @returns {Symbols} */
function symbols(lit) {
  return (symbol) => (symbol === lit ? mathml`<mrow class="lit">${written(symbol)}</mrow>` : written(symbol));
}
