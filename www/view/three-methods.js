import { axisUp, drawAxes, frameOf } from './axes.js';
import { keysAbove } from './key.js';
import { parameterAxis } from './parameter-axis.js';
import { drawRing } from './points.js';
import { quantities } from './quantities.js';
import { inStyle, stableCycle } from './strokes.js';
import { drawGuideAcross } from './guide.js';

/**
 * Amplitudes over a value of the gear by three methods: shooting solid, describing functions dashed, simulation as rings.
 *
 * @typedef {import('../controls/quantity.js').Quantity} Quantity
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {{ value: number, describing: number | null, shooting: number | null, simulation: number | null }} Place amplitudes in rad, null where there is none
 * @typedef {{ quantity: Quantity, from: number, to: number, now: number, places: readonly Place[], limit: number, names: { describing: string, shooting: string, simulation: string } }} Shown
 *   `now`: where the gear is; `limit`: the upper end of the axis, in rad
 */

/** @type {import('./strokes.js').Style} */
const describing = (context, theme) => {
  context.strokeStyle = theme.force;
  context.lineWidth = 2 * theme.line;
  context.setLineDash([8 * theme.line, 5 * theme.line]);
};

/**
 * @param {CanvasRenderingContext2D} context
 * @param {import('./canvas.js').Size} size
 * @param {Shown} shown
 * @param {Theme} theme
 * @param {Voice} voice
 */
export function drawThreeMethods(context, size, { quantity, from, to, now, places, limit, names }, theme, voice) {
  const area = frameOf(size, theme);
  const { frame, draw: drawKeys } = keysAbove(context, area, [
    { entry: { text: names.shooting, style: stableCycle }, color: theme.ink },
    { entry: { text: names.describing, style: describing }, color: theme.ink },
    { entry: { text: names.simulation, style: stableCycle }, color: theme.ink, isPoint: true },
  ], theme);
  if (frame.right - frame.left < 20 || frame.bottom - frame.top < 20) return;
  const x = parameterAxis(quantity, [from, to], [frame.left, frame.right], Math.min(10, (frame.right - frame.left) / (theme.size * 4.2)), voice);
  const y = axisUp(quantities.torsionAngle, [0, limit], frame, theme, voice);
  drawAxes(context, frame, x, y, theme);
  if (now >= from && now <= to) drawGuideAcross(context, frame, x.at(now), theme);
  for (const [method, style] of /** @type {const} */ ([['shooting', stableCycle], ['describing', describing]]))
    inStyle(context, theme, style, () => {
      context.beginPath();
      let isOpen = false;
      for (const place of places) {
        const amplitude = place[method];
        if (amplitude !== null) context[isOpen ? 'lineTo' : 'moveTo'](x.at(place.value), y.at(amplitude));
        isOpen = amplitude !== null;
      }
      context.stroke();
    });
  for (const { value, simulation } of places) if (simulation !== null) drawRing(context, x.at(value), y.at(simulation), 4.5 * Math.sqrt(theme.line), theme.ghost, theme);
  drawKeys();
}
