/**
 * The equations of the models, typeset: those that the engine computes (src/model/), written as its papers write them.
 * Each is asked for with the one symbol that is to be lit in it.
 *
 * A further model is a function here and its line in `models`, below.
 *
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {import('lit').TemplateResult<3>} Math a piece of MathML
 * @typedef {(symbol: string) => Math} Symbols writes a parameter as the engine's table names it: `c_Fα`
 * @typedef {{ symbol: string, word: import('../words/voice.js').Key }} Legend
 */

import { html, mathml, nothing } from 'lit';

/**
 * The equations of a model; none where the page has not got them.
 * @param {string} model
 * @param {string} lit the symbol of a parameter
 * @param {Voice} voice
 */
export function equationsOf(model, lit, voice) {
  return (models[model]?.equations(symbols(lit), voice) ?? []).map(typeset);
}

/** The variables that are no parameters, and what each is. @param {string} model @returns {readonly Legend[]} */
export function legendOf(model) {
  return models[model]?.legend ?? [];
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
const motion = [{ symbol: 'ψ', word: 'equation.torsionAngle' }, { symbol: 'y', word: 'equation.lateralDeformation' }];
/** @type {readonly Legend[]} */
const forces = [
  { symbol: 'α', word: 'equation.slipAngle' }, { symbol: 'F_y', word: 'equation.sideForce' },
  { symbol: 'M_z', word: 'equation.aligningMoment' }, { symbol: 's', word: 'equation.springAngle' },
];

/** @type {Readonly<Record<string, { equations: (p: Symbols, voice: Voice) => Math[], legend: readonly Legend[] }>>} */
const models = {
  torsional: { equations: torsional, legend: [...motion, ...forces] },
  'torsional-linear': { equations: torsionalLinear, legend: motion },
};

/** @type {Readonly<Record<string, (p: Symbols, voice: Voice) => Math>>} */
const relations = {
  relaxationLength: (p) => equal(p('σ'), plus(number('3'), p('a'))),
  treadWidthMomentConstant: (p, voice) => equal(p('κ'), plus(number(voice.number(0.15, 2)), square(p('a')), p('c_Fα'), p('F_z'))),
};

/** @param {Symbols} p @param {Voice} voice @returns {Math[]} */
function torsional(p, voice) {
  const [psi, y, alpha] = ['ψ', 'y', 'α'].map(written);
  const [sideForce, aligningMoment] = ['F_y', 'M_z'].map(written);
  const beyond = mathml`<mtext>${voice.say('equation.beyond')}</mtext>`;
  const within = mathml`<mtext>${voice.say('equation.within')}</mtext>`;
  return [
    equal(product(p('I_z'), twiceDotted(psi)), minus(p('k'), of(written('s'), psi)), minus(p('c'), dotted(psi)),
      minus(fraction(p('κ'), p('v')), dotted(psi)), plus(aligningMoment), minus(p('e'), sideForce)),
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
  ];
}

/** @param {Symbols} p @returns {Math[]} */
function torsionalLinear(p) {
  const psi = written('ψ');
  const slope = mathml`${p('c_Mα')}<mo>+</mo>${product(p('e'), p('c_Fα'))}`;
  return [
    equal(product(p('I_z'), twiceDotted(psi)), minus(p('k'), psi), minus(p('c'), dotted(psi)),
      minus(fraction(p('κ'), p('v')), dotted(psi)), minus(bracketed(slope), p('F_z'), fraction(written('y'), p('σ')))),
    kinematics(p),
  ];
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

/** @param {Math} math */
function typeset(math) {
  return html`<math displaystyle="true"><mrow>${math}</mrow></math>`;
}

/** @param {string} symbol `I_z` */
function written(symbol) {
  const [letter, sub] = symbol.split('_');
  return sub ? mathml`<msub><mi>${letter}</mi><mi>${sub}</mi></msub>` : mathml`<mi>${letter}</mi>`;
}

/** @param {string} name of a function */
function named(name) {
  return mathml`<mi class="upright">${name}</mi>`;
}

/** @param {string} digits */
function number(digits) {
  return mathml`<mn>${digits}</mn>`;
}

/** @param {Math} math */
function dotted(math) {
  return mathml`<mover accent="true">${math}<mo class="dots">.</mo></mover>`;
}

/** @param {Math} math */
function twiceDotted(math) {
  return mathml`<mover accent="true">${math}<mo class="dots">¨</mo></mover>`;
}

/** @param {Math} math */
function square(math) {
  return mathml`<msup>${math}<mn>2</mn></msup>`;
}

/** @param {Math} above @param {Math} below */
function fraction(above, below) {
  return mathml`<mfrac><mrow>${above}</mrow><mrow>${below}</mrow></mfrac>`;
}

/** @param {Math[]} factors */
function product(...factors) {
  return mathml`${factors.map((factor, i) => (i === 0 ? factor : mathml`<mspace width="0.18em"></mspace>${factor}`))}`;
}

/** @param {Math[]} factors */
function plus(...factors) {
  return { sign: '+', term: product(...factors) };
}

/** @param {Math[]} factors */
function minus(...factors) {
  return { sign: '−', term: product(...factors) };
}

/** @param {Math} math */
function negative(math) {
  return mathml`<mo form="prefix">−</mo>${math}`;
}

/** @param {Math} left @param {(Math | { sign: string, term: Math })[]} terms a sum */
function equal(left, ...terms) {
  return mathml`${left}<mo>=</mo>${terms.map((one, i) => {
    if (!('sign' in one)) return one;
    if (i === 0) return one.sign === '+' ? one.term : negative(one.term);
    return mathml`<mo>${one.sign}</mo>${one.term}`;
  })}`;
}

/** @param {Math} left @param {string} relation @param {Math} right */
function compared(left, relation, right) {
  return mathml`${left}<mo>${relation}</mo>${right}`;
}

/** @param {Math} math */
function bracketed(math) {
  return mathml`<mrow><mo form="prefix" stretchy="false">(</mo>${math}<mo form="postfix" stretchy="false">)</mo></mrow>`;
}

/** A function's value. @param {Math} what @param {Math} argument */
function of(what, argument) {
  return mathml`${what}<mo form="prefix" stretchy="false">(</mo>${argument}<mo form="postfix" stretchy="false">)</mo>`;
}

/** @param {Math} math */
function size(math) {
  return mathml`<mo form="prefix" stretchy="false">|</mo>${math}<mo form="postfix" stretchy="false">|</mo>`;
}

/** @param {Math} math */
function sign(math) {
  return product(named('sgn'), math);
}

/** @param {[Math, Math][]} rows a value, and where it holds */
function cases(...rows) {
  return mathml`<mtable class="cases" displaystyle="true">${rows.map(([value, where]) => mathml`
    <mtr><mtd>${value}</mtd><mtd>${where}</mtd></mtr>`)}</mtable>`;
}
