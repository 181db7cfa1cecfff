/**
 * What the lens *Stability* shows, as the state and a link keep it: readable, in SI units.
 *
 *     view.stability=locus                                             which view
 *     view.plane=velocity:0.5:100,dampingConstant:0:100,growthRate     to the right, upward, color
 *     view.locus=velocity:0.5:100,casterLength:0:0.5:6                 what is swept, and six values of another
 *     view.mode=pair-1                                                 which mode
 *     view.histories=torsionAngle,2                                    which state, over how many seconds; without them as fits
 *     view.beside=…                                                    see beside-settings.js
 *     view.besideSort=share,down                                       by which column its table is sorted; view.casesSort likewise
 *
 * @typedef {import('../../run/linear-looks.js').Range} Range
 * @typedef {typeof colorings[number]} Coloring
 * @typedef {{ x: Range, y: Range, coloring: Coloring }} Plane
 * @typedef {{ sweep: Range, family: (Range & { count: number }) | null }} Locus
 * @typedef {{ name: string, min: number, max: number }} Parameter of the engine's table
 */

/** The views, the first is the usual one; what each is stands in views.js. */
export const viewNames = /** @type {const} */ (['plane', 'roots', 'locus', 'modes', 'routh', 'beside', 'histories']);

export const colorings = /** @type {const} */ (['growthRate', 'stable', 'frequency']);

/** More loci than this cannot be told apart. */
const mostLoci = 9;

/** Ranges of the thesis' planes, as chosen in place of its own, which are not known; for others the slider's. @type {Readonly<Record<string, readonly [number, number]>>} */
const chosenRanges = { velocity: [0.5, 100], casterLength: [0, 0.5], dampingConstant: [0, 100] };

/** The planes of the thesis: upward over to the right. */
export const readyPlanes = /** @type {const} */ ([
  { y: 'dampingConstant', x: 'velocity' },
  { y: 'casterLength', x: 'velocity' },
]);

/** Figure 5.5 of the thesis: the speed swept, for some casters. */
export const thesisLocus = 'velocity:0.5:100,casterLength:0:0.5:6';

/** @param {Parameter} parameter @returns {Range} */
export function rangeOf({ name, min, max }) {
  const [from, to] = chosenRanges[name] ?? [min, max];
  return { parameter: name, from, to };
}

/**
 * The plane that a setting names; the first of the ready ones where it names none of this gear.
 * @param {string} text
 * @param {readonly Parameter[]} parameters
 * @returns {Plane}
 */
export function planeOf(text, parameters) {
  const read = readPlane(text, parameters);
  if (read) return read;
  const [first] = readyPlanes;
  const named = (/** @type {string} */ name, /** @type {number} */ instead) => parameters.find((one) => one.name === name) ?? parameters[instead];
  return { x: rangeOf(named(first.x, 0)), y: rangeOf(named(first.y, 1)), coloring: colorings[0] };
}

/** @param {string} text @param {readonly { name: string }[]} parameters @returns {Plane | null} null for what is no plane of these */
export function readPlane(text, parameters) {
  const parts = text.split(',');
  const [x, y] = parts.slice(0, 2).map((part) => readRange(part, parameters));
  const coloring = colorings.find((one) => one === parts[2]);
  return x && y && coloring && parts.length === 3 && x.parameter !== y.parameter ? { x, y, coloring } : null;
}

/** @param {Plane} plane */
export function writePlane({ x, y, coloring }) {
  return [writeRange(x), writeRange(y), coloring].join();
}

/**
 * The locus that a setting names; that of the thesis where it names none of this gear.
 * @param {string} text
 * @param {readonly Parameter[]} parameters
 * @returns {Locus}
 */
export function locusOf(text, parameters) {
  return readLocus(text, parameters) ?? readLocus(thesisLocus, parameters) ?? { sweep: rangeOf(parameters[0]), family: null };
}

/** @param {string} text @param {readonly { name: string }[]} parameters @returns {Locus | null} null for what is no locus of these */
export function readLocus(text, parameters) {
  const [first, second, ...more] = text.split(',');
  const sweep = readRange(first, parameters);
  if (!sweep || more.length > 0) return null;
  if (second === undefined) return { sweep, family: null };
  const at = second.lastIndexOf(':');
  const range = readRange(second.slice(0, at), parameters);
  const count = Number(second.slice(at + 1));
  if (!range || !(Number.isInteger(count) && count >= 2 && count <= mostLoci) || range.parameter === sweep.parameter) return null;
  return { sweep, family: { ...range, count } };
}

/** @param {Locus} locus */
export function writeLocus({ sweep, family }) {
  return family ? `${writeRange(sweep)},${writeRange(family)}:${family.count}` : writeRange(sweep);
}

/** @param {string} text @param {readonly { name: string }[]} parameters @returns {Range | null} */
export function readRange(text, parameters) {
  const [name, from, to, ...more] = text.split(':');
  const isNumber = (/** @type {string | undefined} */ one) => one !== undefined && one !== '' && Number.isFinite(Number(one));
  if (!parameters.some((one) => one.name === name) || !isNumber(from) || !isNumber(to) || more.length > 0) return null;
  return Number(from) < Number(to) ? { parameter: name, from: Number(from), to: Number(to) } : null;
}

/** @param {Range} range */
export function writeRange({ parameter, from, to }) {
  return `${parameter}:${from}:${to}`;
}

/** Whether a mode could be called so: `pair-1`, `real-2`. @param {string} text */
export const isMode = (text) => /^(pair|real)-[1-9]$/.test(text);

/** Whether a table can be sorted so: by a column, or not. @param {string} text */
export const isSorting = (text) => text === 'none' || /^[A-Za-z]{1,40},(up|down)$/.test(text);

/** What histories can show, and for how long, in s; where no span is said it is chosen so that one sees what happens. */
export const historyStates = /** @type {const} */ (['torsionAngle', 'lateralDeformation']);
export const historySpans = [0.1, 0.2, 0.3, 0.5, 1, 2, 5];

/** The histories that a setting names; the usual ones where it names none. `duration`: null for one that fits. @param {string} text */
export function historiesOf(text) {
  const [name, span] = text.split(',');
  return { state: historyStates.find((one) => one === name) ?? historyStates[0], duration: historySpans.find((one) => String(one) === span) ?? null };
}

/** @param {{ state: string, duration: number | null }} histories */
export const writeHistories = ({ state, duration }) => (duration === null ? state : `${state},${duration}`);

/** @param {string} text */
export const isHistories = (text) => writeHistories(historiesOf(text)) === text;
