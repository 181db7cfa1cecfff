// The stability plane as drawn: colors, hatch, boundary, words, point, legend.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Quantity } from '../../www/controls/quantity.js';
import { hatchOf } from '../../www/view/hatch.js';
import { isoLinesOf } from '../../www/view/iso-lines.js';
import { colorsOf, paintPixels, written as hex } from '../../www/view/map-colors.js';
import { drawMapLegend } from '../../www/view/map-legend.js';
import { sheetOf } from '../../www/view/map-sheet.js';
import { roomiest } from '../../www/view/roomiest.js';
import { drawStabilityMap, frameOfMap, placesOfMap } from '../../www/view/stability-map.js';
import { voiceOf } from '../../www/words/voice.js';
import { criticalSpeeds, dampingOverVelocity, growthRates } from './linear-gear.mjs';
import { recordingContext, written } from './plot-recorder.mjs';
import { theme } from './theme.mjs';

const voice = voiceOf('en');
const size = { width: 600, height: 320 };
const [columns, rows] = [200, 150];
const rates = growthRates({ ...dampingOverVelocity, columns, rows });
const map = { columns, rows, stable: Uint8Array.from(rates, (rate) => (rate < 0 ? 1 : 0)), growthRate: rates, frequency: null, kind: Uint8Array.from(rates, () => 1) };
const limits = { growthRate: 40, frequency: /** @type {[number, number]} */ ([40, 60]) };
const words = { stable: 'dies out', hopf: 'shimmies', divergence: 'turns aside' };
const frame = frameOfMap(size, theme);
const { x: xAt, y: yAt, valueX, valueY } = placesOfMap(frame, dampingOverVelocity.x, dampingOverVelocity.y);
const quantity = (/** @type {string} */ name, /** @type {string} */ symbol, /** @type {string} */ unit) => new Quantity({ name, symbol, unit, default: 1, min: 0, max: 100, scale: 'linear', doc: '' });
const sides = {
  x: { ...dampingOverVelocity.x, quantity: quantity('velocity', 'v', 'm/s') },
  y: { ...dampingOverVelocity.y, quantity: quantity('dampingConstant', 'c', 'N m s/rad') },
};
/** @type {import('../../www/run/linear-looks.js').BoundaryCurve[]} */
const boundary = [{ x: Float64Array.from(criticalSpeeds, ([, v]) => v), y: Float64Array.from(criticalSpeeds, ([c]) => c), frequency: new Float64Array(5), kind: 'hopf', closed: false, bounds: true }];
const look = { coloring: /** @type {const} */ ('growthRate'), limits, words };
const sheet = sheetOf(recordingContext().context, frame, map, look, theme, voice);
const image = /** @type {CanvasImageSource} */ (/** @type {unknown} */ ({}));
const shown = { ...sides, image, sheet, boundary, coloring: look.coloring, limits, point: { x: 80, y: 30 }, readings: ['v 80 m/s, c 30: grows'] };

test('colors switch exactly where the growth rate does, through the page’s own', () => {
  const pixels = new Uint8ClampedArray(4 * columns * rows);
  const colorOf = colorsOf('growthRate', limits, theme);
  paintPixels({ values: rates, columns, rows }, colorOf, pixels);
  for (const [damping, speed] of criticalSpeeds.slice(1)) {
    // The row whose middle is nearest above this damping; the highest row is the first of a picture.
    const row = Math.round((damping / 100) * rows);
    const reddish = Array.from({ length: columns }, (_, column) => {
      const at = 4 * ((rows - 1 - row) * columns + column);
      return pixels[at] - pixels[at + 2];
    });
    const first = reddish.findIndex((_, column) => reddish.slice(column).every((red) => red > 6));
    const cell = 99.5 / columns;
    // Next to the boundary a color is nearly the page's: five cells are a growth rate of about 0.7.
    const found = 0.5 + first * cell;
    assert.ok(found > speed - cell && found < speed + 5 * cell, `c ${damping}: red from ${found}, critical ${speed}`);
  }
  assert.equal(hex(colorOf(0)), theme.page);
  assert.equal(hex(colorOf(1e9)), hex(colorOf(limits.growthRate)));
  assert.notEqual(hex(colorOf(20)), hex(colorOf(40)));
  // At the ends the page's own is mixed with the token of what becomes of the swing, by the same share for each channel.
  for (const [rate, token] of /** @type {const} */ ([[40, theme.unstable], [-40, theme.stable]])) {
    const of = (/** @type {string} */ color) => [1, 3, 5].map((at) => parseInt(color.slice(at, at + 2), 16));
    const [page, end] = [of(theme.page), of(token)];
    const shares = page.map((from, i) => (colorOf(rate)[i] - from) / (end[i] - from));
    assert.ok(shares.every((share) => share > 0.5 && Math.abs(share - shares[0]) < 0.01), `${rate}: ${shares}`);
  }
});

test('just stable or not has two colors; frequencies get bluer, and no beat has none of that', () => {
  const stable = colorsOf('stable', limits, theme);
  assert.equal(hex(stable(1)), theme.surface);
  assert.notEqual(hex(stable(0)), theme.surface);
  const beat = colorsOf('frequency', limits, theme);
  const blueness = [40, 45, 50, 55, 60].map((frequency) => beat(frequency)[2] - beat(frequency)[0]);
  assert.deepEqual(blueness, [...blueness].sort((one, other) => one - other));
  assert.equal(hex(beat(0)), theme.raised);
});

test('the hatch covers what is unstable and nothing else, at 45°', () => {
  const rateAt = (/** @type {number} */ x, /** @type {number} */ y) => growthRates({ x: { parameter: 'velocity', from: valueX(x), to: valueX(x) }, y: { parameter: 'dampingConstant', from: valueY(y), to: valueY(y) }, columns: 1, rows: 1 })[0];
  let length = 0;
  for (let i = 0; i < sheet.hatch.length; i += 4) {
    const [x1, y1, x2, y2] = sheet.hatch.subarray(i, i + 4);
    assert.ok(Math.abs(x2 - x1 - (y1 - y2)) < 1e-3);
    length += Math.hypot(x2 - x1, y2 - y1);
    // Ends of the pieces lie on the boundary or beside it; their middles are within.
    assert.ok(rateAt((x1 + x2) / 2, (y1 + y2) / 2) > -0.15, `${valueX(x1)} ${valueY(y1)}`);
    assert.ok(rateAt(x1, y1) > -0.3 && rateAt(x2, y2) > -0.3);
  }
  const unstable = rates.filter((rate) => rate > 0).length / rates.length;
  // Lines 8 px apart along an axis cover an area at 8/√2 px from line to line.
  const covered = (length * 8) / Math.SQRT2 / ((frame.right - frame.left) * (frame.bottom - frame.top));
  assert.ok(Math.abs(covered - unstable) < 0.01, `${covered} of ${unstable}`);
  assert.equal(hatchOf(frame, () => false, theme).length, 0);
});

test('the boundary passes the published critical speeds, solid for Hopf and broken for divergence', () => {
  const { context, named } = recordingContext();
  drawStabilityMap(context, size, shown, theme, voice);
  const drawn = named('moveTo', 'lineTo').filter(({ style }) => style.strokeStyle === theme.unstable && style.lineWidth === 2.5);
  assert.equal(drawn.length, criticalSpeeds.length);
  criticalSpeeds.forEach(([damping, speed], i) => {
    const [x, y] = drawn[i].at(drawn[i].args[0], drawn[i].args[1]);
    assert.ok(Math.abs(x - (frame.left + ((speed - 0.5) / 99.5) * (frame.right - frame.left))) < 0.01);
    assert.ok(Math.abs(y - (frame.bottom - (damping / 100) * (frame.bottom - frame.top))) < 0.01);
    assert.deepEqual(drawn[i].style.dash, []);
  });
  const other = recordingContext();
  drawStabilityMap(other.context, size, { ...shown, boundary: [{ ...boundary[0], kind: 'divergence' }] }, theme, voice);
  assert.ok(other.named('stroke').some(({ style }) => style.strokeStyle === theme.unstable && style.lineWidth === 2.5 && style.dash.length > 0));
  const within = recordingContext();
  drawStabilityMap(within.context, size, { ...shown, boundary: [{ ...boundary[0], bounds: false }] }, theme, voice);
  assert.ok(within.named('stroke').every(({ style }) => style.strokeStyle !== theme.unstable || style.lineWidth < 2.5), 'where nothing becomes stable the line is thin');
  const around = recordingContext();
  drawStabilityMap(around.context, size, { ...shown, boundary: [{ ...boundary[0], closed: true }] }, theme, voice);
  const closed = (/** @type {typeof around} */ { named: of }) => of('closePath').filter(({ style }) => style.strokeStyle === theme.unstable && style.lineWidth === 2.5).length;
  assert.deepEqual([closed(around), closed(within)], [1, 0], 'a region within the plane is gone around');
});

test('the map’s image fills the frame, and words stand in their own regions', () => {
  const { context, named } = recordingContext();
  drawStabilityMap(context, size, shown, theme, voice);
  assert.deepEqual(named('drawImage')[0].args, [image, frame.left, frame.top, frame.right - frame.left, frame.bottom - frame.top]);
  for (const word of ['dies out', 'shimmies']) {
    const place = named('fillText').find(({ args }) => args[0] === word);
    assert.ok(place);
    const column = Math.floor(((place.args[1] - frame.left) / (frame.right - frame.left)) * columns);
    const row = Math.floor(((frame.bottom - place.args[2]) / (frame.bottom - frame.top)) * rows);
    assert.equal(map.stable[row * columns + column], word === 'dies out' ? 1 : 0, word);
  }
  assert.ok(!written(named('fillText')).includes('turns aside'));
  const kind = Uint8Array.from(rates, () => 0);
  const aside = sheetOf(recordingContext().context, frame, { ...map, kind }, look, theme, voice).words.map(({ text }) => text);
  assert.deepEqual(aside, ['dies out', 'turns aside'], 'where the leading root does not swing');
});

test('a word finds the roomiest place of its region, or none', () => {
  const box = { left: 0, right: 400, top: 0, bottom: 200 };
  // A region to the right, and one too thin for any word.
  const regionAt = (/** @type {number} */ across) => (across > 0.5 ? 'right' : across < 0.02 ? 'thin' : 'left');
  const places = roomiest(box, regionAt, { left: { width: 80, height: 20 }, right: { width: 80, height: 20 }, thin: { width: 80, height: 20 } });
  assert.ok(places.right.x - 40 >= 200 && places.right.x + 40 <= 400 && places.right.y > 10 && places.right.y < 190);
  assert.ok(places.left.x - 40 >= 0 && places.left.x + 40 <= 210);
  assert.equal(places.thin, undefined);
});

test('a phrase too wide for its region is broken, and a word under the gear goes elsewhere', () => {
  const phrase = 'linear theory, inside the gap: unstable';
  const placed = (/** @type {number} */ width) => {
    const box = { left: 0, right: width, top: 0, bottom: 240 };
    const { context } = recordingContext();
    return sheetOf(context, box, map, { coloring: 'growthRate', limits, words: { stable: 'stable', hopf: phrase, divergence: '' } }, theme, voice).words.find(({ text }) => text.includes('unstable'));
  };
  assert.equal(placed(2000)?.text, phrase);
  assert.equal(placed(300)?.text, 'linear theory,\ninside the gap:\nunstable');
  const { context, named } = recordingContext();
  drawStabilityMap(context, size, shown, theme, voice);
  const [, x, y] = named('fillText').find(({ args }) => args[0] === 'shimmies')?.args ?? [];
  const over = recordingContext();
  const values = placesOfMap(frame, shown.x, shown.y);
  drawStabilityMap(over.context, size, { ...shown, point: { x: values.valueX(x), y: values.valueY(y) } }, theme, voice);
  const [, otherX, otherY] = over.named('fillText').find(({ args }) => args[0] === 'shimmies')?.args ?? [];
  assert.ok(Math.abs(otherX - x) > 20 || Math.abs(otherY - y) > 15, `${otherX} ${otherY}`);
});

test('however narrow the picture, its colors are explained', () => {
  for (const [width, em] of [[600, 13], [240, 13], [262, 17]])
    for (const [coloring, told] of /** @type {const} */ ([['growthRate', ['−40', '+40 s⁻¹']], ['stable', ['stable', 'unstable']], ['frequency', ['40', '60 Hz']]])) {
      const { context, named } = recordingContext();
      const narrow = { ...theme, size: em };
      drawStabilityMap(context, { width, height: 320 }, { ...shown, coloring, sheet: null, boundary: [], readings: [] }, narrow, voice);
      const { bottom } = frameOfMap({ width, height: 320 }, narrow);
      const beneath = named('fillText').filter(({ args }) => args[2] > bottom + 2 * em).map(({ args }) => args[0]);
      assert.ok(told.every((text) => beneath.includes(text)), `${coloring} at ${width} px: ${beneath}`);
    }
});

test('where freeplay is an axis, its closed edge is marked', () => {
  const gap = { parameter: 'freeplayAngle', from: 0, to: 0.1, quantity: quantity('freeplayAngle', 'psi_fp', 'rad') };
  const { context, named } = recordingContext();
  drawStabilityMap(context, size, { ...shown, x: gap, boundary: [], engaged: 'spring engaged' }, theme, voice);
  const edge = named('lineTo').filter(({ style }) => style.strokeStyle === theme.freeplayText);
  assert.deepEqual(edge.map(({ args }) => args), [[frame.left, frame.top]]);
  assert.ok(written(named('fillText')).includes('spring engaged'));
});

test('lines of one value lie on it, closed where they close, with their numbers', () => {
  const [across, up] = [80, 60];
  const values = Float64Array.from({ length: across * up }, (_, i) => Math.hypot(((i % across) + 0.5) / across - 0.5, (Math.floor(i / across) + 0.5) / up - 0.5));
  const [[ring, ...others], corners] = isoLinesOf({ values, columns: across, rows: up }, [0.3, 0.6]);
  assert.equal(others.length, 0);
  assert.equal(ring.across[0], ring.across.at(-1));
  ring.across.forEach((x, i) => assert.ok(Math.abs(Math.hypot(x - 0.5, ring.up[i] - 0.5) - 0.3) < 2e-3));
  assert.equal(corners.length, 4);
  const [saddle] = isoLinesOf({ values: [1, 0, 0, 1], columns: 2, rows: 2 }, [0.4]);
  assert.equal(saddle.length, 2);
  // The middle is above the level, so the two high corners are one region: each line cuts off a low one.
  for (const { across: x, up: y } of saddle) assert.ok((x[0] + x[1]) / 2 > 0.5 !== (y[0] + y[1]) / 2 > 0.5);
  assert.deepEqual(isoLinesOf({ values: [1, NaN, 0, 1], columns: 2, rows: 2 }, [0.4]), [[]]);
  assert.ok(sheet.numbers.some(({ text }) => text === '+10') && sheet.numbers.some(({ text }) => text === '−10'));
  assert.ok(!sheet.numbers.some(({ text }) => text === '0'), 'the boundary is drawn from its own source');
});

test('on fine cells lines lie where they lie on coarse ones', () => {
  const fine = { columns: 2 * columns, rows: 2 * rows };
  const fineRates = growthRates({ ...dampingOverVelocity, ...fine });
  const { lines } = sheetOf(recordingContext().context, frame, { ...fine, stable: Uint8Array.from(fineRates, (rate) => (rate < 0 ? 1 : 0)), growthRate: fineRates, frequency: null, kind: null }, look, theme, voice);
  assert.ok(lines.length > 3 && lines.length === sheet.lines.length);
  lines.forEach(({ x, y }, i) => {
    const coarse = sheet.lines[i];
    // Made of every other value: of about as many points, which lie between those there, a cell of 3 px apart.
    assert.ok(Math.abs(x.length / coarse.x.length - 1) < 0.05, `${x.length} points for ${coarse.x.length}`);
    x.forEach((across, j) => assert.ok(coarse.x.some((one, k) => Math.hypot(across - one, y[j] - coarse.y[k]) < 3), `${across} ${y[j]}`));
  });
});

test('numbers of lines stand on the guides of the gear, and no line follows the edge of where nothing swings', () => {
  const { context, calls } = recordingContext();
  drawStabilityMap(context, size, shown, theme, voice);
  const guide = calls.findLastIndex(({ name, style }) => name === 'lineTo' && style.strokeStyle === theme.ink && style.dash.length > 0);
  assert.ok(calls.findIndex(({ name, args }) => name === 'fillText' && args[0] === '+10') > guide);
  const frequency = Float64Array.from({ length: columns * rows }, (_, i) => (i % columns < 8 ? 0 : 50));
  const { lines } = sheetOf(context, frame, { ...map, frequency }, { coloring: 'frequency', limits, words: { stable: '', hopf: '', divergence: '' } }, theme, voice);
  assert.equal(lines.length, 0);
});

test('the gear is a ring at its values with dotted lines to both axes; beyond the plane it waits at the edge', () => {
  const draw = (/** @type {{ x: number, y: number }} */ point) => {
    const { context, named } = recordingContext();
    drawStabilityMap(context, size, { ...shown, point }, theme, voice);
    return { ring: named('arc').at(-1)?.args.slice(0, 2), guides: named('lineTo').filter(({ style }) => style.strokeStyle === theme.ink && style.dash.length > 0).map(({ args }) => args), arrows: named('fill').filter(({ style }) => style.fillStyle === theme.ink).length };
  };
  const within = draw({ x: 80, y: 30 });
  assert.deepEqual(within.ring, [xAt(80), yAt(30)]);
  assert.deepEqual(within.guides, [[xAt(80), frame.bottom], [frame.left, yAt(30)]]);
  const beyond = draw({ x: 120, y: 30 });
  assert.deepEqual(beyond.ring, [frame.right, yAt(30)]);
  assert.equal(beyond.arrows, within.arrows + 1);
});

test('the legend tells what colors mean, in numbers or in words', () => {
  const legend = (/** @type {'growthRate' | 'stable' | 'frequency'} */ coloring) => {
    const { context, named } = recordingContext();
    drawMapLegend(context, { left: 0, right: 400, middle: 10 }, { coloring, limits }, theme, voice);
    return { words: written(named('fillText')), hatches: named('stroke').filter(({ style }) => style.strokeStyle === theme.unstable).length };
  };
  assert.deepEqual(legend('growthRate').words, ['−40', '+40 s⁻¹']);
  assert.deepEqual(legend('frequency').words, ['40', '60 Hz', 'no swing']);
  assert.deepEqual(legend('stable').words, ['stable', 'unstable']);
  assert.ok(legend('growthRate').hatches > 0 && legend('stable').hatches > 0 && legend('frequency').hatches === 0);
});

test('veiled, nothing of the map is drawn but where the gear is', () => {
  const { context, named } = recordingContext();
  drawStabilityMap(context, size, { ...shown, readings: ['v 80 m/s, c 30'], veiled: true }, theme, voice);
  assert.equal(named('drawImage').length, 0);
  assert.ok(named('stroke', 'fill').every(({ style }) => style.strokeStyle !== theme.unstable));
  const said = written(named('fillText'));
  assert.ok(said.includes('?') && !['dies out', 'shimmies', '+40 s⁻¹'].some((word) => said.includes(word)));
  assert.deepEqual(named('arc').at(-1)?.args.slice(0, 2), [xAt(80), yAt(30)]);
});

test('readings give way to shorter ones where there is little room', () => {
  const reading = (/** @type {number} */ width) => {
    const { context, named } = recordingContext();
    drawStabilityMap(context, { width, height: 320 }, { ...shown, readings: ['v 80 m/s, c 30: grows 8.6 s⁻¹, 53.8 Hz', 'grows 8.6 s⁻¹, 53.8 Hz'] }, theme, voice);
    return written(named('fillText')).find((text) => text.includes('grows'));
  };
  assert.equal(reading(600), 'v 80 m/s, c 30: grows 8.6 s⁻¹, 53.8 Hz');
  assert.equal(reading(340), 'grows 8.6 s⁻¹, 53.8 Hz');
});

test('numbers too long for the axis are told in thousands, with their unit', () => {
  const { context, named } = recordingContext();
  const stiffness = { parameter: 'torsionalStiffness', from: 0, to: 300_000, quantity: quantity('torsionalStiffness', 'k', 'N m/rad') };
  drawStabilityMap(context, size, { ...shown, y: stiffness, boundary: [], point: { x: 80, y: 100_000 } }, theme, voice);
  const said = written(named('fillText'));
  assert.ok(said.includes('300') && said.some((text) => text.endsWith(', kN m/rad')), said.join('|'));
  const [, y] = named('arc').at(-1)?.args ?? [];
  assert.ok(Math.abs(y - (frame.bottom - (frame.bottom - frame.top) / 3)) < 1e-6);
});
