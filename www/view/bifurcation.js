import { trusted } from '../run/trusted.js';
import { axisUp, drawAxes, frameOf } from './axes.js';
import { curveOf, strokeCurve } from './curve.js';
import { drawGuideAcross } from './guide.js';
import { keysAbove } from './key.js';
import { parameterAxis } from './parameter-axis.js';
import { drawPresent, drawRing } from './points.js';
import { quantities } from './quantities.js';
import { drawSpecialPoints } from './special-points.js';
import { destination, inStyle, stableCycle, unstableCycle } from './strokes.js';
import { writeEdged, textFont } from './text.js';
import { drawVeil } from './veil.js';

/**
 * Branches of cycles over a value of the gear: amplitudes of the stable ones solid, of the unstable ones dashed, rest along the
 * foot likewise, points at which something changes marked and named, and the gear as it is riding on it.
 *
 * @typedef {import('../controls/quantity.js').Quantity} Quantity
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {import('./axes.js').Box} Box
 * @typedef {{ across: ArrayLike<number>, up: ArrayLike<number>, stable: ArrayLike<number>, turns: readonly number[], isBeyond?: (i: number) => boolean }} Line
 *   point by point; `stable`: 1 or 0; `turns`: at which of its points that changes, or may; `isBeyond`: which of them the model is not trusted for
 * @typedef {{
 *   quantity: Quantity, from: number, to: number, height: keyof typeof heightQuantities, limit: number,
 *   rest: Line | null, branches: readonly Line[], points: readonly { kind: import('./special-points.js').Kind, across: number, up: number, texts: readonly string[] }[],
 *   law: { slope: number, text: string } | null, sweep: readonly { value: number, way: 'up' | 'down', up: number, isSettled: boolean }[],
 *   now: { value: number, motion: number | null, cycle: { up: number, stable: boolean } | null }, cursor: { across: number, up: number } | null,
 *   isOld: boolean, message: string, veiled: boolean, path?: { across: ArrayLike<number>, up: ArrayLike<number>, text: string, isOld: boolean },
 * }} Shown `law`: a line through the origin; `now`: the gear's own value, the swing it makes and its cycle; `cursor`: the place
 *   that keys have walked to; `path`: a run whose value changes as it goes; `message`: what is said where there is no branch
 * @typedef {{ frame: Box, x: (value: number) => number, y: (value: number) => number }} Places
 */

/** What can stand upward. */
const heightQuantities = {
  torsionAngle: quantities.torsionAngle, torsionRate: quantities.torsionRate, lateralDeformation: quantities.lateralDeformation, frequency: quantities.frequency,
};

/** In px. */
const letter = 6;
/** Beyond what the model is trusted for lines are so much fainter. */
const faint = 0.4;

/** @type {import('./strokes.js').Style} */
const beyond = (context, theme) => {
  context.strokeStyle = theme.rule;
  context.lineWidth = 2.6 * theme.line;
};

/** @type {import('./strokes.js').Style} */
const lawStyle = (context, theme) => {
  context.strokeStyle = theme.freeplayText;
  context.lineWidth = 1.6 * theme.line;
  context.setLineDash([2 * theme.line, 4 * theme.line]);
};

/** @type {import('./strokes.js').Style} */
const pathStyle = (context, theme) => {
  context.strokeStyle = theme.psi;
  context.lineWidth = 2.2 * theme.line;
  context.setLineDash([]);
};

/**
 * @param {CanvasRenderingContext2D} context
 * @param {import('./canvas.js').Size} size
 * @param {Shown} shown
 * @param {Theme} theme
 * @param {Voice} voice
 * @returns {Places | null} where values stand; null where there is no room
 */
export function drawBifurcation(context, size, shown, theme, voice) {
  const { quantity, from, to, height, limit, rest, branches, law, now, cursor, isOld, veiled } = shown;
  const color = theme.ink;
  const hasBeyond = !veiled && height !== 'torsionAngle' && branches.some(({ across, isBeyond }) => isBeyond && Array.from(across).some((_, i) => isBeyond(i)));
  const hasUnstable = !veiled && branches.some(({ stable }) => Array.from(stable).some((one) => one === 0));
  const { frame, draw: drawKeys } = keysAbove(context, frameOf(size, theme), [
    { entry: veiled ? 'veiled' : { text: voice.say('branch.key.stable'), short: voice.say('branch.key.stable.short'), style: stableCycle }, color },
    ...(hasUnstable ? [{ entry: { text: voice.say('branch.key.unstable'), short: voice.say('branch.key.unstable.short'), style: unstableCycle }, color }] : []),
    ...(hasBeyond ? [{ entry: { text: voice.say('branch.beyond'), short: voice.say('branch.beyond.short'), style: beyond }, color: theme.ink2 }] : []),
    ...(law && !veiled ? [{ entry: { text: law.text, style: lawStyle }, color: theme.freeplayText }] : []),
    ...(shown.path && !veiled ? [{ entry: { text: shown.path.text, style: pathStyle }, color: theme.psi }] : []),
    ...(shown.sweep.length > 0 && !veiled ? [
      { entry: { text: `▸ ${voice.say('branch.sweep.up')}`, style: null }, color: theme.force }, { entry: { text: `◂ ${voice.say('branch.sweep.down')}`, style: null }, color: theme.y },
      ...(shown.sweep.every(({ isSettled }) => isSettled) ? [] : [{ entry: { text: `▹ ${voice.say('branch.sweep.unsettled')}`, style: null }, color: theme.ink2 }]),
    ] : []),
  ], theme);
  const [width, tall] = [frame.right - frame.left, frame.bottom - frame.top];
  if (width < 40 || tall < 40) return null;
  const x = parameterAxis(quantity, [from, to], [frame.left, frame.right], Math.min(10, width / (theme.size * 4.2)), voice);
  const y = axisUp(heightQuantities[height], [0, limit], frame, theme, voice);
  const trust = height === 'torsionAngle' && !veiled ? y.at(trusted) : frame.top;
  if (trust > frame.top) shadeBeyond(context, { ...frame, bottom: trust }, theme);
  drawAxes(context, frame, x, y, theme);
  const isInRange = now.value >= from && now.value <= to;
  const places = { frame, x: x.at, y: y.at };
  if (veiled) {
    drawVeil(context, frame, theme);
    if (isInRange) drawGuideAcross(context, frame, x.at(now.value), theme);
    return places;
  }
  context.save();
  context.beginPath();
  context.rect(frame.left, frame.top - 2, width, tall + 8);
  context.clip();
  context.globalAlpha = isOld ? 0.45 : 1;
  if (rest && height !== 'frequency') drawLine(context, rest, places, theme);
  for (const branch of branches) drawLine(context, branch, places, theme);
  if (law) inStyle(context, theme, lawStyle, () => segment(context, x.at(0), y.at(0), x.at(to), y.at(law.slope * to)));
  const { path } = shown;
  if (path) {
    context.globalAlpha = path.isOld ? 0.45 : 1;
    inStyle(context, theme, pathStyle, () => strokeCurve(context, curveOf(path.across, path.up, x.at, y.at)));
  }
  context.globalAlpha = 1;
  for (const { value, up, ...stop } of shown.sweep) drawStop(context, x.at(value), y.at(up), stop, theme);
  if (isInRange) drawGuideAcross(context, frame, x.at(now.value), theme);
  context.restore();
  if (trust > frame.top + 1.2 * theme.size) writeBeyond(context, { ...frame, bottom: trust }, theme, voice);
  if (!isOld) drawSpecialPoints(context, frame, shown.points.filter(({ across, up }) => across >= from && across <= to && up <= limit).map(({ kind, across, up, texts }) => ({ kind, x: x.at(across), y: y.at(up), texts })), pointsAlong([...branches, ...(rest && height !== 'frequency' ? [rest] : [])], places), ridden(now, places, theme), theme);
  drawKeys();
  if (isInRange && now.cycle && now.cycle.up <= limit) drawRing(context, x.at(now.value), y.at(now.cycle.up), 8 * Math.sqrt(theme.line), now.cycle.stable ? theme.ink : theme.unstable, theme);
  if (isInRange && now.motion !== null) drawPresent(context, x.at(now.value), y.at(Math.min(now.motion, limit)), theme.psi, theme);
  if (cursor) drawCursor(context, x.at(cursor.across), y.at(Math.min(cursor.up, limit)), theme);
  if (shown.message) {
    context.font = textFont(theme, 1, 600);
    context.fillStyle = theme.ink2;
    context.textAlign = 'center';
    context.textBaseline = 'middle';
    writeEdged(context, shown.message, (frame.left + frame.right) / 2, (frame.top + frame.bottom) / 2, theme);
  }
  return places;
}

/** Where the gear rides, which no name covers. @param {Shown['now']} now @param {Places} places @param {Theme} theme @returns {Box[]} */
function ridden({ value, motion, cycle }, { x, y }, theme) {
  const reach = 9 * Math.sqrt(theme.line);
  return [motion, cycle?.up ?? null].filter((up) => up !== null).map((up) => ({ left: x(value) - reach, right: x(value) + reach, top: y(up) - reach, bottom: y(up) + reach }));
}

/** Points along lines, no further apart than a letter. @param {readonly Line[]} lines @param {Places} places @returns {{ x: number, y: number }[]} in px */
function pointsAlong(lines, { x, y }) {
  return lines.flatMap(({ across, up }) => Array.from(across, (_, i) => i).flatMap((i) => {
    const [to, from] = [i, Math.max(0, i - 1)].map((at) => ({ x: x(across[at]), y: y(up[at]) }));
    const pieces = Math.min(50, Math.ceil(Math.hypot(to.x - from.x, to.y - from.y) / letter));
    return Array.from({ length: pieces }, (_, piece) => ({ x: to.x + ((from.x - to.x) * piece) / pieces, y: to.y + ((from.y - to.y) * piece) / pieces }));
  }));
}

/** Piece by piece of one stability. @param {CanvasRenderingContext2D} context @param {Line} line @param {Places} places @param {Theme} theme */
function drawLine(context, { across, up, stable, turns, isBeyond = () => false }, { x, y }, theme) {
  // A piece is as stable as that end of it at which nothing turns.
  const isPieceStable = (/** @type {number} */ from) => stable[turns.includes(from + 1) ? from : from + 1] === 1;
  const { globalAlpha } = context;
  for (let from = 0; from + 1 < across.length;) {
    const [isStable, isFar] = [isPieceStable(from), isBeyond(from + 1)];
    let to = from + 1;
    while (to + 1 < across.length && isPieceStable(to) === isStable && isBeyond(to + 1) === isFar) to++;
    context.globalAlpha = isFar ? globalAlpha * faint : globalAlpha;
    inStyle(context, theme, isStable ? stableCycle : unstableCycle, () => {
      context.beginPath();
      context.moveTo(x(across[from]), y(up[from]));
      for (let i = from + 1; i <= to; i++) context.lineTo(x(across[i]), y(up[i]));
      context.stroke();
    });
    from = to;
  }
  context.globalAlpha = globalAlpha;
}

/** @param {CanvasRenderingContext2D} context @param {Box} box @param {Theme} theme @param {Voice} voice */
function writeBeyond(context, { left, right, bottom }, theme, voice) {
  context.font = textFont(theme, 0.95);
  const text = [voice.say('branch.beyond'), voice.say('branch.beyond.short')].find((one) => context.measureText(one).width < right - left - theme.size);
  if (!text) return;
  context.fillStyle = theme.ink2;
  context.textAlign = 'right';
  context.textBaseline = 'bottom';
  writeEdged(context, text, right - 0.3 * theme.size, bottom - 0.15 * theme.size, theme);
}

/** What the model is not trusted for: a little darker. @param {CanvasRenderingContext2D} context @param {Box} box @param {Theme} theme */
function shadeBeyond(context, { left, right, top, bottom }, theme) {
  context.fillStyle = theme.raised;
  context.fillRect(left, top, right - left, bottom - top);
}

/** Where a simulated sweep has come to: a triangle that points the way it went, hollow where it had not settled. @param {CanvasRenderingContext2D} context @param {number} x @param {number} y @param {{ way: 'up' | 'down', isSettled: boolean }} stop @param {Theme} theme */
function drawStop(context, x, y, { way, isSettled }, theme) {
  const size = 3.6 * Math.sqrt(theme.line) * (way === 'up' ? 1 : -1);
  context.beginPath();
  context.moveTo(x + 1.3 * size, y);
  context.lineTo(x - size, y - size);
  context.lineTo(x - size, y + size);
  context.closePath();
  const color = way === 'up' ? theme.force : theme.y;
  context.fillStyle = isSettled ? color : theme.surface;
  context.fill();
  context.strokeStyle = color;
  context.lineWidth = 1.4 * theme.line;
  context.stroke();
}

/** @param {CanvasRenderingContext2D} context @param {number} x @param {number} y @param {Theme} theme */
function drawCursor(context, x, y, theme) {
  const reach = 11 * Math.sqrt(theme.line);
  inStyle(context, theme, destination, () => {
    segment(context, x - reach, y, x + reach, y);
    segment(context, x, y - reach, x, y + reach);
  });
  drawRing(context, x, y, 4 * Math.sqrt(theme.line), theme.psi, theme);
}

/** @param {CanvasRenderingContext2D} context @param {number} x1 @param {number} y1 @param {number} x2 @param {number} y2 */
function segment(context, x1, y1, x2, y2) {
  context.beginPath();
  context.moveTo(x1, y1);
  context.lineTo(x2, y2);
  context.stroke();
}
