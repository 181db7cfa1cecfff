// Planes side by side: which they are, as typed, in a link and in the thesis; their shares in slices; picture, table and file.

import { test } from 'node:test';
import assert from 'node:assert/strict';
import { Quantity } from '../../www/controls/quantity.js';
import { besideOf, mostPlanes, planesOf, readBeside, readyBesides, writeBeside } from '../../www/lens/stability/beside-settings.js';
import { readTyped } from '../../www/lens/stability/beside-typed.js';
import { sorted } from '../../www/lens/stability/figures-table.js';
import { PlanesBeside } from '../../www/lens/stability/planes-beside.js';
import { csvOf } from '../../www/out/csv.js';
import { tableCsv } from '../../www/out/table-csv.js';
import { drawPlanesBeside, layBeside, layGrid, widthOfEnds } from '../../www/view/planes-beside.js';
import { linearLooks } from '../../www/run/linear-looks.js';
import { parseList } from '../../www/words/list.js';
import { voiceOf } from '../../www/words/voice.js';
import { cubicOf, usual } from './linear-gear.mjs';
import { recordingContext, written } from './plot-recorder.mjs';
import { engine, openedApp } from './stories.mjs';
import { theme } from './theme.mjs';

const { parameters } = /** @type {import('../../www/engine/engine.js').Model} */ (engine.models().find(({ name }) => name === 'torsional'));

test('lists are read as people type them, in either language', () => {
  const numbers = (/** @type {string} */ text) => parseList(text).values;
  assert.deepEqual(numbers('0.09, 0.095, 0.105'), [0.09, 0.095, 0.105]);
  assert.deepEqual(numbers('0,09; 0,095; 0,105'), [0.09, 0.095, 0.105]);
  assert.deepEqual(numbers('0,02 0,07 0.12'), [0.02, 0.07, 0.12]);
  assert.deepEqual(numbers('100 000, 50 000, 0'), [100000, 50000, 0]);
  assert.deepEqual(numbers('100\u202f000; 0'), [100000, 0]);
  assert.deepEqual(numbers('0.02,0.07,0.12'), [0.02, 0.07, 0.12]);
  assert.deepEqual(numbers('  5;;10 ; '), [5, 10]);
  assert.deepEqual(parseList('5; ten; 15'), { values: [], stranger: 'ten' });
  assert.deepEqual(parseList(''), { values: [], stranger: null });
});

test('a comparison is written and read the same; what is none is refused', () => {
  for (const { text } of readyBesides) assert.equal(writeBeside(/** @type {NonNullable<ReturnType<typeof readBeside>>} */ (readBeside(text, parameters))), text);
  const plane = 'velocity:0.5:100,dampingConstant:0:100';
  for (const text of ['', plane, `${plane},velocity:1:2`, `${plane},relaxationLength`, `${plane},relaxationLength:0.1:x`, `${plane},speed:1:2`,
    `${plane},relaxationLength:0.1:`, 'velocity:0.5:100,velocity:0:100,relaxationLength:1', `${plane},relaxationLength:1,casterLength:0,halfContactLength:1`,
    `${plane},relaxationLength:${Array.from({ length: mostPlanes + 1 }, (_, i) => i).join(':')}`])
    assert.equal(readBeside(text, parameters), null, text);
  assert.equal(writeBeside(/** @type {NonNullable<ReturnType<typeof besideOf>>} */ (besideOf('nonsense', parameters))), readyBesides[0].text);
});

test('the comparisons of the thesis are there: so many planes, in the order of its figures', () => {
  const counts = Object.fromEntries(readyBesides.filter(({ table }) => table).map(({ table, text }) => [table, planesOf(/** @type {NonNullable<ReturnType<typeof readBeside>>} */ (readBeside(text, parameters))).length]));
  // Figures 5.6–5.8, 5.9–5.15, 5.16–5.18; with the values of a as they are 5.19–5.30, of e 5.31–5.58.
  assert.deepEqual(counts, { 5.2: 3, 5.3: 7, 5.4: 3, 5.5: 12, 5.6: 28 });
  for (const entry of engine.atlas().filter(({ view }) => view === 'stability-map')) {
    const wanted = Object.entries(/** @type {NonNullable<typeof entry.map>} */ (entry.map).parameters);
    const isThere = readyBesides.some(({ text }) => {
      const beside = /** @type {NonNullable<ReturnType<typeof readBeside>>} */ (readBeside(text, parameters));
      return beside.y.parameter === entry.map?.y.parameter && planesOf(beside).some((values) => wanted.every(([name, value]) => (values[name] ?? usual[/** @type {keyof typeof usual} */ (name)]) === value));
    });
    assert.ok(isThere, entry.id);
  }
});

test('a list that makes no comparison is refused with the reason, in the language of the page', () => {
  const beside = /** @type {NonNullable<ReturnType<typeof readBeside>>} */ (readBeside(readyBesides[1].text, parameters));
  const quantity = new Quantity(/** @type {typeof parameters[number]} */ (parameters.find(({ name }) => name === 'relaxationLength')));
  const compute = (/** @type {Record<string, number>} */ values) => engine.eigenvalues({ model: 'torsional', parameters: values });
  const typed = (/** @type {string} */ text, /** @type {'en' | 'tr'} */ language = 'en') => readTyped(text, { beside, at: 0, quantity }, compute, voiceOf(language));
  const read = typed('0,1; 0.2; 0,1');
  assert.ok(typeof read !== 'string');
  assert.deepEqual(read.lists, [{ parameter: 'relaxationLength', values: [0.1, 0.2] }]);
  const why = { ten: /“ten” is not a number/, '': /no number in it/, [Array.from({ length: 37 }, (_, i) => i + 1).join(' ')]: /more than 36 planes/, '0.1; -1': /must be above 0 m/ };
  for (const [text, reason] of Object.entries(why)) assert.match(String(typed(text)), reason);
  // Beyond all numbers, and beyond what the engine computes with: neither is a lower limit.
  for (const text of ['1e400', '0.1; 1e20', '-1e400']) {
    assert.match(String(typed(text)), /^One of these values is too large/, text);
    assert.match(String(typed(text, 'tr')), /^Bu değerlerden biri hesaplanamayacak kadar büyük/, text);
  }
});

const sigmas = /** @type {NonNullable<ReturnType<typeof readBeside>>} */ (readBeside(readyBesides[1].text, parameters));
const gear = (/** @type {Record<string, number>} */ values = {}) => {
  const all = { ...Object.fromEntries(parameters.map((one) => [one.name, one.default])), ...values };
  return { object: 'torsional', parameters: all, linear: linearLooks(engine, { model: 'torsional', parameters: all }) };
};

/** The stable part of the plane c over v, in per cent. @param {Record<string, number>} values */
function exactShare(values) {
  const [columns, rows] = [1500, 200];
  let covered = 0;
  for (let i = 0; i < columns; i++) {
    const margin = (/** @type {number} */ dampingConstant) => {
      const [a2, a1, a0] = cubicOf({ ...values, velocity: 0.5 + ((i + 0.5) / columns) * 99.5, dampingConstant });
      return Math.min(a2, a0) > 0 ? a2 * a1 - a0 : -1;
    };
    for (let j = 0; j < rows; j++) {
      const [below, above] = [margin((100 * j) / rows), margin((100 * (j + 1)) / rows)];
      covered += below > 0 && above > 0 ? 1 : below <= 0 && above <= 0 ? 0 : Math.max(below, above) / Math.abs(below - above);
    }
  }
  return (100 * covered) / (columns * rows);
}

test('shares agree with the closed form counted on a grid of our own', () => {
  const planes = new PlanesBeside();
  planes.look(gear(), sigmas);
  planes.advance(Infinity);
  const side = 300;
  for (const { values, share, boundary } of planes.items) {
    let stable = 0;
    for (let i = 0; i < side * side; i++) {
      const [a2, a1, a0] = cubicOf({ ...values, velocity: 0.5 + (((i % side) + 0.5) / side) * 99.5, dampingConstant: ((Math.floor(i / side) + 0.5) / side) * 100 });
      if (a2 > 0 && a0 > 0 && a2 * a1 > a0) stable++;
    }
    // The boundary cuts about 2 × 300 cells, whose error averages out: half a cell for each of their square root.
    assert.ok(Math.abs(Number(share) - (100 * stable) / side ** 2) < 0.05, `${JSON.stringify(values)}: ${share}`);
    // The share is that of the exact boundary, not of cells: in each column the stable part is found to where a₂a₁ = a₀.
    assert.ok(Math.abs(Number(share) - exactShare(values)) < 2e-3, `${JSON.stringify(values)}: ${share} for ${exactShare(values)}`);
    assert.ok(boundary.length > 0);
    for (const { x, y } of boundary) x.forEach((velocity, i) => {
      const [a2, a1, a0] = cubicOf({ ...values, velocity, dampingConstant: y[i] });
      assert.ok(Math.abs(a2 * a1 / a0 - 1) < 1e-3, `${velocity} ${y[i]}`);
    });
  }
});

test('planes are computed in slices; those of before stay, old, until they are', () => {
  const planes = new PlanesBeside();
  let clock = 0;
  const now = () => (clock += 4);
  planes.look(gear(), sigmas);
  assert.ok(planes.items.every(({ map, isOld }) => map === null && isOld));
  let frames = 0;
  while (!planes.isDone) {
    const before = planes.items.filter(({ isOld }) => !isOld).length;
    planes.advance(6, now);
    assert.ok(planes.items.filter(({ isOld }) => !isOld).length <= before + 3, 'a slice ends in time');
    frames++;
  }
  assert.ok(frames >= 3);
  const [first] = planes.items;
  planes.look(gear(), sigmas);
  assert.equal(planes.items[0], first, 'nothing is done twice');
  planes.look(gear({ velocity: 33, dampingConstant: 7, relaxationLength: 0.2 }), sigmas);
  assert.equal(planes.items[0], first, 'what the planes vary does not matter');
  planes.look(gear({ momentOfInertia: 2 }), sigmas);
  assert.ok(planes.items.every(({ isOld, map }) => isOld && map));
  planes.advance(Infinity);
  assert.notEqual(planes.items[0].share, first.share);
  planes.look(gear({ verticalForce: 1e300 }), sigmas);
  planes.advance(Infinity);
  assert.ok(planes.items.every(({ share, map }) => share === null && map === null), 'too wild to be computed with');
});

test('planes fill rows without crossing each other or the picture, at any width', () => {
  for (const width of [358, 440, 604, 1200]) for (const count of [1, 3, 7, 12, 28, 36]) for (const isTall of [false, true]) {
    const { height, boxes, plots, top } = layBeside(width, count, theme, { isTall });
    assert.equal(boxes.length, count);
    for (const [i, box] of boxes.entries()) {
      assert.ok(box.left >= 0 && box.right <= width && box.top >= top && box.bottom <= height);
      assert.ok(plots[i].bottom - plots[i].top > 60 && plots[i].top > box.top);
      for (const other of boxes.slice(0, i)) assert.ok(other.right <= box.left || other.left >= box.right || other.bottom <= box.top || other.top >= box.bottom);
    }
  }
});

test('long numbers at the upward axis are drawn whole', () => {
  const y = { parameter: 'torsionalStiffness', from: 0, to: 1e5 };
  for (const width of [358, 604]) {
    const { context, named } = recordingContext();
    const ends = { x: ['0.5', '100'], y: ['0', '100\u202f000'] };
    const layout = layBeside(width, 3, theme, { isTall: true, ends: widthOfEnds(context, ends.y, theme) });
    const plane = { image: null, hatch: null, boundary: [], label: [], share: '', isOld: false, isNow: false };
    drawPlanesBeside(context, { width, height: layout.height }, { x: sigmas.x, y, ends, ranges: [''], point: { x: 50, y: 0 }, planes: [plane, plane, plane] }, layout, theme);
    const end = named('fillText').find(({ args }) => args[0] === ends.y[1]);
    assert.ok(end && end.args[1] >= 0, `it begins at ${end?.args[1]} px of ${width}`);
    assert.ok(layout.boxes.every(({ right }) => right < width));
  }
});

test('each plane is drawn with its name, its share and its boundary; the gear stands in its own', () => {
  const { context, named } = recordingContext();
  const layout = layBeside(604, 2, theme, { isTall: false });
  const boundary = [{ x: Float64Array.of(20, 100), y: Float64Array.of(0, 50), frequency: Float64Array.of(50, 50), kind: /** @type {const} */ ('hopf'), closed: false, bounds: true }];
  const plane = { image: null, hatch: Float32Array.of(1, 9, 9, 1), boundary, isOld: false };
  drawPlanesBeside(context, { width: 604, height: layout.height }, {
    ...sigmas, ends: { x: ['0.5', '100'], y: ['0', '99'] }, ranges: ['a text far too long for any picture '.repeat(9), 'v 0.5 … 100 m/s'], point: { x: 50.25, y: 25 },
    planes: [{ ...plane, label: [{ symbol: 'σ' }, { text: ' 0.02 m' }], share: '90.39 %', isNow: false }, { ...plane, label: [{ symbol: 'σ' }, { text: ' 0.3 m' }], share: '68.31 %', isNow: true }],
  }, layout, theme);
  const words = written(named('fillText'));
  for (const word of ['v 0.5 … 100 m/s', ' 0.02 m', '90.39 %', ' 0.3 m', '68.31 %', '0.5', '100', '0', '99']) assert.ok(words.includes(word), word);
  const [, plot] = layout.plots;
  const ring = named('arc').at(-1);
  assert.ok(Math.abs(ring?.args[0] - (plot.left + plot.right) / 2) < 0.01 && Math.abs(ring?.args[1] - (plot.bottom - (plot.bottom - plot.top) / 4)) < 0.01);
  assert.equal(named('arc').length, 2, 'the ring, with its edge, in one plane alone');
  const starts = named('moveTo').filter(({ style }) => style.strokeStyle === theme.unstable && style.lineWidth === 2.5);
  assert.equal(starts.length, 2);
  assert.ok(Math.abs(starts[0].args[0] - (layout.plots[0].left + (19.5 / 99.5) * (layout.plots[0].right - layout.plots[0].left))) < 0.01);
});

test('a plane of before is pale altogether, its hatch too', () => {
  const hatchOf = (/** @type {boolean} */ isOld) => {
    const { context, named } = recordingContext();
    const layout = layBeside(604, 1, theme, { isTall: false });
    const plane = { image: null, hatch: Float32Array.of(1, 9, 9, 1), boundary: [], label: [], share: '', isOld, isNow: false };
    drawPlanesBeside(context, { width: 604, height: layout.height }, { ...sigmas, ends: { x: ['', ''], y: ['', ''] }, ranges: [''], point: { x: 0, y: 0 }, planes: [plane] }, layout, theme);
    return named('stroke')[0].style;
  };
  assert.equal(hatchOf(true).strokeStyle, theme.unstable);
  assert.ok(Math.abs(hatchOf(true).globalAlpha - 0.4 * hatchOf(false).globalAlpha) < 1e-12);
});

test('two lists lie as rows and columns with their values at the heads, to be scrolled where there is no room', () => {
  for (const [width, first, second, isTurned] of /** @type {[number, number, number, boolean][]} */ ([[358, 4, 3, false], [358, 4, 7, true], [604, 4, 7, true], [1200, 4, 7, false]])) {
    const layout = layGrid(width, [first, second], theme, { heads: [70, 130], ends: 20 });
    assert.equal(layout.grid?.isTurned, isTurned, `${width}`);
    assert.ok(layout.boxes.every(({ left, right, bottom }) => left > 0 && right < layout.width && bottom < layout.height));
    layout.boxes.forEach((box, i) => {
      const [ofFirst, ofSecond] = [layout.boxes[i - (i % second)], layout.boxes[i % second]];
      assert.equal(box.left, (isTurned ? ofFirst : ofSecond).left, 'a column');
      assert.equal(box.top, (isTurned ? ofSecond : ofFirst).top, 'a row');
    });
    assert.equal(new Set(layout.boxes.map(({ left, top }) => `${left} ${top}`)).size, first * second);
    assert.ok(layout.plots[0].right - layout.plots[0].left >= (isTurned ? 70 : 130), 'as wide as its head');
    assert.ok(layout.boxes[0].left >= (isTurned ? 130 : 70), 'beside its head');
  }
  assert.ok(layGrid(604, [4, 7], theme, { heads: [70, 70], ends: 20 }).width <= 604, 'seven values go down, not beyond the edge');
  for (const isTurned of [false, true]) {
    const { context, named } = recordingContext();
    const layout = isTurned ? layGrid(200, [2, 3], theme, { heads: [60, 60], ends: 20 }) : layGrid(604, [2, 3], theme, { heads: [60, 60], ends: 20 });
    assert.equal(layout.grid?.isTurned, isTurned);
    const plane = { image: null, hatch: null, boundary: [], label: [], isOld: false, isNow: false };
    drawPlanesBeside(context, { width: layout.width, height: layout.height }, {
      ...sigmas, ends: { x: ['0.5', '100'], y: ['0', '99'] }, ranges: ['v, c'], point: { x: 50, y: 25 },
      planes: ['10 %', '20 %', '30 %', '40 %', '50 %', '60 %'].map((share) => ({ ...plane, share })),
      heads: [[[{ text: 'e 0.09' }], [{ text: 'e 0.11' }]], [[{ text: 's 0.02' }], [{ text: 's 0.07' }], [{ text: 's 0.12' }]]],
    }, layout, theme);
    const at = (/** @type {string} */ word) => /** @type {[string, number, number]} */ (named('fillText').find(({ args }) => args[0] === word)?.args);
    // The second value of each list: its plane is the fourth of the first list, and the second of the second.
    const [down, across] = isTurned ? [{ word: 's 0.07', plane: 1 }, { word: 'e 0.11', plane: 3 }] : [{ word: 'e 0.11', plane: 3 }, { word: 's 0.07', plane: 1 }];
    assert.ok(at(down.word)[1] < layout.plots[0].left && at(down.word)[2] > layout.plots[down.plane].top && at(down.word)[2] < layout.plots[down.plane].bottom);
    assert.ok(at(across.word)[1] > layout.boxes[across.plane].left && at(across.word)[1] < layout.boxes[across.plane].right && at(across.word)[2] <= layout.boxes[across.plane].top);
  }
});

test('a table is sorted upward and downward, what is not known last, and as it was', () => {
  const rows = [{ k: 2, share: 50 }, { k: 1, share: null }, { k: 3, share: 20 }];
  const columns = [
    { name: 'k', title: 'k', value: (/** @type {typeof rows[number]} */ { k }) => k, show: String },
    { name: 'share', title: '%', value: (/** @type {typeof rows[number]} */ { share }) => share, show: String },
  ];
  const order = (/** @type {string} */ sorting) => sorted(rows, columns, sorting).map(({ k }) => k);
  assert.deepEqual(order(''), [2, 1, 3]);
  assert.deepEqual(order('k,up'), [1, 2, 3]);
  assert.deepEqual(order('share,up'), [3, 2, 1]);
  assert.deepEqual(order('share,down'), [2, 3, 1]);
  assert.deepEqual(order('other,down'), [2, 1, 3]);
});

test('a table as a file has its units in the header and empty fields for what is not known', () => {
  assert.equal(tableCsv([{ name: 'relaxationLength', unit: 'm' }, { name: 'stableShare', unit: '%' }, { name: 'a "b", c', unit: '' }], [[0.02, 90.5, 'x'], [0.07, null, 'y,z']]),
    'relaxationLength (m),stableShare (%),"a ""b"", c"\r\n0.02,90.5,x\r\n0.07,,"y,z"\r\n');
  assert.equal(csvOf({ time: [0, 0.5] }, { state: [] }), 'time (s)\r\n0\r\n0.5\r\n');
});

test('a link brings back what is seen beside the plane; what is wrong in it is told', () => {
  const views = {
    stability: 'beside', beside: 'velocity:0.5:100,dampingConstant:0:100,relaxationLength:0.05:0.2', besideSort: 'share,down', mode: 'real-1',
    histories: 'lateralDeformation,0.5', casesSort: 'none',
  };
  const app = openedApp(`#shimmy=2&velocity=80&initial.torsionAngle=0.05&lens=stability&${Object.entries(views).map(([of, shows]) => `view.${of}=${shows}`).join('&')}`);
  assert.deepEqual([app.notes, app.state.views], [[], views]);
  assert.deepEqual(openedApp(app.link).state.views, views);
  const wrong = { beside: 'velocity:0.5:100,dampingConstant:0:100', besideSort: 'share', mode: 'pair-0', histories: 'torsionAngle,3', casesSort: 'up' };
  for (const [of, shows] of Object.entries(wrong)) {
    const lost = openedApp(`#shimmy=2&velocity=80&initial.torsionAngle=0.05&view.${of}=${shows}`);
    assert.equal(lost.state.views[of], undefined, of);
    assert.match(lost.notes[0].text, new RegExp(`view.${of}`));
  }
  const refused = openedApp('#shimmy=2&velocity=80&initial.torsionAngle=0.05&view.beside=velocity:0.5:100,dampingConstant:0:100,relaxationLength:0.1:-1');
  assert.equal(refused.state.views.beside, undefined, 'no gear has a relaxation length below 0');
});
