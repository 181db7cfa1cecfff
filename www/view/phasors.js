import { drawArrow } from './arrow.js';
import { writeCornerReading } from './corner-reading.js';
import { drawLabel, textFont, widthOfLabel } from './text.js';

/**
 * A mode as phasors: how wide each state swings beside the others, and by how much it lags. What lies at an angle behind the
 * first, clockwise, comes so much later. They all turn counter-clockwise, and their tips go in or out on the way: one turn of
 * the first is drawn. A mode that does not swing has its states along one line, each in a row of its own.
 *
 * @typedef {import('./canvas.js').Size} Size
 * @typedef {import('./text.js').Run} Run
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {{ re: number, im: number, color: 'psi' | 'y', form: 'solid' | 'dotted' | 'ringed', name: Run[], phase: string }} Arm
 *   measured so that the first has the length 1; `phase` in words, '' for the first
 * @typedef {{ arms: readonly Arm[], growth: number, swings: boolean, readings: readonly string[] }} Shown `growth`: of the
 *   amplitude in a radian of the turn, the natural logarithm; without a swing in a unit of time of its own
 */

const circle = 2 * Math.PI;
const [spiralSteps, armSteps] = [120, 20];
/** Where words may stand off a tip: turned from its direction so far, in rad, and so many letters further out. */
const turns = [0, 0.5, -0.5, 1, -1, 1.6, -1.6, 2.2, -2.2];
const steps = [0, 1, 2, 3];
/** Dots of what falls or grows without a swing, and the logarithm of their ratio. */
const [dots, dotRatio] = [6, 0.3];

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Size} size
 * @param {Shown} shown
 * @param {Theme} theme
 */
export function drawPhasors(context, { width, height }, { arms, growth, swings, readings }, theme) {
  const frame = { left: theme.size, right: width - theme.size, top: theme.size * 2.2, bottom: height - theme.size * 0.8 };
  // Words stand beside the arms of a mode that does not swing, and above or below those of one that does.
  const across = (frame.right - frame.left) / 2 - theme.size * (swings ? 3 : 6.5);
  const room = swings ? Math.min(across, (frame.bottom - frame.top) / 2 - theme.size * 2) : across;
  if (room < 20) return;
  const longest = Math.max(1, ...arms.map(({ re, im }) => Math.hypot(re, im)));
  const scale = room / longest;
  const middle = { x: (frame.left + frame.right) / 2, y: (frame.top + frame.bottom) / 2 };
  context.save();
  context.beginPath();
  context.rect(0, frame.top - theme.size * 0.4, width, height);
  context.clip();
  if (swings) {
    drawDial(context, middle, scale, theme);
    drawSpiral(context, middle, scale, growth, theme);
  }
  context.restore();
  const rows = swings ? 0 : Math.min(theme.size * 4, (frame.bottom - frame.top) / arms.length);
  arms.forEach((arm, i) => {
    const from = { x: middle.x, y: middle.y + (i - (arms.length - 1) / 2) * rows };
    if (!swings) drawRow(context, from, room, arm, scale, growth, theme);
    drawArm(context, from, arm, scale, theme);
  });
  const lines = swings ? [...spiralPoints(middle, scale, growth), ...arms.flatMap((arm) => alongArm(middle, arm, scale))] : [];
  arms.forEach((arm, i) => {
    const from = { x: middle.x, y: middle.y + (i - (arms.length - 1) / 2) * rows };
    lines.push(...nameArm(context, from, arm, scale, frame, lines, theme));
  });
  const sample = swings ? 2.6 * theme.size : 0;
  const written = writeCornerReading(context, readings, frame, frame.right - frame.left - sample - 0.5 * theme.size, theme);
  if (written > 0 && swings) drawSample(context, frame.right - written - 0.5 * theme.size, frame.top - theme.size * 1.15, sample, growth, theme);
}

/** A piece of the spiral, before the words that tell of it. @param {CanvasRenderingContext2D} context @param {number} end @param {number} y @param {number} length @param {number} growth @param {Theme} theme */
function drawSample(context, end, y, length, growth, theme) {
  strokeAsSpiral(context, growth, theme, () => {
    context.moveTo(end - length, y);
    context.lineTo(end, y);
  });
}

/** The unit circle, its axes, and which way all turns. @param {CanvasRenderingContext2D} context @param {{ x: number, y: number }} middle @param {number} scale @param {Theme} theme */
function drawDial(context, { x, y }, scale, theme) {
  context.strokeStyle = theme.rule;
  context.lineWidth = 1;
  context.beginPath();
  context.arc(x, y, scale, 0, circle);
  context.moveTo(x - 1.15 * scale, y);
  context.lineTo(x + 1.15 * scale, y);
  context.moveTo(x, y - 1.15 * scale);
  context.lineTo(x, y + 1.15 * scale);
  context.stroke();
  const [from, to] = [(200 * Math.PI) / 180, (230 * Math.PI) / 180];
  const at = (/** @type {number} */ angle) => ({ x: x + 0.8 * scale * Math.cos(angle), y: y - 0.8 * scale * Math.sin(angle) });
  context.strokeStyle = theme.ink2;
  context.fillStyle = theme.ink2;
  context.lineWidth = 1.4 * theme.line;
  context.beginPath();
  context.arc(x, y, 0.8 * scale, -from, -to, true);
  context.stroke();
  drawArrow(context, at(to - 0.05), at(to + 0.06), theme, { headOnly: true });
  drawLabel(context, [{ symbol: 'ω' }], x + 0.66 * scale * Math.cos((from + to) / 2), y - 0.66 * scale * Math.sin((from + to) / 2) + theme.size * 0.35, theme, { align: 'center' });
}

/** The way of the first tip in the turn to come. @param {CanvasRenderingContext2D} context @param {{ x: number, y: number }} middle @param {number} scale @param {number} growth @param {Theme} theme */
function drawSpiral(context, { x, y }, scale, growth, theme) {
  strokeAsSpiral(context, growth, theme, () =>
    spiralPoints({ x, y }, scale, growth).forEach((point, i) => context[i === 0 ? 'moveTo' : 'lineTo'](point.x, point.y)));
}

/** @param {CanvasRenderingContext2D} context @param {number} growth @param {Theme} theme @param {() => void} trace */
function strokeAsSpiral(context, growth, theme, trace) {
  context.strokeStyle = growth > 0 ? theme.unstable : theme.stable;
  context.lineWidth = 1.8 * theme.line;
  context.setLineDash(growth > 0 ? [6 * theme.line, 4 * theme.line] : []);
  context.beginPath();
  trace();
  context.stroke();
  context.setLineDash([]);
}

/** @param {{ x: number, y: number }} middle @param {number} scale @param {number} growth */
function spiralPoints({ x, y }, scale, growth) {
  return Array.from({ length: spiralSteps + 1 }, (_, i) => {
    const angle = (circle * i) / spiralSteps;
    const length = scale * Math.exp(growth * angle);
    return { x: x + length * Math.cos(angle), y: y - length * Math.sin(angle) };
  });
}

/** Points along an arm, as close as words are high. @param {{ x: number, y: number }} from @param {Arm} arm @param {number} scale */
function alongArm({ x, y }, { re, im }, scale) {
  return Array.from({ length: armSteps + 1 }, (_, i) => ({ x: x + (re * scale * i) / armSteps, y: y - (im * scale * i) / armSteps }));
}

/** A line without a swing: where the tip is after equal times. @param {CanvasRenderingContext2D} context @param {{ x: number, y: number }} from @param {number} room @param {Arm} arm @param {number} scale @param {number} growth @param {Theme} theme */
function drawRow(context, { x, y }, room, { re }, scale, growth, theme) {
  context.strokeStyle = theme.rule;
  context.lineWidth = 1;
  context.beginPath();
  context.moveTo(x - room, y);
  context.lineTo(x + room, y);
  context.moveTo(x, y - theme.size * 0.5);
  context.lineTo(x, y + theme.size * 0.5);
  context.stroke();
  context.fillStyle = growth > 0 ? theme.unstable : theme.stable;
  for (let i = 1; i <= dots; i++) {
    const length = re * scale * Math.exp(Math.sign(growth) * dotRatio * i);
    if (Math.abs(length) > room) break;
    context.beginPath();
    context.arc(x + length, y - theme.size * 0.55, 2 * theme.line, 0, circle);
    context.fill();
  }
}

/** @param {CanvasRenderingContext2D} context @param {{ x: number, y: number }} from @param {Arm} arm @param {number} scale @param {Theme} theme */
function drawArm(context, from, { re, im, color, form }, scale, theme) {
  const tip = { x: from.x + re * scale, y: from.y - im * scale };
  context.strokeStyle = theme[color];
  context.fillStyle = theme[color];
  context.lineWidth = 2.6 * theme.line;
  context.setLineDash(form === 'dotted' ? [2 * theme.line, 3.5 * theme.line] : []);
  if (form !== 'ringed') {
    drawArrow(context, from, tip, theme);
    return;
  }
  const ring = 4.5 * Math.sqrt(theme.line);
  const length = Math.hypot(tip.x - from.x, tip.y - from.y);
  const end = length > ring ? { x: tip.x - ((tip.x - from.x) * ring) / length, y: tip.y - ((tip.y - from.y) * ring) / length } : from;
  context.beginPath();
  context.moveTo(from.x, from.y);
  context.lineTo(end.x, end.y);
  context.stroke();
  context.beginPath();
  context.arc(tip.x, tip.y, ring, 0, circle);
  context.stroke();
}

/**
 * What it is, at its tip, with its phase below: where it crosses least of the lines, and as near as that goes.
 * @param {CanvasRenderingContext2D} context @param {{ x: number, y: number }} from @param {Arm} arm @param {number} scale
 * @param {{ left: number, right: number, top: number, bottom: number }} frame @param {readonly { x: number, y: number }[]} lines @param {Theme} theme
 * @returns {{ x: number, y: number }[]} points of what is now written, which others keep clear of
 */
function nameArm(context, from, { re, im, color, name, phase }, scale, frame, lines, theme) {
  const direction = Math.atan2(im, re);
  const tip = { x: from.x + re * scale, y: from.y - im * scale };
  const [wide, high] = [Math.max(widthOfLabel(context, name, theme, 600), phase ? widthOfLabel(context, [{ text: phase }], theme) : 0), theme.size * (phase ? 2.5 : 1.25)];
  // The words stand off the tip with the side or corner that is nearest to it.
  const shift = (/** @type {number} */ share) => Math.min(1, Math.max(-1, 1.6 * share)) / 2;
  const places = steps.flatMap((step) => turns.map((turn) => {
    const [across, up] = [Math.cos(direction + turn), Math.sin(direction + turn)];
    const off = theme.size * (0.8 + step);
    const x = Math.min(Math.max(tip.x + across * off + shift(across) * wide, frame.left + wide / 2), frame.right - wide / 2);
    const y = Math.min(Math.max(tip.y - up * off - shift(up) * high, frame.top + high / 2), frame.bottom - high / 2);
    const crossed = lines.filter((point) => Math.abs(point.x - x) < wide / 2 + 3 && Math.abs(point.y - y) < high / 2 + 3).length;
    return { x, y, cost: 4 * crossed + 3 * step + Math.abs(turn) };
  }));
  const { x, y: middle } = places.reduce((best, one) => (one.cost < best.cost ? one : best));
  const y = middle - high / 2 + theme.size;
  context.fillStyle = theme[color];
  drawLabel(context, name, x, y, theme, { align: 'center', weight: 600, halo: theme.surface });
  if (phase) {
    context.font = textFont(theme);
    drawLabel(context, [{ text: phase }], x, y + theme.size * 1.25, theme, { align: 'center', halo: theme.surface });
  }
  return [-0.5, -0.25, 0, 0.25, 0.5].flatMap((share) => [-0.5, 0, 0.5].map((part) => ({ x: x + share * wide, y: middle + part * high })));
}
