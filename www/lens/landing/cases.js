/**
 * The landings of figures 7.27 – 7.42 and of table 7.4: four dampings by four currents.
 *
 * @typedef {{ dampingConstant: number, current: number, figure: string }} Case in SI; `figure`: the story that opens it
 */

export const dampings = [20, 40, 60, 70];
export const currents = [0, 0.5, 0.75, 1];
const firstFigure = 27;

/** Row by row, a damping each. @type {readonly Case[]} */
export const cases = dampings.flatMap((dampingConstant, row) => currents.map((current, column) => ({
  dampingConstant, current, figure: `figure-7.${firstFigure + row * currents.length + column}`,
})));
