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
 * @param {{ align?: 'left' | 'right' | 'center', weight?: number, halo?: string }} [options] `halo`: a color around
 *   the letters, by which they stand off what they cross
 * @returns {number} its width
 */
export function drawLabel(context, runs, x, y, theme, { align = 'left', weight = 400, halo } = {}) {
  const widths = runs.map((run) => widthOfRun(context, run, theme, weight));
  const width = widths.reduce((sum, one) => sum + one, 0);
  const start = align === 'left' ? x : align === 'right' ? x - width : x - width / 2;
  context.textAlign = 'left';
  context.textBaseline = 'alphabetic';
  if (halo) {
    context.strokeStyle = halo;
    context.lineWidth = 4;
    context.lineJoin = 'round';
  }
  // All halos first, or one would cover the letters before it.
  for (const paint of halo ? /** @type {const} */ (['strokeText', 'fillText']) : /** @type {const} */ (['fillText'])) {
    let left = start;
    runs.forEach((run, i) => {
      drawRun(context, run, left, y, theme, weight, paint);
      left += widths[i];
    });
  }
  return width;
}

/**
 * Writes in the font, the color and the alignment in force, with an edge by which letters stand off what they cross.
 * @param {CanvasRenderingContext2D} context
 * @param {string} text
 * @param {number} x
 * @param {number} y
 * @param {Theme} theme
 * @param {number} [width] of the edge, both sides together
 */
export function writeEdged(context, text, x, y, theme, width = 4) {
  context.lineJoin = 'round';
  context.lineWidth = width;
  context.strokeStyle = theme.surface;
  context.strokeText(text, x, y);
  context.fillText(text, x, y);
}

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Run[]} runs
 * @param {Theme} theme
 * @param {number} [weight]
 */
export function widthOfLabel(context, runs, theme, weight = 400) {
  return runs.reduce((sum, run) => sum + widthOfRun(context, run, theme, weight), 0);
}

/** @param {CanvasRenderingContext2D} context @param {Run} run @param {Theme} theme @param {number} weight */
function widthOfRun(context, run, theme, weight) {
  context.font = 'text' in run ? textFont(theme, 1, weight) : symbolFont(theme);
  const { width } = context.measureText('text' in run ? run.text : run.symbol);
  if (!('sub' in run && run.sub)) return width;
  context.font = symbolFont(theme, 0.7);
  return width + Math.max(theme.size * 0.7, context.measureText(run.sub).width);
}

/**
 * @param {CanvasRenderingContext2D} context @param {Run} run @param {number} x @param {number} y @param {Theme} theme
 * @param {number} weight @param {'strokeText' | 'fillText'} paint
 */
function drawRun(context, run, x, y, theme, weight, paint) {
  if ('text' in run) {
    context.font = textFont(theme, 1, weight);
    context[paint](run.text, x, y);
    return;
  }
  context.font = symbolFont(theme);
  context[paint](run.symbol, x, y);
  const width = context.measureText(run.symbol).width;
  if (run.sub) {
    context.font = symbolFont(theme, 0.7);
    context[paint](run.sub, x + width, y + theme.size * 0.25);
  }
  if (!run.dotted || paint === 'strokeText') return;
  // The time derivative's dot, set by hand: few fonts place a combining dot well over an italic letter.
  context.beginPath();
  context.arc(x + width * 0.58, y - theme.size * 0.98, theme.size * 0.085, 0, 2 * Math.PI);
  context.fill();
}
