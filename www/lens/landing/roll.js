/**
 * A landing roll as it is looked at: how far it has rolled, how wide it swung in each stretch of it, when it shimmied.
 *
 * @typedef {{ time: ArrayLike<number>, velocity: ArrayLike<number>, torsionAngle: ArrayLike<number>, torsionRate: ArrayLike<number> }} Roll as the engine gives it: from
 *   touchdown on, ascending, no peak left out
 * @typedef {{ time: Float64Array, low: Float64Array, high: Float64Array, velocity: Float64Array, distance: Float64Array }} Stretches
 *   equal ones of time: the least and the largest ψ in each; its middle, the speed and the distance there
 * @typedef {{ time: number, velocity: number, distance: number }} Moment
 * @typedef {Moment & { angle: number }} Widest
 * @typedef {{ begins: Moment | null, ends: Moment | null, widest: Widest, touchdown: Moment, stop: Moment }} Shimmy `begins`: null where it
 *   does not shimmy; `ends`: null where it does not, or still does at the roll's end
 */

const degree = Math.PI / 180;
/** A swing beyond this is called shimmy; the gap comes to it, in which a wheel turns freely. Chosen: more than the touch that starts it. */
const least = degree;
/** Who swings so wide so shortly before the end still does, in s. */
const lastCycles = 0.06;

/** How wide a swing is called shimmy, in rad. @param {Readonly<Record<string, number>>} parameters */
export const thresholdOf = ({ freeplayAngle = 0 }) => least + freeplayAngle;

/** How far it has rolled, in m: between two times the speed falls evenly. @param {Roll} roll */
export function distancesOf({ time, velocity }) {
  const distance = new Float64Array(time.length);
  for (let i = 1; i < time.length; i++) distance[i] = distance[i - 1] + 0.5 * (velocity[i] + velocity[i - 1]) * (time[i] - time[i - 1]);
  return distance;
}

/** @param {Roll} roll @param {number} count @returns {Stretches} */
export function stretchesOf(roll, count) {
  const { time, torsionAngle: psi } = roll;
  const at = momentsOf(roll);
  const [from, to] = [time[0], time[time.length - 1]];
  const [low, high] = [new Float64Array(count).fill(Infinity), new Float64Array(count).fill(-Infinity)];
  for (let i = 0; i < time.length; i++) {
    const place = Math.min(count - 1, Math.floor(((time[i] - from) / (to - from)) * count));
    low[place] = Math.min(low[place], psi[i]);
    high[place] = Math.max(high[place], psi[i]);
  }
  // Where samples are sparser than stretches, one of them holds on.
  for (let i = 1; i < count; i++) if (low[i] > high[i]) [low[i], high[i]] = [low[i - 1], high[i - 1]];
  const middles = Float64Array.from({ length: count }, (_, i) => from + ((i + 0.5) * (to - from)) / count);
  const moments = Array.from(middles, at);
  return { time: middles, low, high, velocity: Float64Array.from(moments, ({ velocity }) => velocity), distance: Float64Array.from(moments, ({ distance }) => distance) };
}

/** Speed and distance at any time of the roll. @param {Roll} roll @returns {(time: number) => Moment} */
export function momentsOf(roll) {
  const { time, velocity } = roll;
  const distance = distancesOf(roll);
  const last = time.length - 1;
  return (wanted) => {
    const at = Math.min(Math.max(wanted, time[0]), time[last]);
    const before = rowAt(time, at);
    const after = Math.min(before + 1, last);
    const span = time[after] - time[before];
    const share = span > 0 ? (at - time[before]) / span : 0;
    const speed = velocity[before] + share * (velocity[after] - velocity[before]);
    return { time: at, velocity: speed, distance: distance[before] + 0.5 * (velocity[before] + speed) * (at - time[before]) };
  };
}

/** When it shimmies. @param {Roll} roll @param {number} threshold in rad @returns {Shimmy} */
export function shimmyOf(roll, threshold) {
  const { time, torsionAngle: psi } = roll;
  const at = momentsOf(roll);
  let [first, final, widest] = [-1, -1, 0];
  for (let i = 0; i < psi.length; i++) {
    if (Math.abs(psi[i]) > Math.abs(psi[widest])) widest = i;
    if (Math.abs(psi[i]) < threshold) continue;
    if (first < 0) first = i;
    final = i;
  }
  const end = time[time.length - 1];
  return {
    begins: first < 0 ? null : at(time[first]),
    ends: final < 0 || time[final] > end - lastCycles ? null : at(time[final]),
    widest: { ...at(time[widest]), angle: Math.abs(psi[widest]) }, touchdown: at(time[0]), stop: at(end),
  };
}

/**
 * The motion between two times of the roll, finely: between its rows the curve that has their angles and rates.
 * @param {Roll} roll @param {number} from @param {number} to in s @param {number} count
 */
export function windowOf({ time, torsionAngle, torsionRate }, from, to, count) {
  const last = time.length - 1;
  const times = Float64Array.from({ length: count }, (_, i) => Math.min(Math.max(from + (i * (to - from)) / (count - 1), time[0]), time[last]));
  let before = rowAt(time, times[0]);
  const angles = times.map((at) => {
    while (before < last - 1 && time[before + 1] <= at) before++;
    const span = time[before + 1] - time[before];
    const share = span > 0 ? (at - time[before]) / span : 0;
    const [a, b] = [torsionAngle[before], torsionAngle[before + 1]];
    const [c, d] = [torsionRate[before] * span, torsionRate[before + 1] * span];
    return a + share * (c + share * (3 * (b - a) - 2 * c - d + share * (2 * (a - b) + c + d)));
  });
  return { time: times, torsionAngle: angles };
}

/** The last row that is not after a time, but for the very last. @param {ArrayLike<number>} time @param {number} at */
function rowAt(time, at) {
  let [before, after] = [0, time.length - 1];
  while (after - before > 1) {
    const middle = (before + after) >> 1;
    if (time[middle] <= at) before = middle;
    else after = middle;
  }
  return before;
}

/** How wide a stretch swings, in rad. @param {Stretches} stretches */
export const amplitudesOf = ({ low, high }) => low.map((one, i) => Math.max(Math.abs(one), Math.abs(high[i])));
