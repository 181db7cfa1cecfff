import { textFont } from '../view/text.js';

/**
 * @typedef {import('../view/canvas.js').Size} Size
 * @typedef {import('../view/canvas.js').Paint} Paint
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {{ size: Size, paint: Paint, over?: Paint }} Picture a view as it stands on the page; `over`: what a pen drew on it
 * @typedef {{ title: string, note?: string, values: string, link: string }} Caption `note`: what is said of the view on the page
 * @typedef {Pick<CanvasRenderingContext2D, 'font' | 'textAlign' | 'textBaseline' | 'measureText'>} Ruler a context that knows the fonts
 */

const margin = 20;
const lineHeight = 1.45;

/**
 * A view with its caption, as it leaves the page: the title, what is said of it and the values above, the address below.
 * @param {Picture} picture
 * @param {Caption} caption
 * @param {Theme} theme
 * @param {Ruler} ruler
 * @returns {Picture}
 */
export function plateOf({ size, paint, over }, { title, note = '', values, link }, theme, ruler) {
  const above = [...lines(title, 1.3, 600, theme.ink), ...lines(note, 1, 400, theme.ink), ...lines(values, 1, 400, theme.ink2)];
  const below = lines(link, 0.85, 400, theme.ink2);
  // On whole pixels, so that what the view keeps as bitmaps stays sharp.
  const top = Math.round(margin + heightOf(above) + margin / 2);
  const foot = top + size.height + margin / 2;
  const height = Math.ceil(foot + heightOf(below) + margin);

  /** @param {string} text @param {number} scale @param {number} weight @param {string} color */
  function lines(text, scale, weight, color) {
    const font = textFont(theme, scale, weight);
    return wrapped(text, size.width, font, ruler).map((line) => ({ line, font, color, height: theme.size * scale * lineHeight }));
  }

  /** @param {CanvasRenderingContext2D} context @param {typeof above} block @param {number} from */
  function write(context, block, from) {
    context.textAlign = 'left';
    context.textBaseline = 'alphabetic';
    let bottom = from;
    for (const { line, font, color, height: tall } of block) {
      bottom += tall;
      context.font = font;
      context.fillStyle = color;
      context.fillText(line, margin, bottom - 0.3 * tall);
    }
  }

  return {
    size: { width: Math.ceil(size.width) + 2 * margin, height },
    paint: (context, whole) => {
      context.fillStyle = theme.surface;
      context.fillRect(0, 0, whole.width, whole.height);
      write(context, above, margin);
      write(context, below, foot);
      context.save();
      context.translate(margin, top);
      context.beginPath();
      context.rect(0, 0, size.width, size.height);
      context.clip();
      for (const layer of [paint, over]) {
        context.save();
        layer?.(context, size);
        context.restore();
      }
      context.restore();
    },
  };
}

/** @param {{ height: number }[]} block */
function heightOf(block) {
  return block.reduce((sum, { height }) => sum + height, 0);
}

/**
 * Lines no wider than `width`, broken where words or the parts of an address end.
 * @param {string} text @param {number} width @param {string} font @param {Ruler} ruler
 */
function wrapped(text, width, font, ruler) {
  ruler.font = font;
  /** @type {string[]} */
  const lines = [];
  for (const part of text.match(/[^ &]+[ &]*/g) ?? []) {
    const longer = (lines.at(-1) ?? '') + part;
    if (lines.length > 0 && ruler.measureText(longer.trimEnd()).width <= width) lines[lines.length - 1] = longer;
    else lines.push(part);
  }
  return lines.map((line) => line.trimEnd());
}
