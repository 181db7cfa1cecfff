import assert from 'node:assert/strict';
import { readFile, readdir } from 'node:fs/promises';
import { test } from 'node:test';
import { SvgContext } from '../../../www/out/svg-context.js';

/** Half an em a letter; a middle that lies 0.35 em above the baseline. */
class Ruler {
  font = '';
  textAlign = 'start';
  textBaseline = 'alphabetic';

  /** @param {string} text */
  measureText(text) {
    const size = Number(/([\d.]+)px/.exec(this.font)?.[1]);
    return { width: 0.5 * size * text.length, fontBoundingBoxAscent: size * (this.textBaseline === 'middle' ? 0.6 : 0.95) };
  }
}
const ruler = /** @type {import('../../../www/out/svg-context.js').Ruler} */ (/** @type {unknown} */ (new Ruler()));
const fresh = () => new SvgContext({ width: 200, height: 100 }, ruler);
/** @param {SvgContext} context */
const lines = (context) => context.document('a test').split('\n').map((line) => line.trim());
/** @param {SvgContext} context @param {string} tag */
const elements = (context, tag) => lines(context).filter((line) => line.startsWith(`<${tag}`));
/** The numbers of a path's data. @param {string} element */
const numbers = (element) => (/ d="([^"]+)"/.exec(element)?.[1].match(/-?[\d.]+/g) ?? []).map(Number);

test('an empty drawing is a document of its size that says what it shows', () => {
  const [open, title] = lines(fresh());
  assert.equal(open, '<svg xmlns="http://www.w3.org/2000/svg" width="200" height="100" viewBox="0 0 200 100" role="img">');
  assert.equal(title, '<title>a test</title>');
  assert.match(new SvgContext({ width: 1, height: 1 }, ruler).document('v < 50 & rising'), /v &lt; 50 &amp; rising/);
});

test('points are set down through the transform of that moment', () => {
  const context = fresh();
  context.save();
  context.translate(100, 50);
  context.rotate(Math.PI / 2);
  context.scale(2, 2);
  context.moveTo(0, 0);
  context.lineTo(10, 0);
  context.restore();
  context.lineTo(1, 2);
  context.lineWidth = 3;
  context.stroke();
  const [path] = elements(context, 'path');
  assert.deepEqual(numbers(path), [100, 50, 100, 70, 1, 2]);
  assert.match(path, /stroke-width="3"/);
});

test('a pen keeps its width and dashes in the ratio of the transform, even an uneven one', () => {
  const context = fresh();
  context.setLineDash([4, 2]);
  context.lineWidth = 1.5;
  context.scale(2, -2);
  context.strokeRect(1, 1, 5, 5);
  context.scale(0.5, 1);
  context.strokeRect(1, 1, 5, 5);
  const [even, uneven] = elements(context, 'path');
  assert.match(even, /stroke-width="3" .*stroke-dasharray="8 4"/);
  assert.deepEqual(numbers(even).slice(0, 4), [2, -2, 12, -2]);
  assert.match(uneven, /stroke-width="1.5" .*stroke-dasharray="4 2" transform="matrix\(1 0 0 -2 0 0\)"/);
  assert.deepEqual(numbers(uneven).slice(0, 4), [1, 1, 6, 1]);
});

test('restore brings back pen, colors, type and axes', () => {
  const context = fresh();
  context.save();
  context.setLineDash([1, 2]);
  context.lineWidth = 9;
  context.strokeStyle = '#123456';
  context.lineCap = context.lineJoin = 'round';
  context.globalAlpha = 0.1;
  context.font = 'bold 99px serif';
  context.translate(1, 1);
  context.restore();
  context.strokeRect(0, 0, 1, 1);
  context.fillText('x', 0, 0);
  assert.match(elements(context, 'path')[0], /^<path fill="none" stroke="#000000" stroke-width="1" stroke-miterlimit="10" d="M0 0L1 0/);
  assert.match(elements(context, 'text')[0], /^<text x="0" y="0" font-family="sans-serif" font-size="10" textLength="5"/);
  assert.deepEqual(context.getLineDash(), []);
});

test('arcs are round to a hundredth of a pixel, go the way they are told and join what was drawn', () => {
  const context = fresh();
  context.moveTo(0, 0);
  context.arc(100, 50, 250, 0, Math.PI / 2, true);
  context.stroke();
  const [path] = elements(context, 'path');
  const [x0, y0, x1, y1, ...curves] = numbers(path);
  assert.deepEqual([x0, y0, x1, y1], [0, 0, 350, 50]);
  assert.equal(curves.length, 6 * 6, 'three quarters in six pieces');
  let from = [x1, y1];
  for (let i = 0; i < curves.length; i += 6) {
    const [ax, ay, bx, by, cx, cy] = curves.slice(i, i + 6);
    for (const t of [0.25, 0.5, 0.75]) {
      const [p, q, r, s] = [(1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3];
      const radius = Math.hypot(p * from[0] + q * ax + r * bx + s * cx - 100, p * from[1] + q * ay + r * by + s * cy - 50);
      assert.ok(Math.abs(radius - 250) < 0.02, `${radius}`);
    }
    from = [cx, cy];
  }
  assert.deepEqual(from, [100, 300]);
});

test('a clip narrows the one in force and ends with restore; equal ones stand once', () => {
  const context = fresh();
  const box = (/** @type {number} */ size) => {
    context.beginPath();
    context.rect(0, 0, size, size);
    context.clip();
    context.fillRect(0, 0, 5, 5);
  };
  context.fillRect(0, 0, 1, 1);
  context.save();
  box(50);
  box(20);
  context.restore();
  context.fillRect(0, 0, 2, 2);
  context.save();
  box(50);
  context.restore();
  const all = lines(context);
  assert.deepEqual(all.filter((line) => line.startsWith('<clipPath')).map((line) => /id="([^"]+)"(?: clip-path="url\(#([^"]+)\)")?/.exec(line)?.slice(1)),
    [['clip-1', undefined], ['clip-2', 'clip-1']]);
  const order = all.filter((line) => /^<g|^<\/g|^<path fill/.test(line)).map((line) => /clip-\d/.exec(line)?.[0] ?? line.slice(0, 3));
  assert.deepEqual(order, ['<pa', 'clip-1', '<pa', '</g', 'clip-2', '<pa', '</g', '<pa', 'clip-1', '<pa', '</g']);
});

test('colors and their opacity stand apart, times the opacity in force', () => {
  const context = fresh();
  context.globalAlpha = 0.5;
  context.fillStyle = '#0057b880';
  context.fillRect(0, 0, 1, 1);
  context.fillStyle = 'rgba(1, 2, 3, 0.4)';
  context.fillRect(0, 0, 1, 1);
  context.globalAlpha = 1;
  context.fillStyle = '#fff';
  context.fillRect(0, 0, 1, 1);
  assert.deepEqual(elements(context, 'path').map((line) => line.slice(6, line.indexOf(' d='))),
    ['fill="#0057b8" fill-opacity="0.251"', 'fill="rgb(1, 2, 3)" fill-opacity="0.2"', 'fill="#fff"']);
});

test('a gradient lies on the axes in force where it is painted', () => {
  const context = fresh();
  const gradient = context.createLinearGradient(0, 0, 10, 0);
  gradient.addColorStop(0, '#ff000080');
  gradient.addColorStop(1, '#00ff00');
  context.fillStyle = gradient;
  context.translate(30, 40);
  context.fillRect(0, 0, 10, 10);
  context.fillRect(20, 0, 10, 10);
  const [definition, ...more] = elements(context, 'linearGradient');
  assert.deepEqual(more, []);
  assert.match(definition, /x1="0" y1="0" x2="10" y2="0" gradientTransform="matrix\(1 0 0 1 30 40\)"/);
  assert.match(definition, /<stop offset="0" stop-color="#ff0000" stop-opacity="0.502"\/><stop offset="1" stop-color="#00ff00"\/>/);
  assert.equal(elements(context, 'path').filter((line) => line.includes('fill="url(#paint-1)"')).length, 2);
});

test('text stays text: type, anchor, width, and the baseline that every viewer knows', () => {
  const context = fresh();
  context.font = "italic 600 20px 'STIX Two Text', serif";
  context.textAlign = 'right';
  context.textBaseline = 'middle';
  context.fillText(' a < b', 100, 50);
  context.strokeText('ψ', 1, 2);
  context.rotate(Math.PI / 2);
  context.textBaseline = 'alphabetic';
  context.fillText('up', 7, 8);
  const [filled, stroked, turned] = elements(context, 'text');
  // 0.95 − 0.6 of 20 px below the middle.
  assert.equal(filled, `<text x="100" y="57" font-family="'STIX Two Text', serif" font-size="20" font-weight="600" font-style="italic" text-anchor="end"`
    + ' textLength="60" lengthAdjust="spacingAndGlyphs" xml:space="preserve" fill="#000000"> a &lt; b</text>');
  assert.match(stroked, /fill="none" stroke="#000000" stroke-width="1"/);
  assert.match(turned, /x="7" y="8" transform="matrix\(0 1 -1 0 0 0\)"/);
});

test('what has no place is left out, as a canvas does', () => {
  const context = fresh();
  context.lineTo(NaN, 1);
  context.stroke();
  context.fillText('x', Infinity, 0);
  context.fillText('', 1, 1);
  context.restore();
  assert.equal(lines(context).length, 4, 'opening, title, end, line break');
});

test('it knows every call and every style that the drawings use', async () => {
  const context = fresh();
  const sources = ['view', 'stage', 'stage/gear'].map((folder) => new URL(`../../../www/${folder}/`, import.meta.url));
  const used = new Set();
  for (const folder of sources)
    for (const name of (await readdir(folder)).filter((file) => file.endsWith('.js') && !['canvas.js', 'still.js'].includes(file)))
      for (const [, member] of (await readFile(new URL(name, folder), 'utf8')).matchAll(/\b(?:ctx|context)\.([a-zA-Z]+)/g)) used.add(member);
  assert.ok(used.size > 25, `${[...used]}`);
  assert.deepEqual([...used].filter((member) => !(member in context)), []);
});

test('an image keeps its pixels, is stretched as told, and turns with the axes', () => {
  const context = fresh();
  const image = /** @type {HTMLCanvasElement} */ (/** @type {unknown} */ ({ toDataURL: () => 'data:image/png;base64,AAAA' }));
  context.asContext.drawImage(image, 10, 20, 80, 40);
  context.translate(5, 6);
  context.asContext.imageSmoothingEnabled = false;
  context.asContext.drawImage(image, 0, 0, 8, 4);
  const [first, second] = elements(context, 'image');
  assert.ok(!first.includes('image-rendering') && second.includes('image-rendering: pixelated'), 'cells with edges keep them');
  assert.match(first, /x="10" y="20" width="80" height="40"/);
  assert.match(first, /preserveAspectRatio="none" href="data:image\/png;base64,AAAA"/);
  assert.match(second, /matrix\(1 0 0 1 5 6\)/);
});
