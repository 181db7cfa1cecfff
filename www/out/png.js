/**
 * A picture as a PNG, at twice its size on the screen.
 * @param {import('./plate.js').Picture} picture
 * @param {number} [scale]
 * @returns {Promise<Blob>}
 */
export function pngOf({ size, paint }, scale = 2) {
  const canvas = document.createElement('canvas');
  canvas.width = Math.round(size.width * scale);
  canvas.height = Math.round(size.height * scale);
  const context = canvas.getContext('2d');
  if (!context) return Promise.reject(new Error('this browser gives no canvas to draw on'));
  context.scale(scale, scale);
  paint(context, size);
  return new Promise((done, fail) => {
    canvas.toBlob((blob) => (blob ? done(blob) : fail(new Error('this browser makes no PNG of that size'))), 'image/png');
  });
}
