/**
 * The parts of a schematic: rods, springs, dashpots.
 *
 * @typedef {import('../../style/theme.js').Theme} Theme
 * @typedef {{ from: number, to: number, y: number, tall: number }} Place between two ends, in px
 */

/** @param {CanvasRenderingContext2D} context @param {number} from @param {number} to @param {number} y @param {Theme} theme */
export function drawRod(context, from, to, y, theme) {
  context.strokeStyle = theme.ink;
  context.lineWidth = 1.8 * theme.line;
  context.beginPath();
  context.moveTo(from, y);
  context.lineTo(to, y);
  context.stroke();
}

const coils = 6;

/** A spring that is as long as its ends are apart. @param {CanvasRenderingContext2D} context @param {Place} place @param {Theme} theme */
export function drawSpring(context, { from, to, y, tall }, theme) {
  const lead = 0.16 * (to - from);
  const pitch = (to - from - 2 * lead) / (2 * coils);
  context.strokeStyle = theme.psi;
  context.lineWidth = 2 * theme.line;
  context.lineJoin = 'round';
  context.beginPath();
  context.moveTo(from, y);
  context.lineTo(from + lead, y);
  for (let i = 0; i < 2 * coils; i++) context.lineTo(from + lead + (i + 0.5) * pitch, y + (i % 2 ? 0.5 : -0.5) * tall);
  context.lineTo(to - lead, y);
  context.lineTo(to, y);
  context.stroke();
}

/**
 * A pot that the left end holds, with a piston that the right end moves.
 * @param {CanvasRenderingContext2D} context @param {Place & { piston: number }} place `piston`: where it is, in px @param {Theme} theme
 */
export function drawDashpot(context, { from, to, y, tall, piston }, theme) {
  const length = to - from;
  const [back, mouth] = [from + 0.22 * length, from + 0.76 * length];
  const inside = Math.min(Math.max(piston, back + 5 * theme.line), mouth - 5 * theme.line);
  drawRod(context, from, back, y, theme);
  drawRod(context, inside, to, y, theme);
  context.strokeStyle = theme.ink;
  context.lineWidth = 1.8 * theme.line;
  context.beginPath();
  context.moveTo(mouth, y - tall / 2);
  context.lineTo(back, y - tall / 2);
  context.lineTo(back, y + tall / 2);
  context.lineTo(mouth, y + tall / 2);
  context.stroke();
  context.fillStyle = theme.stable;
  context.fillRect(inside - 2.5 * theme.line, y - 0.42 * tall, 5 * theme.line, 0.84 * tall);
}
