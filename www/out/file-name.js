/**
 * A file's name that says what is in it: `shimmy-v80-c20-phase.png`. Speed and damping, then what differs from the
 * usual gear, at most five values in all; angles in degrees.
 *
 * @typedef {{ name: string, symbol: string, unit: string, default: number }} Parameter
 *
 * @param {{ parameters: Parameter[] }} table
 * @param {Record<string, number>} parameters
 * @param {string} what the view, or nothing
 * @param {string} extension
 */
export function fileName(table, parameters, what, extension) {
  const isAlways = (/** @type {string} */ name) => name === 'velocity' || name === 'dampingConstant';
  const told = table.parameters.filter(({ name, default: usual }) => isAlways(name) || (parameters[name] ?? usual) !== usual);
  const sorted = [...told.filter(({ name }) => isAlways(name)), ...told.filter(({ name }) => !isAlways(name))].slice(0, 5);
  const values = sorted.map(({ name, symbol, unit, default: usual }) => plain(symbol) + numeral(parameters[name] ?? usual, unit));
  return `${['shimmy', ...values, what].filter(Boolean).join('-')}.${extension}`;
}

/** @type {Record<string, string>} */
const latin = { α: 'alpha', β: 'beta', γ: 'gamma', δ: 'delta', η: 'eta', κ: 'kappa', λ: 'lambda', μ: 'mu', ρ: 'rho', σ: 'sigma', φ: 'phi', ψ: 'psi' };

/** A symbol in letters that every system takes in a name. @param {string} symbol */
function plain(symbol) {
  return symbol.replaceAll(/[α-ω]/g, (letter) => latin[letter] ?? '').replaceAll(/[^A-Za-z0-9]/g, '');
}

/** Four digits tell enough. @param {number} value @param {string} unit */
function numeral(value, unit) {
  const shown = unit === 'rad' ? (value * 180) / Math.PI : value;
  return `${Number(shown.toPrecision(4))}${unit === 'rad' ? 'deg' : ''}`.replace('+', '');
}
