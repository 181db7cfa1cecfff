import { test } from 'node:test';
import assert from 'node:assert/strict';
import { balanceOf, energyWriter } from '../../www/view/energy-balance.js';
import { voiceOf } from '../../www/words/voice.js';

const sum = (/** @type {{ value: number }[]} */ parts) => parts.reduce((total, { value }) => total + value, 0);

test('a growing swing keeps what is not taken out', () => {
  const { trend, fed, taken, rest, whole } = balanceOf({ tire: 1596, damper: 1158, treadWidth: 195, stored: 243 });
  assert.equal(trend, 'grows');
  assert.deepEqual(fed, [{ element: 'tire', value: 1596 }]);
  assert.deepEqual(taken, [{ element: 'damper', value: 1158 }, { element: 'treadWidth', value: 195 }]);
  assert.deepEqual([rest, whole], [243, 1596]);
});

test('a swing whose energy hardly changes lasts, and leaves no rest', () => {
  for (const stored of [0, 0.1, -0.1]) {
    const { trend, rest } = balanceOf({ tire: 26 + stored, damper: 24.7, treadWidth: 1.3, stored });
    assert.deepEqual([trend, rest], ['lasts', 0]);
  }
  assert.equal(balanceOf({ tire: 26.2, damper: 24.7, treadWidth: 1.3, stored: 0.2 }).trend, 'grows');
});

test('a falling swing lacks on the side that feeds it', () => {
  const { trend, fed, taken, rest, whole } = balanceOf({ tire: 80, damper: 190, treadWidth: 18, stored: -128 });
  assert.equal(trend, 'falls');
  assert.deepEqual([sum(fed) + rest, sum(taken), whole], [208, 208, 208]);
});

test('a tire that takes energy stands with those who take, and both bars are still as long', () => {
  const { trend, fed, taken, rest, whole } = balanceOf({ tire: -12, damper: 90, treadWidth: 8, friction: 5, stored: -115 });
  assert.equal(trend, 'falls');
  assert.deepEqual(fed, []);
  assert.deepEqual(taken.map(({ element }) => element), ['tire', 'damper', 'treadWidth', 'friction']);
  assert.deepEqual([rest, sum(taken), whole], [115, 115, 115]);
});

test('whatever the flows, the shorter side and the rest make the longer', () => {
  for (let i = 0; i < 200; i++) {
    const [tire, damper, treadWidth, friction] = Array.from({ length: 4 }, () => (Math.random() - 0.3) * 10 ** (4 * Math.random()));
    const { trend, fed, taken, rest, whole } = balanceOf({ tire, damper, treadWidth, friction, stored: tire - damper - treadWidth - friction });
    const [long, short] = trend === 'grows' ? [sum(fed), sum(taken)] : [sum(taken), sum(fed)];
    if (trend !== 'lasts') assert.ok(Math.abs(long - short - rest) < 1e-9 * whole && Math.abs(long - whole) < 1e-9 * whole);
    assert.ok([...fed, ...taken].every(({ value }) => value > 0));
  }
});

test('without motion there is nothing to balance', () => {
  for (const energy of [null, { tire: 0, damper: 0, treadWidth: 0, stored: 0 }])
    assert.deepEqual(balanceOf(energy), { trend: 'rests', fed: [], taken: [], rest: 0, whole: 0 });
});

test('energies of a balance are written in one unit, to three digits of the whole or more', () => {
  const written = (/** @type {number} */ whole, /** @type {number[]} */ values) => values.map(energyWriter(whole, voiceOf('en')));
  assert.deepEqual(written(1596, [1596, 1158, 195]), ['1596 J', '1158 J', '195 J']);
  assert.deepEqual(written(26, [26, 24.7, 1.3]), ['26.0 J', '24.7 J', '1.3 J']);
  assert.deepEqual(written(0.00123, [0.00123, 0.0002]), ['1.23 mJ', '0.20 mJ']);
  assert.deepEqual(written(12_345, [12_345, 900]), ['12.3 kJ', '0.9 kJ']);
  assert.deepEqual([2e-6, 3e-9].map((value) => energyWriter(value, voiceOf('tr'))(value)), ['2,00 µJ', '3,00 nJ']);
});
