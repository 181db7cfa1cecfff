/** Labels on a canvas in which symbols stand in italics: `ψ torsion angle`, with a dot where a rate is meant. */

/**
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {{ text: string } | { symbol: string, sub?: string, dotted?: boolean }} Run a piece of a label
 */

/**
 * @param {Theme} theme
 * @param {number} [scale] of the small text
 * @param {number} [weight]
 */
export function textFont(theme, scale = 1, weight = 400) {
  return `${weight} ${theme.size * scale}px ${theme.sans}`;
}

/**
 * @param {Theme} theme
 * @param {number} [scale]
 */
export function symbolFont(theme, scale = 1) {
  return `italic 400 ${theme.size * 1.2 * scale}px ${theme.serif}`;
}

/**
 * Draws a label on the baseline `y`, from, up to or around `x`.
 * @param {CanvasRenderingContext2D} context
 * @param {Run[]} runs
 * @param {number} x
 * @param {number} y
 * @param {Theme} theme
 * @param {{ align?: 'left' | 'right' | 'center', weight?: number }} [options]
 */
export function drawLabel(context, runs, x, y, theme, { align = 'left', weight = 400 } = {}) {
  const widths = runs.map((run) => {
    context.font = 'text' in run ? textFont(theme, 1, weight) : symbolFont(theme);
    return context.measureText('text' in run ? run.text : run.symbol).width + ('sub' in run && run.sub ? theme.size * 0.7 : 0);
  });
  const width = widths.reduce((sum, one) => sum + one, 0);
  let left = align === 'left' ? x : align === 'right' ? x - width : x - width / 2;
  context.textAlign = 'left';
  context.textBaseline = 'alphabetic';
  runs.forEach((run, i) => {
    if ('text' in run) {
      context.font = textFont(theme, 1, weight);
      context.fillText(run.text, left, y);
    } else {
      drawSymbol(context, run, left, y, theme);
    }
    left += widths[i];
  });
  return width;
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {{ symbol: string, sub?: string, dotted?: boolean }} run
 * @param {number} x
 * @param {number} y
 * @param {Theme} theme
 */
function drawSymbol(context, { symbol, sub, dotted }, x, y, theme) {
  context.font = symbolFont(theme);
  context.fillText(symbol, x, y);
  const width = context.measureText(symbol).width;
  if (sub) {
    context.font = symbolFont(theme, 0.7);
    context.fillText(sub, x + width, y + theme.size * 0.25);
  }
  if (!dotted) return;
  // The time derivative's dot, set by hand: few fonts place a combining dot well over an italic letter.
  context.beginPath();
  context.arc(x + width * 0.58, y - theme.size * 0.98, theme.size * 0.085, 0, 2 * Math.PI);
  context.fill();
}
