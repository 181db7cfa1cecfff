import { test } from 'node:test';
import assert from 'node:assert/strict';
import { Quantity } from '../../www/controls/quantity.js';
import { grouped } from '../../www/controls/groups.js';
import { explain } from '../../www/controls/refusal.js';
import { isVelocityUnit, nextVelocityUnit, velocityUnits } from '../../www/controls/unit.js';
import { parseNumber } from '../../www/words/number.js';
import { voiceOf } from '../../www/words/voice.js';

const degree = Math.PI / 180;
/** @param {Partial<import('../../www/controls/quantity.js').Parameter>} some */
const quantity = (some, /** @type {import('../../www/controls/unit.js').VelocityUnit | undefined} */ unit = undefined) =>
  new Quantity({ name: 'x', symbol: 'x', unit: 'm', default: 0, min: 0, max: 1, scale: 'linear', doc: '', ...some }, unit);
const speed = quantity({ name: 'velocity', unit: 'm/s', min: 1, max: 120 });
const gap = quantity({ name: 'freeplayAngle', unit: 'rad', max: 3 * degree });
const inertia = quantity({ name: 'momentOfInertia', unit: 'kg m²', min: 0.1, max: 10, scale: 'log' });

test('angles are degrees on the page and radians behind it', () => {
  assert.equal(gap.unit, '°');
  assert.equal(gap.write(degree, voiceOf('en')), '1.00°');
  assert.ok(Math.abs(gap.toSI(1.5) - 1.5 * degree) < 1e-15);
  assert.equal(gap.toShown(gap.toSI(0.7)), 0.7);
  assert.equal(speed.write(80, voiceOf('tr')), '80,0 m/s');
  assert.equal(quantity({ unit: '1' }).unit, '');
});

test('a number may be typed with its unit, or with another that people think in', () => {
  const knots = quantity({ name: 'velocity', unit: 'm/s', min: 1, max: 120 }, 'kn');
  const force = quantity({ unit: 'N', max: 20_000 });
  const damping = quantity({ unit: 'N m s/rad', max: 200 });
  const close = (/** @type {Quantity} */ of, /** @type {string} */ text, /** @type {number} */ si) =>
    assert.ok(Math.abs(of.toSI(of.read(text)) - si) < 1e-9 * Math.max(1, si), `${text}: ${of.toSI(of.read(text))}`);
  close(speed, '150 kn', 150 * 1852 / 3600);
  close(speed, '150kt', 150 * 1852 / 3600);
  close(speed, '288 km/h', 80);
  close(speed, '80 m/s', 80);
  close(knots, '80 m/s', 80);
  assert.equal(knots.read('100 kn'), 100);
  assert.equal(gap.read('1,5°'), 1.5);
  assert.equal(gap.read('1.5 deg'), 1.5);
  close(gap, '0.01 rad', 0.01);
  close(force, '9 kN', 9000);
  close(force, '9000 N', 9000);
  close(quantity({}), '100 mm', 0.1);
  assert.equal(damping.read('40 N m s/rad'), 40);
  assert.equal(speed.read('80'), 80);
  for (const text of ['80 kg', '5° 3', 'fast', 'kn', '°']) assert.ok(Number.isNaN(speed.read(text)), text);
  assert.ok(Number.isNaN(quantity({ unit: '1' }).read('3 m')));
});

test('a speed is shown in the unit that was chosen, and typed in it', () => {
  // A knot is 1852 m in 3600 s: 80 m/s are 155.5076 of them.
  const knots = quantity({ name: 'velocity', unit: 'm/s', min: 1, max: 120 }, 'kn');
  assert.equal(knots.write(80, voiceOf('en')), '155.5 kn');
  assert.ok(Math.abs(knots.toSI(100) - 51.444_444_444) < 1e-9);
  assert.equal(knots.write(knots.toSI(100.25), voiceOf('tr')), '100,25 kn', 'what was typed stands there in full');
  assert.equal(knots.toShown(knots.stepped(knots.toSI(100), 1)), 101);
  assert.equal(knots.toShown(knots.stepped(knots.toSI(100), -0.1)), 99.9);
  assert.ok(Math.abs(knots.placeOf(80) - speed.placeOf(80)) < 1e-9, 'the thumb stays where it is');
  const hourly = quantity({ name: 'velocity', unit: 'm/s', min: 1, max: 120 }, 'km/h');
  assert.equal(hourly.write(80, voiceOf('en')), '288 km/h');
  assert.ok(Math.abs(hourly.toSI(90) - 25) < 1e-12);
  assert.equal(hourly.number(27.77, voiceOf('en')), '99.972');
  for (const unit of velocityUnits) assert.equal(quantity({ unit: 'm/s', max: 120 }, unit).unit, unit);
  assert.deepEqual(velocityUnits.map(nextVelocityUnit), ['kn', 'km/h', 'm/s']);
  assert.ok(isVelocityUnit('kn') && !isVelocityUnit('mph') && !isVelocityUnit(undefined));
});

test('a force is in kilonewtons', () => {
  const load = quantity({ name: 'verticalForce', unit: 'N', max: 50_000 });
  assert.equal(load.write(9000, voiceOf('en')), '9.0 kN');
  assert.equal(load.toSI(12.345), 12_345);
  assert.equal(load.stepped(9000, 1), 9100);
  assert.equal(quantity({ unit: 'N m/rad', max: 3e5 }).write(1e5, voiceOf('en')), '100\u202f000 N m/rad');
});

test('a value is rounded up or down to what its slider sets, unless it is that number but for a hundredth', () => {
  assert.equal(speed.rounded(48.530, 'up'), 48.6);
  assert.equal(speed.rounded(48.530, 'down'), 48.5);
  assert.equal(speed.rounded(27.5996, 'down'), 27.6);
  assert.equal(speed.rounded(27.598, 'down'), 27.5);
  assert.equal(quantity({ min: -0.5, max: 0.5 }).rounded(-0.04314, 'down'), -0.044);
  assert.equal(quantity({ max: 3e5 }).rounded(123_456, 'up'), 124_000);
  assert.equal(inertia.rounded(0.312834, 'down'), 0.312);
  assert.equal(inertia.rounded(3.12834, 'up'), 3.13);
});

test('slider and value are each other’s inverse, linear and logarithmic', () => {
  for (const one of [speed, gap, inertia])
    for (const place of [0, 0.25, 0.5, 1]) {
      const value = one.valueAt(place);
      assert.ok(Math.abs(one.placeOf(value) - place) < 0.005, `${one.name} at ${place}`);
    }
  assert.equal(inertia.valueAt(0.5), 1);
  assert.equal(speed.placeOf(500), 1);
  assert.equal(speed.placeOf(-5), 0);
});

test('a slider sets round values, and steps by about a hundredth of its way', () => {
  assert.equal(speed.valueAt(0.337), 41.1);
  assert.equal(speed.step, 1);
  assert.equal(gap.step, 0.01);
  assert.equal(speed.stepped(80, 1), 81);
  assert.equal(speed.stepped(80, -0.1), 79.9);
  assert.equal(speed.stepped(119.5, 10), 120);
  assert.equal(speed.stepped(200, 1), 200, 'a typed value beyond the slider stays');
  assert.equal(speed.stepped(200, -1), 199);
});

test('a typed value is shown with all its digits', () => {
  assert.equal(speed.number(70.25, voiceOf('en')), '70.25');
  assert.equal(quantity({ max: 300000 }).number(100000, voiceOf('en')), '100\u202f000');
});

test('a refusal is explained in the page’s language and units', () => {
  const say = (/** @type {string} */ code, /** @type {string | undefined} */ allowed, /** @type {'en' | 'tr'} */ language, one = speed, kept = 80) =>
    explain({ code, allowed }, one, language === 'en' ? 'Speed' : 'Hız', kept, voiceOf(language));
  assert.equal(say('out-of-range', '> 0 m/s', 'en'), 'Speed must be above 0 m/s. It stays at 80.0.');
  assert.equal(say('out-of-range', '> 0 m/s', 'tr'), 'Hız 0 m/s değerinden büyük olmalı. 80,0 olarak kaldı.');
  assert.equal(say('out-of-range', '≥ 0 rad', 'en', gap, degree), 'Speed must be 0° or more. It stays at 1.00.');
  assert.equal(say('not-a-number', undefined, 'en'), 'That is not a number. Speed stays at 80.0.');
  assert.equal(say('out-of-range', 'at most 1e12 m/s in magnitude', 'en'), 'Speed is too large to compute with. It stays at 80.0.');
});

test('a refusal is explained in the unit that is shown', () => {
  const knots = quantity({ name: 'velocity', unit: 'm/s', min: 1, max: 120 }, 'kn');
  assert.equal(explain({ code: 'out-of-range', allowed: '> 0 m/s' }, knots, 'Speed', 80, voiceOf('en')), 'Speed must be above 0 kn. It stays at 155.5.');
  const load = quantity({ name: 'verticalForce', unit: 'N', max: 50_000 });
  assert.equal(explain({ code: 'out-of-range', allowed: '≥ 0 N' }, load, 'Düşey kuvvet', 9000, voiceOf('tr')), 'Düşey kuvvet en az 0 kN olmalı. 9,0 olarak kaldı.');
});

test('every value stands in one group, whatever the model', () => {
  const named = (/** @type {string[]} */ ...names) => names.map((name) => ({ name }));
  const some = grouped(named('freeplayAngle', 'wheelRadius', 'velocity', 'dampingConstant', 'relaxationLength'));
  assert.deepEqual(some.map(({ group, members }) => [group, members.map(({ name }) => name)]), [
    ['motion', ['velocity']], ['gear', ['dampingConstant']], ['tire', ['relaxationLength']], ['freeplay', ['freeplayAngle']], ['others', ['wheelRadius']],
  ]);
  assert.deepEqual(grouped(named('velocity')).map(({ group }) => group), ['motion'], 'an empty group is none');
});

test('numbers too long for a field are powers of ten, and typed back mean the same', () => {
  for (const language of /** @type {const} */ (['en', 'tr']))
    for (const value of [1e-300, -2.5e-9, 1e6, 1.25e11, 0.0001, 999999, 0]) {
      const written = speed.number(value, voiceOf(language));
      assert.ok(written.length <= 9, written);
      assert.equal(parseNumber(written), value);
    }
});

test('far is an order of magnitude beyond the slider', () => {
  assert.deepEqual([0, 0.09, 0.5, 120, 1000, 1300].map((value) => speed.isFar(value)), [false, true, false, false, false, true]);
  assert.ok(!gap.isFar(0));
});
