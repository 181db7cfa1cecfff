/**
 * The equations of the magnetorheological dampers on a gear (src/element/damper/), as their papers write them.
 *
 * @typedef {import('./equations.js').Symbols} Symbols
 * @typedef {import('./equations.js').Legend} Legend
 * @typedef {import('./mathml.js').Math} Math
 */

import { mathml } from 'lit';
import { bracketed, cases, compared, dotted, equal, fraction, minus, negative, number, plus, power, product, raised, size, written } from './mathml.js';

const [x, w, z, u, force] = ['x', 'w', 'z', 'u', 'F'].map(written);

/** @type {Readonly<Record<string, (p: Symbols) => Math[]>>} */
export const dampers = {
  'bouc-wen': (p) => [
    ...lever(p),
    equal(force, plus(p('c_0'), dotted(x)), plus(p('k_0'), bracketed(mathml`${x}<mo>−</mo>${p('x_0')}`)), plus(p('α'), z)),
    hysteresis(p, dotted(x)),
  ],
  'modified-bouc-wen': (p) => [
    ...lever(p),
    ...inSeries(p, force),
    hysteresis(p, mathml`${bracketed(mathml`${dotted(x)}<mo>−</mo>${dotted(w)}`)}`),
    ...[['c_0', 'c_0a', 'c_0b'], ['c_1', 'c_1a', 'c_1b'], ['α', 'α_a', 'α_b']].map(([of, base, slope]) => equal(written(of), plus(p(base)), plus(p(slope), u))),
    equal(dotted(u), minus(p('η'), bracketed(mathml`${u}<mo>−</mo>${p('v_cmd')}`))),
  ],
  'modified-bouc-wen-cubic': (p) => [
    ...lever(p, p('s_F')),
    ...inSeries(p, force),
    hysteresis(p, mathml`${bracketed(mathml`${dotted(x)}<mo>−</mo>${dotted(w)}`)}`),
    ...[['c_0', 'c_0a', 'c_0b', 'c_0c', 'c_0d'], ['c_1', 'c_1a', 'c_1b', 'c_1c', 'c_1d'], ['α', 'α_a', 'α_b', 'α_c', 'α_d']].map(([of, ...terms]) =>
      equal(written(of), ...terms.map((term, i) => plus(p(term), ...(i > 1 ? [power(p('I'), String(i))] : i === 1 ? [p('I')] : []))))),
  ],
  'current-dependent-bouc-wen': (p) => [
    ...lever(p),
    equal(force, plus(written('c_0'), dotted(x)), plus(written('k_0'), x), plus(written('α'), z), plus(written('f_0'))),
    hysteresis(p, dotted(x)),
    ...[['c_0', 'c_00', 'c_01', 'c_02'], ['k_0', 'k_00', 'k_01', 'k_02'], ['α', 'α_0', 'α_1', 'α_2'], ['f_0', 'f_00', 'f_01', 'f_02']].map((names) => rising(p, names)),
  ],
};

/** @param {string} damper @returns {readonly Legend[]} */
export function legendOfDamper(damper) {
  const all = /** @type {Legend[]} */ ([
    { symbol: 'M_d', word: 'equation.damperMoment' }, { symbol: 'F', word: 'equation.damperForce' }, { symbol: 'x', word: 'equation.displacement' },
    { symbol: 'z', word: 'equation.hysteresis' },
  ]);
  if (damper.startsWith('modified')) all.push({ symbol: 'w', word: 'equation.internalDisplacement' });
  if (damper === 'modified-bouc-wen') all.push({ symbol: 'u', word: 'equation.effectiveCommand' });
  if (damper !== 'bouc-wen') all.push(...['c_0', 'c_1', 'α', 'k_0', 'f_0'].filter((symbol) => isVaried(damper, symbol)).map((symbol) => ({ symbol, word: /** @type {const} */ ('equation.ofCommand') })));
  return all;
}

/** Which coefficients follow the command. @param {string} damper @param {string} symbol */
function isVaried(damper, symbol) {
  return (damper.startsWith('modified') ? ['c_0', 'c_1', 'α'] : ['c_0', 'k_0', 'α', 'f_0']).includes(symbol);
}

/** How it is driven, and what it does to the wheel. @param {Symbols} p @param {Math[]} scale of its force */
function lever(p, ...scale) {
  return [equal(x, plus(p('r'), written('ψ'))), equal(written('M_d'), plus(p('r'), ...scale, force))];
}

/** A dashpot in series with spring, dashpot and hysteresis element, an accumulator beside them. @param {Symbols} p @param {Math} of */
function inSeries(p, of) {
  const drawn = mathml`${x}<mo>−</mo>${w}`;
  return [
    equal(of, plus(written('c_1'), dotted(w)), plus(p('k_1'), bracketed(mathml`${x}<mo>−</mo>${p('x_0')}`))),
    equal(product(bracketed(mathml`${written('c_0')}<mo>+</mo>${written('c_1')}`), dotted(w)),
      plus(written('α'), z), plus(written('c_0'), dotted(x)), plus(p('k_0'), bracketed(drawn))),
  ];
}

/** @param {Symbols} p @param {Math} rate of the element's ends */
function hysteresis(p, rate) {
  const fall = mathml`${p('n')}<mo>−</mo>${number('1')}`;
  return equal(dotted(z), minus(p('γ'), size(rate), z, raised(size(z), fall)), minus(p('β'), rate, raised(size(z), p('n'))), plus(p('A'), rate));
}

/** A coefficient that rises in a straight line and saturates. @param {Symbols} p @param {string[]} names */
function rising(p, [of, base, slope, saturation]) {
  const beyond = mathml`${p('I')}<mo>−</mo>${p('I_c')}`;
  const rest = mathml`${number('1')}<mo>−</mo>${raised(written('e'), negative(product(p(saturation), bracketed(beyond))))}`;
  return equal(written(of), cases(
    [mathml`${p(base)}<mo>+</mo>${product(p(slope), p('I'))}`, compared(p('I'), '≤', p('I_c'))],
    [mathml`${p(base)}<mo>+</mo>${product(p(slope), p('I_c'))}<mo>+</mo>${product(fraction(p(slope), p(saturation)), bracketed(rest))}`, compared(p('I'), '>', p('I_c'))],
  ));
}
