/**
 * How a line of text is set: its type, its anchor, and its width, so that it keeps its place with whatever typeface the
 * viewer has.
 * @param {string} text
 * @param {string} font as a canvas takes it, `italic 600 13px Inter, sans-serif`
 * @param {CanvasTextAlign} align
 * @param {number} width as measured
 */
export function textAttributes(text, font, align, width) {
  const parts = /^(?:(italic|oblique|normal)\s+)?(?:(bold|normal|[1-9]\d*)\s+)?([\d.]+)px\s+(.+)$/.exec(font);
  if (!parts) throw new Error(`a font that SVG is not told of: ${font}`);
  const [, slope, weight, size, families] = parts;
  const anchor = align === 'center' ? ' text-anchor="middle"' : align === 'right' || align === 'end' ? ' text-anchor="end"' : '';
  return ` font-family="${families.replaceAll('"', "'")}" font-size="${Number(Number(size).toFixed(2))}"`
    + (weight && weight !== '400' && weight !== 'normal' ? ` font-weight="${weight}"` : '')
    + (slope && slope !== 'normal' ? ` font-style="${slope}"` : '')
    + anchor
    + (width > 0 ? ` textLength="${Number(width.toFixed(2))}" lengthAdjust="spacingAndGlyphs"` : '')
    + (/^\s|\s$|\s\s/.test(text) ? ' xml:space="preserve"' : '');
}
