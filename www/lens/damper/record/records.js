import { kinds, units as unitTable } from './headings.js';
import { Unreadable } from './problem.js';

/**
 * A table as the records that a fit takes: in SI units, at one current each, in even time steps, no longer than a fit has use for.
 *
 * @typedef {import('./headings.js').Kind} Kind
 * @typedef {import('./table.js').Table} Table
 * @typedef {import('./problem.js').Notice} Notice
 * @typedef {{
 *   displacement: Float64Array, velocity: Float64Array | null, force: Float64Array, command: number, interval: number,
 *   from: number, to: number, measured: number,
 * }} Record_ `velocity`: null where none was measured; `from`, `to`: when it was measured, in s; `measured`: samples of which these are a part
 * @typedef {{ records: Record_[], notices: Notice[] }} Read
 */

/** A fit compares so many samples of a record at most, and a cycle with so many at least. */
export const mostSamples = 2000;
const leastPerCycle = 100;
/** Fewer samples than this tell nothing of a loop. */
export const leastSamples = 20;
/** More records than this are a current that wanders. */
export const mostRecords = 12;
/** Steps that differ by this share are even. */
const even = 0.01;
/** A step so many times as long as the usual one is a gap. */
const gap = 10;
/** A current that changes by this share of its range, or by this in A, has been set anew. */
const stepShare = 0.04;
const leastStep = 0.02;
/** A damper that moves farther, in m, or pushes harder, in N, is likelier a slip of the unit. */
const farthest = 1;
const hardest = 1e6;

/**
 * @param {Table} table
 * @param {{ units?: Partial<Record<Kind, string>>, command?: number }} [choice] units chosen by hand; `command`: the current of the whole file, in A, where no column tells it
 * @returns {Read}
 */
export function recordsOf(table, { units = {}, command = 0 } = {}) {
  /** @type {Notice[]} */ const notices = [...table.notices];
  const sizes = /** @type {Record<Kind, number>} */ ({});
  for (const kind of kinds) {
    const unit = units[kind] || table.units[kind] || Object.keys(unitTable[kind])[0];
    sizes[kind] = unitTable[kind][unit];
    if (table.columns[kind] && !units[kind] && !table.units[kind]) notices.push({ code: 'noUnit', values: { kind, unit } });
  }
  if (units.current === 'V' || (!units.current && table.units.current === 'V')) notices.push({ code: 'volts', values: {} });
  const pieces = piecesOf(table, sizes, command);
  const long = pieces.filter(({ from, to }) => to - from >= leastSamples);
  if (long.length === 0) throw shortness(table, pieces.length);
  if (long.length > mostRecords) throw new Unreadable('wanders', { count: long.length, most: mostRecords });
  if (long.length < pieces.length) notices.push({ code: 'dropped', values: { count: pieces.length - long.length, least: leastSamples } });
  const records = long.map((piece) => recordOf(table, piece, sizes, notices));
  for (const { displacement } of records) if (isConstant(displacement)) throw new Unreadable('constant', { kind: 'displacement' });
  if (records.every(({ force }) => isConstant(force))) throw new Unreadable('constant', { kind: 'force' });
  const most = (/** @type {'displacement' | 'force'} */ kind) => records.reduce((so, record) => record[kind].reduce((largest, value) => Math.max(largest, Math.abs(value)), so), 0);
  if (most('displacement') > farthest) notices.push({ code: 'far', values: { largest: most('displacement') } });
  if (most('force') > hardest) notices.push({ code: 'hard', values: { largest: most('force') } });
  return { records, notices: onceEach(notices) };
}

/** @param {Table} table @param {number} pieces */
function shortness({ rows }, pieces) {
  return pieces > 1 ? new Unreadable('uneven', { pieces, least: leastSamples }) : new Unreadable('tooFew', { rows, least: leastSamples });
}

/**
 * Rows of one current, without gap. @typedef {{ from: number, to: number, command: number }} Piece
 *
 * @param {Table} table @param {Record<Kind, number>} sizes @param {number} command
 * @returns {Piece[]}
 */
function piecesOf({ columns, rows, restarts }, sizes, command) {
  const time = /** @type {Float64Array} */ (columns.time);
  const { current } = columns;
  const tolerance = current ? Math.max(leastStep / sizes.current, stepShare * spanOf(current)) : Infinity;
  const usual = usualStep(time);
  /** @type {Piece[]} */ const pieces = [];
  const longest = gap * usual;
  let [from, sum, next] = [0, current ? current[0] : 0, 0];
  const close = (/** @type {number} */ to) => pieces.push({ from, to, command: current ? tidy((sum / (to - from)) * sizes.current) : command });
  for (let row = 1; row < rows; row++) {
    const isRestart = restarts[next] === row;
    if (isRestart) next++;
    const isSet = current !== undefined && Math.abs(current[row] - sum / (row - from)) > tolerance;
    if (isRestart || isSet || time[row] - time[row - 1] > longest) {
      close(row);
      [from, sum] = [row, 0];
    }
    if (current) sum += current[row];
  }
  close(rows);
  return pieces;
}

/** The middle one of steps from all over the file. @param {Float64Array} time */
function usualStep(time) {
  const stride = Math.max(1, Math.floor(time.length / 2000));
  const steps = [];
  for (let row = 1; row < time.length; row += stride) if (time[row] > time[row - 1]) steps.push(time[row] - time[row - 1]);
  return steps.sort((one, other) => one - other)[steps.length >> 1] ?? Infinity;
}

/**
 * @param {Table} table @param {Piece} piece @param {Record<Kind, number>} sizes @param {Notice[]} notices
 * @returns {Record_}
 */
function recordOf({ columns }, { from, to, command }, sizes, notices) {
  const cut = (/** @type {Kind} */ kind) => /** @type {Float64Array} */ (columns[kind]).subarray(from, to);
  const time = cut('time');
  const count = to - from;
  const mean = (time[count - 1] - time[0]) / (count - 1);
  const isEven = hasEvenSteps(time, mean);
  if (!isEven) notices.push({ code: 'resampled', values: { interval: mean * sizes.time } });
  const { start, stride, kept } = partOf(cut('displacement'));
  const places = isEven ? null : placesIn(time, mean);
  const taken = (/** @type {Kind} */ kind) => {
    const values = cut(kind);
    return Float64Array.from({ length: kept }, (_, i) => sizes[kind] * valueAt(values, places, start + i * stride));
  };
  const seconds = (/** @type {number} */ sample) => (time[0] + sample * mean) * sizes.time;
  return {
    displacement: taken('displacement'), velocity: columns.velocity ? taken('velocity') : null, force: taken('force'), command, interval: mean * stride * sizes.time,
    from: seconds(start), to: seconds(start + (kept - 1) * stride), measured: count,
  };
}

/**
 * Which samples are compared: every one, or every so many with enough of them in a cycle; and of what is longer still the end,
 * which has forgotten how it began.
 * @param {Float64Array} displacement
 */
function partOf(displacement) {
  const count = displacement.length;
  if (count <= mostSamples) return { start: 0, stride: 1, kept: count };
  const perCycle = (2 * count) / Math.max(2, crossingsOf(displacement));
  const stride = Math.max(1, Math.min(Math.floor(perCycle / leastPerCycle), Math.ceil(count / mostSamples)));
  const kept = Math.min(mostSamples, Math.floor((count - 1) / stride) + 1);
  return { start: count - 1 - (kept - 1) * stride, stride, kept };
}

/** How often it passes its middle, noise at the middle set aside. @param {Float64Array} values */
function crossingsOf(values) {
  const [low, high] = endsOf(values);
  const [middle, band] = [(low + high) / 2, 0.1 * (high - low)];
  const [above, below] = [middle + band, middle - band];
  let [side, crossings] = [0, 0];
  for (let i = 0; i < values.length; i++) {
    const value = values[i];
    const now = value > above ? 1 : value < below ? -1 : side;
    if (side !== 0 && now !== side) crossings++;
    side = now;
  }
  return crossings;
}

/** @param {Float64Array} time @param {number} interval */
function hasEvenSteps(time, interval) {
  const most = even * interval;
  for (let i = 1; i < time.length; i++) if (Math.abs(time[i] - time[i - 1] - interval) > most) return false;
  return true;
}

/** Where in uneven steps each even one lies: the sample before it, and how far on. @param {Float64Array} time @param {number} interval */
function placesIn(time, interval) {
  const places = new Float64Array(time.length);
  let before = 0;
  for (let i = 0; i < time.length; i++) {
    const at = Math.min(time[0] + i * interval, time[time.length - 1]);
    while (before < time.length - 2 && time[before + 1] < at) before++;
    places[i] = before + (at - time[before]) / (time[before + 1] - time[before]);
  }
  return places;
}

/** @param {Float64Array} values @param {Float64Array | null} places @param {number} i */
function valueAt(values, places, i) {
  if (!places) return values[i];
  const before = Math.min(values.length - 2, Math.floor(places[i]));
  const on = places[i] - before;
  return values[before] * (1 - on) + values[before + 1] * on;
}

/** A measured current without the dust of its mean. @param {number} value */
const tidy = (value) => Number(value.toFixed(3)) || 0;

/** @param {Float64Array} values @returns {[number, number]} */
function endsOf(values) {
  let [low, high] = [Infinity, -Infinity];
  // An index is read faster than by an iterator, and there are millions.
  for (let i = 0; i < values.length; i++) {
    const value = values[i];
    if (value < low) low = value;
    if (value > high) high = value;
  }
  return [low, high];
}

/** @param {Float64Array} values */
function spanOf(values) {
  const [low, high] = endsOf(values);
  return high - low;
}

/** @param {Float64Array} values */
function isConstant(values) {
  const [low, high] = endsOf(values);
  return high - low <= 1e-9 * Math.max(Math.abs(low), Math.abs(high));
}

/** @param {Notice[]} notices */
function onceEach(notices) {
  const seen = new Set();
  return notices.filter((notice) => {
    const key = JSON.stringify([notice.code, notice.values.kind]);
    return seen.has(key) ? false : seen.add(key);
  });
}
