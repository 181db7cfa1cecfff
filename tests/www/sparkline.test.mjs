// How widely the gear will swing, over each slider: when it is followed, what curve it becomes, and how it is said.

import assert from 'node:assert/strict';
import { mock, test } from 'node:test';
import { Quantity } from '../../www/controls/quantity.js';
import { scentOf } from '../../www/controls/scent.js';
import { curveOf, fullHeight, livesBeyond, swingsInWords } from '../../www/controls/sparkline.js';
import { SwingScent } from '../../www/run/swing-scent.js';
import { voiceOf } from '../../www/words/voice.js';
import { defaults, table } from './opened-session.mjs';
import { engine } from './stories.mjs';

const quantity = (/** @type {string} */ name) => new Quantity(/** @type {typeof table.parameters[number]} */ (table.parameters.find((one) => one.name === name)));
const gear = (/** @type {Record<string, number>} */ values) => ({ object: 'torsional', parameters: { ...defaults, ...values }, links: { relaxationLength: true, treadWidthMomentConstant: true } });

test('branches are followed once the gear stands still, one slider after another, and are old as soon as it changes', async () => {
  mock.timers.enable({ apis: ['setTimeout'] });
  /** @type {string[]} */
  const asked = [];
  const scent = new SwingScent(async (spec) => {
    asked.push(`${spec.parameter} ${spec.from} ${spec.to} c ${spec.parameters?.dampingConstant}`);
    return /** @type {any} */ ({ of: spec.parameter });
  }, () => engine.models());
  let news = 0;
  scent.onChange = () => { news++; };
  const settle = async () => { for (let i = 0; i < 10; i++) await Promise.resolve(); };
  for (const dampingConstant of [20, 21, 22]) for (const name of ['velocity', 'dampingConstant']) assert.equal(scent.of(gear({ dampingConstant }), name), null);
  mock.timers.tick(100);
  assert.deepEqual(asked, []);
  mock.timers.tick(200);
  await settle();
  // The slider of c does not depend on c itself, so it was asked for once.
  assert.deepEqual(asked, ['velocity 1 120 c 22', 'dampingConstant 0 200 c 20']);
  assert.equal(news, 2);
  assert.deepEqual(scent.of(gear({ dampingConstant: 22 }), 'velocity'), { diagram: { of: 'velocity' }, isOld: false });
  assert.deepEqual(scent.of(gear({ dampingConstant: 50 }), 'velocity'), { diagram: { of: 'velocity' }, isOld: true });
  assert.deepEqual(scent.of(gear({ dampingConstant: 50 }), 'dampingConstant'), { diagram: { of: 'dampingConstant' }, isOld: false });
  mock.timers.reset();
});

test('a gear whose tire has no limit has no cycle, and what cannot be followed leaves no curve', async () => {
  mock.timers.enable({ apis: ['setTimeout'] });
  const scent = new SwingScent(() => Promise.reject(new Error('not finite')), () => engine.models());
  assert.equal(scent.of({ ...gear({}), object: 'torsional-linear' }, 'velocity'), null);
  assert.equal(scent.of(gear({}), 'nothing'), null);
  scent.of(gear({}), 'velocity');
  mock.timers.tick(300);
  for (let i = 0; i < 10; i++) await Promise.resolve();
  assert.equal(scent.of(gear({}), 'velocity'), null);
  mock.timers.reset();
});

test('the curve stands over its values, as high as the swing, and what is unstable is apart', () => {
  const velocity = quantity('velocity');
  const diagram = engine.bifurcation({ model: 'torsional', parameters: { dampingConstant: 20 }, parameter: 'velocity', from: 1, to: 120, step: 0.1, tolerance: 1e-3, probes: 0 });
  const { stable, unstable, widest } = curveOf(diagram, velocity);
  assert.equal(unstable, '');
  const points = [...stable.matchAll(/[ML]([\d.]+) ([\d.]+)/g)].map(([, x, y]) => [Number(x), Number(y)]);
  // Born at 27.600 m/s; at 40 m/s 18.057° (theory.md).
  assert.ok(Math.abs(points[0][0] - 1000 * velocity.placeOf(27.6)) < 0.5 && points[0][1] === 100);
  const [near] = points.filter(([x]) => Math.abs(x - 1000 * velocity.placeOf(40)) < 15);
  assert.ok(Math.abs(near[1] - 100 * (1 - (18.057 * Math.PI) / 180 / fullHeight)) < 1.5, `${near}`);
  assert.match(swingsInWords({ diagram, isOld: false }, velocity, voiceOf('en')), /^Swings up to ±18°, at \d\d\.\d m\/s$/);
  assert.equal(swingsInWords({ diagram, isOld: true }, velocity, voiceOf('en')), '', 'what is old is not said');
  assert.ok(widest && Math.abs(widest.amplitude - Math.max(...diagram.cycles[0].amplitude)) < 1e-12);

  const damped = engine.bifurcation({ model: 'torsional', parameters: { velocity: 80 }, parameter: 'dampingConstant', from: 0, to: 200, step: 0.1, tolerance: 1e-3, probes: 0 });
  assert.equal(swingsInWords({ diagram: damped, isOld: false }, quantity('dampingConstant'), voiceOf('en')), 'Swings beyond ±29°, widest at 0.0 N m s/rad', 'no more is said than the model is trusted for');

  const degree = Math.PI / 180;
  const folded = engine.bifurcation({
    model: 'torsional', parameters: { dampingConstant: 10, casterLength: -0.05, sideForceLimitAngle: 3 * degree, aligningMomentLimitAngle: 20 * degree }, parameter: 'velocity', from: 1, to: 120,
  });
  const curve = curveOf(folded, velocity);
  const folds = folded.points.filter(({ kind }) => kind === 'fold').map((point) => 1000 * velocity.placeOf(point.velocity));
  const dashed = [...curve.unstable.matchAll(/[ML]([\d.]+) /g)].map(([, x]) => Number(x));
  assert.equal(folds.length, 2);
  assert.ok(Math.abs(Math.min(...dashed) - Math.min(...folds)) < 0.5 && Math.abs(Math.max(...dashed) - Math.max(...folds)) < 0.5);
});

test('where a wide swing lives beyond the boundary, what is said of it is said of small ones alone', () => {
  const dampingConstant = quantity('dampingConstant');
  const degree = Math.PI / 180;
  /** @type {[Record<string, number>, boolean][]} */
  const gears = [
    [{ velocity: 80 }, false], [{ velocity: 40 }, false],
    [{ velocity: 40, casterLength: -0.05, sideForceLimitAngle: 3 * degree, aligningMomentLimitAngle: 20 * degree }, true],
  ];
  for (const [parameters, expected] of gears) {
    const range = { parameter: 'dampingConstant', from: 0, to: 200 };
    const { sideForceLimitAngle: _, aligningMomentLimitAngle: __, ...linear } = parameters;
    const intervals = engine.unstableIntervals({ model: 'torsional-linear', parameters: linear }, range);
    const diagram = engine.bifurcation({ model: 'torsional', parameters, ...range, step: 0.1, tolerance: 1e-3, probes: 2 });
    assert.equal(livesBeyond({ diagram, isOld: false }, intervals, dampingConstant), expected, JSON.stringify(parameters));
    assert.equal(livesBeyond({ diagram, isOld: true }, intervals, dampingConstant), false);
    const said = scentOf({ intervals, isOnlyLinear: false, isOnlySmall: expected, isDivergent: false }, dampingConstant, voiceOf('en')).inWords;
    if (expected) assert.match(said, /^small swings: stable above 8\.9/);
    else assert.match(said, /^dies out above/);
  }
});
