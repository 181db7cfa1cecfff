// What a pen drew goes along in an address, as few numbers as draw the same line.

import { test } from 'node:test';
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import init, * as engine from '../../www/pkg/shimmy.js';
import { App } from '../../www/app.js';
import { mostStrokes, penPairs, strokeOf } from '../../www/link/pen.js';

await init({ module_or_path: await readFile(new URL('../../www/pkg/shimmy_bg.wasm', import.meta.url)) });

/** @param {number} count */
const circle = (count) => Array.from({ length: count }, (_, i) => ({
  x: 0.5 + 0.2 * Math.cos((2 * Math.PI * i) / count), y: 0.5 + 0.2 * Math.sin((2 * Math.PI * i) / count), pressure: 0.5,
}));

/** How far a point is from a line of points. @param {{ x: number, y: number }} point @param {readonly { x: number, y: number }[]} line */
function distanceTo(point, line) {
  return Math.min(...line.slice(1).map((to, i) => {
    const from = line[i];
    const [dx, dy] = [to.x - from.x, to.y - from.y];
    const share = Math.min(1, Math.max(0, ((point.x - from.x) * dx + (point.y - from.y) * dy) / (dx * dx + dy * dy || 1)));
    return Math.hypot(point.x - from.x - share * dx, point.y - from.y - share * dy);
  }));
}

test('a stroke comes back within two pixels of a thousand, by few points', () => {
  for (const count of [2, 50, 2000]) {
    const points = circle(count);
    const [pair] = penPairs([{ view: 'gear', points }]);
    const read = strokeOf(pair.slice(4));
    assert.equal(read?.view, 'gear');
    assert.ok(read && pair.split(',').length - 1 <= Math.min(count, 60), pair);
    assert.ok(read.points.every(({ x, y }, i, all) => i === 0 || Math.hypot(x - all[i - 1].x, y - all[i - 1].y) < 0.0101), 'close together, as a pen sets them');
    for (const point of points) assert.ok(distanceTo(point, read.points) < 0.0025);
  }
});

test('a stylus keeps how hard it was pressed', () => {
  const points = [{ x: 0.1, y: 0.2, pressure: 0.8 }, { x: 0.3, y: 0.9, pressure: 0.25 }];
  assert.deepEqual(penPairs([{ view: 'phase.portrait', points }]), ['pen=phase.portrait,100.200.80,300.900.25']);
  const read = strokeOf('phase.portrait,100.200.80,300.900.25');
  assert.deepEqual([read?.view, read?.points[0], read?.points.at(-1)], ['phase.portrait', ...points]);
});

test('a closed line stays closed, a line may leave the view, and how hard it was pressed goes along it', () => {
  const loop = [...circle(100), circle(100)[0]];
  const read = strokeOf(penPairs([{ view: 'gear', points: loop }])[0].slice(4));
  for (const point of loop) assert.ok(read && distanceTo(point, read.points) < 0.0025);
  const beyond = [{ x: -0.02, y: 1.2, pressure: 0.2 }, { x: 0.18, y: -0.3, pressure: 0.8 }];
  const [pair] = penPairs([{ view: 'gear', points: beyond }]);
  assert.equal(pair, 'pen=gear,-20.1200.20,180.-300.80');
  const drawn = strokeOf(pair.slice(4))?.points ?? [];
  assert.deepEqual([drawn[0], drawn.at(-1)], beyond);
  const middle = drawn[Math.round(drawn.length / 2)];
  assert.ok(Math.abs(middle.pressure - 0.5) < 0.01 && Math.abs(middle.x - 0.08) < 0.01 && Math.abs(middle.y - 0.45) < 0.01);
});

test('of more strokes than an address carries the latest go along', () => {
  const strokes = Array.from({ length: mostStrokes + 3 }, (_, i) => ({ view: 'gear', points: [{ x: i / 1000, y: 0, pressure: 0.5 }] }));
  const pairs = penPairs(strokes);
  assert.deepEqual([pairs.length, pairs[0], pairs.at(-1)], [mostStrokes, 'pen=gear,3.0', `pen=gear,${mostStrokes + 2}.0`]);
});

test('a scribble is drawn by fewer points rather than fill the address', () => {
  const scribble = Array.from({ length: 5000 }, (_, i) => ({ x: 0.5 + 0.4 * Math.sin(i * 1.7), y: 0.5 + 0.4 * Math.cos(i * 2.3), pressure: 0.5 }));
  const [pair] = penPairs([{ view: 'gear', points: scribble }]);
  assert.ok(pair.length < 160 * 9);
  assert.ok(strokeOf(pair.slice(4)));
});

test('what is no stroke is none', () => {
  for (const text of ['', 'gear', 'gear,', 'gear,1', 'gear,a.b', 'gear,1.2.300', 'gear,1.2.3.4', 'ge ar,1.2', `${'g'.repeat(41)},1.2`, `gear${',1.2'.repeat(500)}`])
    assert.equal(strokeOf(text), null, text.slice(0, 30));
});

test('the page opens a link with what was drawn on it, and writes the same again', () => {
  const link = '#shimmy=2&initial.torsionAngle=0.05&pen=gear,100.100,200.150&pen=phase,300.300';
  const app = new App();
  app.open(engine, [link], { isStill: true });
  assert.deepEqual(app.ink.strokes.map(({ view, points }) => [view, points.length]), [['gear', 13], ['phase', 1]]);
  app.ink.elapse(0, true);
  app.ink.elapse(60, true);
  assert.equal(app.ink.strokes.length, 2, 'it stays though the run goes on');
  assert.deepEqual(app.link.match(/pen=[^&]*/g), ['pen=gear,100.100,200.150', 'pen=phase,300.300']);
  app.openLink('#shimmy=2&initial.torsionAngle=0.05');
  assert.equal(app.ink.strokes.length, 0, 'and goes with the next link');
});

test('a damaged stroke is listed, and so is one too many', () => {
  const app = new App();
  app.open(engine, [`#shimmy=2&initial.torsionAngle=0.05&pen=nonsense${'&pen=gear,1.1'.repeat(mostStrokes + 1)}`], { isStill: true });
  assert.equal(app.ink.strokes.length, mostStrokes);
  assert.match(app.notes[0].text, /pen = nonsense \(not understood\).*pen = gear,1\.1 \(not allowed\)/);
});

test('ink that fades is not in the link', () => {
  const app = new App();
  app.open(engine, ['#shimmy=2&initial.torsionAngle=0.05'], { isStill: true });
  app.run('penStroke', { view: 'gear', points: [{ x: 0.1, y: 0.1, pressure: 0.5 }] });
  assert.match(app.link, /pen=gear,100\.100/);
  app.ink.elapse(0, true);
  app.ink.elapse(0.5, true);
  assert.doesNotMatch(app.link, /pen=/);
});
