import { axisAcross, axisUp, drawAxes, frameOf } from '../axes.js';
import { curveOf, strokeCurve } from '../curve.js';
import { mix } from './ramp.js';
import { grids, inPanel, panelsIn } from '../panels.js';
import { drawPresentWithin } from '../points.js';
import { quantities } from '../quantities.js';
import { textFont, writeEdged } from '../text.js';
import { drawVeil } from '../veil.js';

/**
 * A damper's loops: its force over the piston's displacement, and over its velocity, several on one plot with the point of now.
 *
 * @typedef {import('../../style/theme.js').Theme} Theme
 * @typedef {import('../../words/voice.js').Voice} Voice
 * @typedef {ArrayLike<number>} Series
 * @typedef {{ displacement: Series, velocity: Series, force: Series }} Motion
 * @typedef {Motion & { label: string, isChosen?: boolean, isOpen?: boolean, dash?: number[] }} Loop `isOpen`: its end is not its start; `dash`: what tells models apart; currents are told by their strength
 * @typedef {{ displacement: number, velocity: number, force: number }} Place in SI units
 * @typedef {{ loops: readonly Loop[], limits: Place, now?: Place | null, trail?: Motion | null, data?: readonly Motion[], veiled?: boolean, isShare?: boolean }} Shown `trail`: where a hand went; `data`: measured points;
 *   `limits`: the ends of the axes; `isShare`: each force is over its own greatest
 */

/** The two plots, and what of a loop is to the right in each. */
const across = /** @type {const} */ (['displacement', 'velocity']);
const quantityOf = { displacement: quantities.pistonDisplacement, velocity: quantities.pistonVelocity };
/** Two plots side by side are narrow below this, in widths of small type. */
const cramped = 48;
/** Measured points drawn at most, of each record. */
const mostPoints = 400;

/**
 * @param {CanvasRenderingContext2D} context
 * @param {import('../canvas.js').Size} size
 * @param {Shown} shown
 * @param {Theme} theme
 * @param {Voice} voice
 */
export function drawLoops(context, size, shown, theme, voice) {
  if (size.width < 40 || size.height < 40) return;
  const panels = panelsIn(size, grids(2));
  // Where plots are narrow the names stand at the last of a row alone.
  const isCramped = panels[0].top === panels[1].top && size.width < cramped * theme.size;
  panels.forEach((panel, i) => inPanel(context, panel, (within, room) => drawOne(within, room, shown, { name: across[i], isNamed: i === 1 || !isCramped }, theme, voice)));
}

/** @param {CanvasRenderingContext2D} context @param {import('../canvas.js').Size} size @param {Shown} shown @param {{ name: typeof across[number], isNamed: boolean }} plot @param {Theme} theme @param {Voice} voice */
function drawOne(context, size, { loops, limits, now, trail, data = [], veiled, isShare }, { name, isNamed }, theme, voice) {
  const area = frameOf(size, theme, 'above');
  context.font = textFont(theme, 0.95, 600);
  const room = isNamed ? Math.max(0, ...loops.map(({ label }) => context.measureText(label).width)) : 0;
  const frame = { ...area, left: area.left + theme.size * 0.4, right: Math.min(area.right, size.width - room - theme.size * 0.9) };
  if (frame.right - frame.left < 20 || frame.bottom - frame.top < 20) return;
  const force = isShare ? quantities.forceShare : limits.force >= 5000 ? quantities.damperForceLarge : quantities.damperForce;
  const x = axisAcross(quantityOf[name], [-limits[name], limits[name]], frame, theme, voice);
  const y = axisUp(force, [-limits.force, limits.force], frame, theme, voice);
  drawAxes(context, frame, x, y, theme, { up: 'above' });
  if (veiled) {
    drawVeil(context, frame, theme);
    return;
  }
  context.save();
  context.beginPath();
  context.rect(frame.left - 1, frame.top - 1, frame.right - frame.left + 2, frame.bottom - frame.top + 2);
  context.clip();
  for (const record of data) drawPoints(context, curveOf(record[name], record.force, x.at, y.at), theme);
  loops.forEach((loop, i) => {
    styleOf(context, loop, i, loops.length, theme);
    strokeCurve(context, curveOf(loop[name], loop.force, x.at, y.at), { isClosed: !loop.isOpen });
  });
  context.setLineDash([]);
  if (trail) {
    context.strokeStyle = theme.psi;
    context.lineWidth = 2 * theme.line;
    strokeCurve(context, curveOf(trail[name], trail.force, x.at, y.at));
  }
  context.restore();
  if (isNamed) writeNames(context, loops.map((loop, i) => ({ text: loop.label, color: colorOf(loop, i, loops.length, theme), isStrong: Boolean(loop.isChosen), y: y.at(heightOf(loop, name)) })), frame, theme);
  if (now) drawPresentWithin(context, frame, x.at(now[name]), y.at(now.force), theme.psi, theme);
}

/** The more current, the stronger; the chosen one in the accent. @param {{ isChosen?: boolean }} loop @param {number} i @param {number} count @param {Theme} theme */
export const colorOf = ({ isChosen = false }, i, count, theme) => (isChosen ? theme.psi : mix(theme.ghost, theme.ink, count > 1 ? i / (count - 1) : 1));

/** @param {CanvasRenderingContext2D} context @param {Loop} loop @param {number} i @param {number} count @param {Theme} theme */
function styleOf(context, loop, i, count, theme) {
  context.strokeStyle = colorOf(loop, i, count, theme);
  context.lineWidth = (loop.isOpen ? 1 : loop.isChosen ? 2.8 : 1.3 + (0.7 * i) / Math.max(1, count - 1)) * theme.line;
  context.setLineDash((loop.dash ?? []).map((one) => one * theme.line));
  context.lineJoin = 'round';
}

/** @param {CanvasRenderingContext2D} context @param {import('../curve.js').Curve} points @param {Theme} theme */
function drawPoints(context, { count, x, y }, theme) {
  const stride = Math.max(1, Math.ceil(count / mostPoints));
  const radius = 1.6 * Math.sqrt(theme.line);
  context.fillStyle = theme.force;
  context.globalAlpha = 0.65;
  context.beginPath();
  for (let i = 0; i < count; i += stride) {
    context.moveTo(x(i) + radius, y(i));
    context.arc(x(i), y(i), radius, 0, 2 * Math.PI);
  }
  context.fill();
  context.globalAlpha = 1;
}

/**
 * Names at the right end, each at its height; none over another.
 * @param {CanvasRenderingContext2D} context @param {readonly { text: string, color: string, isStrong: boolean, y: number }[]} names @param {import('../axes.js').Box} frame @param {Theme} theme
 */
export function writeNames(context, names, frame, theme) {
  const placed = names.map((name) => ({ ...name, y: Math.min(Math.max(name.y, frame.top), frame.bottom) })).sort((one, other) => one.y - other.y);
  spread(placed, theme.size * 1.2, frame);
  context.textAlign = 'left';
  context.textBaseline = 'middle';
  for (const { text, color, isStrong, y } of placed) {
    context.font = textFont(theme, 0.95, isStrong ? 600 : 400);
    context.fillStyle = color;
    writeEdged(context, text, frame.right + theme.size * 0.4, y, theme);
  }
}

/** The force by which a loop is told from others: where it moves fastest to the right. @param {Loop} loop @param {typeof across[number]} name */
function heightOf(loop, name) {
  const values = name === 'velocity' ? loop.velocity : loop.force;
  let at = 0;
  for (let i = 0; i < values.length; i++) if (values[i] > values[at]) at = i;
  return loop.force[at] ?? 0;
}

/** Moves names apart, from the middle of each crowd. @param {{ y: number }[]} named sorted @param {number} high @param {import('../axes.js').Box} frame */
function spread(named, high, { top, bottom }) {
  for (let i = 1; i < named.length; i++) named[i].y = Math.max(named[i].y, named[i - 1].y + high);
  const over = (named.at(-1)?.y ?? 0) - (bottom - high / 2);
  if (over > 0) for (let i = named.length - 1; i >= 0; i--) named[i].y = Math.min(named[i].y, i === named.length - 1 ? bottom - high / 2 : named[i + 1].y - high);
  if (named[0] && named[0].y < top - high) named[0].y = top;
}
