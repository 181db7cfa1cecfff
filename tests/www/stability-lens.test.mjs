// What the lens Stability keeps, computes, and asks of the gear.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { PlaneMap } from '../../www/lens/stability/plane-map.js';
import { locusOf, planeOf, readLocus, readPlane, thesisLocus, writeLocus, writePlane } from '../../www/lens/stability/settings.js';
import { readLink } from '../../www/link/read.js';
import { viewsOf } from '../../www/out/views.js';
import { linksBrokenByPoint } from '../../www/run/links.js';
import { voiceOf } from '../../www/words/voice.js';
import { usual } from './linear-gear.mjs';

const parameters = [
  { name: 'velocity', min: 1, max: 120, default: 50 }, { name: 'dampingConstant', min: 0, max: 200, default: 10 },
  { name: 'casterLength', min: -0.5, max: 0.5, default: 0.1 }, { name: 'relaxationLength', min: 0.02, max: 1, default: 0.3 },
];

test('a plane is readable text and comes back from it; without one it is the thesis’ c over v', () => {
  const text = 'velocity:0.5:100,casterLength:-0.25:0.5,frequency';
  assert.equal(writePlane(planeOf(text, parameters)), text);
  assert.equal(writePlane(planeOf('', parameters)), 'velocity:0.5:100,dampingConstant:0:100,growthRate');
  for (const wrong of ['velocity:0.5:100', 'velocity:0.5:100,dampingConstant:0:100,rainbow', 'velocity:100:0.5,dampingConstant:0:100,stable', 'velocity:0:1,velocity:0:1,stable',
    'velocity:0.5:x,dampingConstant:0:100,stable', 'mass:0:1,velocity:0.5:100,stable', 'velocity:0.5:100:3,dampingConstant:0:100,stable', 'velocity::100,dampingConstant:0:100,stable'])
    assert.equal(readPlane(wrong, parameters), null, wrong);
  const others = [{ name: 'r', min: 0, max: 30 }, { name: 's', min: 0, max: 5 }];
  assert.equal(writePlane(planeOf('', others)), 'r:0:30,s:0:5,growthRate', 'of another object its first two');
});

test('a locus is readable text, too; without one it is figure 5.5', () => {
  assert.equal(writeLocus(locusOf('dampingConstant:0:60', parameters)), 'dampingConstant:0:60');
  assert.equal(writeLocus(locusOf('', parameters)), thesisLocus);
  assert.deepEqual(locusOf('', parameters).family, { parameter: 'casterLength', from: 0, to: 0.5, count: 6 });
  for (const wrong of ['velocity:0.5:100,casterLength:0:0.5', 'velocity:0.5:100,casterLength:0:0.5:1', 'velocity:0.5:100,casterLength:0:0.5:2.5', 'velocity:0.5:100,velocity:0:0.5:6', 'velocity'])
    assert.equal(readLocus(wrong, parameters), null, wrong);
});

test('a link carries plane and locus, and says what of them it could not use', () => {
  const models = [{ name: 'torsional', parameters, state: [] }];
  const read = (/** @type {string} */ text) => readLink(`#shimmy=2&lens=stability&${text}`, models, ({ parameters: values }) => (values.velocity ?? 1) > 0);
  const good = read('view.stability=locus&view.plane=velocity:0.5:60,relaxationLength:0.02:1,stable&view.locus=velocity:1:50');
  assert.deepEqual(good?.problems, []);
  assert.equal(good?.state.lens, 'stability');
  assert.deepEqual(good?.state.views, { stability: 'locus', plane: 'velocity:0.5:60,relaxationLength:0.02:1,stable', locus: 'velocity:1:50' });
  assert.deepEqual(read('view.plane=speed:0:1,dampingConstant:0:1,stable')?.problems.map(({ key, reason }) => [key, reason]), [['view.plane', 'unclear']]);
  assert.deepEqual(read('view.stability=rooms')?.problems.map(({ key, reason }) => [key, reason]), [['view.stability', 'unclear']]);
  // The engine refuses a speed that is not above 0.
  const refused = read('view.plane=velocity:-5:60,dampingConstant:0:100,stable');
  assert.deepEqual(refused?.problems.map(({ key, reason }) => [key, reason]), [['view.plane', 'refused']]);
  assert.deepEqual(refused?.state.views, {});
  for (const ends of ['velocity:1:50,relaxationLength:0.02:1:3', 'relaxationLength:0.02:1,velocity:1:50:3']) assert.deepEqual(read(`view.locus=${ends}`)?.problems, [], ends);
  for (const ends of ['velocity:-1:50', 'relaxationLength:0.02:1,velocity:-1:50:3']) assert.deepEqual(read(`view.locus=${ends}`)?.problems.map(({ reason }) => reason), ['refused'], ends);
});

/** Stands for linear theory and counts what it is asked. */
function counting() {
  const asked = { maps: /** @type {number[]} */ ([]), boundaries: 0 };
  const linear = /** @type {import('../../www/run/linear-looks.js').LinearLooks} */ (/** @type {unknown} */ ({
    map: (/** @type {{ count: number }} */ x, /** @type {{ count: number }} */ y) => {
      asked.maps.push(x.count * y.count);
      const rates = Float64Array.from({ length: x.count * y.count }, (_, i) => (i % 80) - 40);
      return { stable: Uint8Array.from(rates, (rate) => (rate < 0 ? 1 : 0)), stablePercent: 50, stableArea: 50.5, growthRate: rates };
    },
    boundary: () => [asked.boundaries++].slice(1),
  }));
  return { asked, linear };
}

test('a map is computed coarse at once, fine when asked, and anew only where another value has changed', () => {
  const { asked, linear } = counting();
  const map = new PlaneMap();
  const plane = planeOf('', parameters);
  const [scales, others] = [{}, {}];
  const look = (/** @type {Record<string, number>} */ values, by = scales) => map.look({ object: 'torsional', parameters: { ...usual, ...values }, linear, scales: by }, plane);
  const first = look({});
  assert.deepEqual([first?.map.columns, first?.map.rows, first?.isCoarse, first?.share], [200, 150, true, 50.5]);
  assert.equal(look({ velocity: 12, dampingConstant: 34 }), first, 'the point’s own values do not change the plane');
  map.refine();
  const fine = look({});
  assert.deepEqual([fine?.map.columns, fine?.map.rows, fine?.isCoarse], [400, 300, false]);
  assert.equal(fine?.limits, first?.limits);
  const changed = look({ casterLength: 0.2 });
  assert.equal(changed?.isCoarse, true);
  assert.equal(changed?.limits, first?.limits, 'scales stay while a slider moves');
  assert.deepEqual(asked, { maps: [30_000, 120_000, 30_000], boundaries: 2 });
  assert.notEqual(look({ casterLength: 0.2 }, others)?.limits, first?.limits, '“Fit” chooses them anew');
  assert.ok((first?.limits.growthRate ?? 0) >= 35 && (first?.limits.growthRate ?? 0) <= 50);
});

test('the scale of frequencies holds nearly all there are, and not those of what does not swing', () => {
  const { linear } = counting();
  const beats = { ...linear, map: (/** @type {{ count: number }} */ x, /** @type {{ count: number }} */ y) => {
    const cells = { length: x.count * y.count };
    return { stable: new Uint8Array(cells.length), stablePercent: 0, stableArea: 0, frequency: Float64Array.from(cells, (_, i) => (i % 3 ? 41 + (i % 101) / 10 : 0)) };
  } };
  const looked = new PlaneMap().look({ object: 'torsional', parameters: usual, linear: /** @type {any} */ (beats), scales: {} }, planeOf('velocity:0.5:100,dampingConstant:0:100,frequency', parameters));
  const [from, to] = looked?.limits.frequency ?? [NaN, NaN];
  assert.ok(from >= 39 && from <= 41.5 && to >= 50.5 && to <= 53, `${from} … ${to} Hz of 41 … 51`);
});

test('values that cannot be computed with leave the plane empty, and it comes back', () => {
  const { linear } = counting();
  const map = new PlaneMap();
  const plane = planeOf('', parameters);
  const refusing = { ...linear, map: () => { throw new Error('no'); } };
  const scales = {};
  assert.equal(map.look({ object: 'torsional', parameters: { casterLength: 1e300 }, linear: refusing, scales }, plane), null);
  assert.ok(map.look({ object: 'torsional', parameters: { casterLength: 0.1 }, linear, scales }, plane));
});

test('a point parts what would follow its values, and no other links', () => {
  const links = { relaxationLength: true, treadWidthMomentConstant: true };
  assert.equal(linksBrokenByPoint({ velocity: 3, dampingConstant: 4 }, links), links);
  assert.deepEqual(linksBrokenByPoint({ halfContactLength: 0.09, velocity: 3 }, links), { relaxationLength: false, treadWidthMomentConstant: false });
  assert.deepEqual(linksBrokenByPoint({ relaxationLength: 0.2 }, links), { relaxationLength: false, treadWidthMomentConstant: true });
  assert.deepEqual(linksBrokenByPoint({ verticalForce: 5000 }, { relaxationLength: true, treadWidthMomentConstant: false }), { relaxationLength: true, treadWidthMomentConstant: false });
});

test('each picture of the lens can be taken along by its name', () => {
  const names = (/** @type {Record<string, string>} */ views) => viewsOf({ lens: 'stability', views }).map(({ name, title }) => [name, title(voiceOf('en'))]);
  assert.deepEqual(names({}).slice(2), [['plane', 'Stability plane'], ['roots', 'Roots'], ['history', 'Linear history']]);
  assert.deepEqual(names({ stability: 'roots' }).slice(2), [['roots', 'Roots'], ['history', 'Linear history']]);
  assert.deepEqual(names({ stability: 'locus' }).slice(2), [['locus', 'Root locus']]);
  assert.deepEqual(names({ stability: 'routh' }).slice(2), [], 'an array is no picture');
  /** @type {Record<string, string>[]} */
  const all = [{}, { stability: 'locus' }, { stability: 'modes' }, { stability: 'beside' }, { stability: 'histories' }];
  const elements = new Set(all.flatMap((views) => viewsOf({ lens: 'stability', views }).slice(2).map(({ element }) => element)));
  assert.equal(elements.size, 7, 'each is drawn on a canvas of its own');
});
