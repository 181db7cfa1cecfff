// The linear gear in closed form, written down from the textbook's cubic and not from the engine: for tests that want a
// stability map, its boundary or roots without it.

/** The gear's usual values, as the source's table has them. */
export const usual = {
  velocity: 50, casterLength: 0.1, halfContactLength: 0.1, relaxationLength: 0.3, momentOfInertia: 1, torsionalStiffness: 100_000,
  dampingConstant: 10, verticalForce: 9000, sideForceDerivative: 20, aligningMomentDerivative: 2, treadWidthMomentConstant: 270,
};

/** s³ + a₂s² + a₁s + a₀: its coefficients a₂, a₁, a₀. @param {Partial<typeof usual>} values */
export function cubicOf(values) {
  const { velocity: v, casterLength: e, halfContactLength: a, relaxationLength: sigma, momentOfInertia: inertia, torsionalStiffness: k,
    dampingConstant: c, verticalForce: load, sideForceDerivative: slope, aligningMomentDerivative: moment, treadWidthMomentConstant: kappa } = { ...usual, ...values };
  const b = (-(moment + e * slope) * load) / (sigma * inertia);
  const damping = (c + kappa / v) / inertia;
  return [v / sigma + damping, k / inertia + (damping * v) / sigma - (e - a) * b, (v * k) / (sigma * inertia) - v * b];
}

/** Its roots by falling real part, of a pair the positive imaginary part first. @param {Partial<typeof usual>} values */
export function rootsOf(values) {
  const [a2, a1, a0] = cubicOf(values);
  const at = (/** @type {number} */ s) => ((s + a2) * s + a1) * s + a0;
  let [low, high] = [-1, 1];
  while (at(low) > 0) low *= 2;
  while (at(high) < 0) high *= 2;
  for (let i = 0; i < 200; i++) {
    const middle = (low + high) / 2;
    if (at(middle) > 0) high = middle;
    else low = middle;
  }
  const real = (low + high) / 2;
  const half = (a2 + real) / 2;
  const under = half ** 2 - (a1 + real * (a2 + real));
  const root = Math.sqrt(Math.abs(under));
  const rest = under < 0 ? [{ re: -half, im: root }, { re: -half, im: -root }] : [{ re: -half + root, im: 0 }, { re: -half - root, im: 0 }];
  return [{ re: real, im: 0 }, ...rest].sort((one, other) => other.re - one.re || other.im - one.im);
}

/** Growth rates at the middles of cells, row by row from the lowest. @param {{ x: Side, y: Side, columns: number, rows: number }} plane @param {Partial<typeof usual>} [values] */
export function growthRates({ x, y, columns, rows }, values = {}) {
  return Float64Array.from({ length: columns * rows }, (_, cell) => {
    const at = (/** @type {Side} */ { from, to }, /** @type {number} */ i, /** @type {number} */ count) => from + ((i + 0.5) / count) * (to - from);
    return rootsOf({ ...values, [x.parameter]: at(x, cell % columns, columns), [y.parameter]: at(y, Math.floor(cell / columns), rows) })[0].re;
  });
}

/** @typedef {{ parameter: string, from: number, to: number }} Side */

/** The plane c over v of the thesis, as chosen. */
export const dampingOverVelocity = {
  x: { parameter: 'velocity', from: 0.5, to: 100 }, y: { parameter: 'dampingConstant', from: 0, to: 100 },
};

/** Published critical speeds below 100 m/s, by damping (theory: c = 0 … 40). */
export const criticalSpeeds = /** @type {const} */ ([[0, 15.2593], [10, 20.511], [20, 27.6], [30, 37.263], [40, 51.881]]);
