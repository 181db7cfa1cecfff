import { test } from 'node:test';
import assert from 'node:assert/strict';
import { limitsFor, magnificationFor, settlingTime, spanFor, stillFits } from '../../www/run/fit.js';
import { PastEnvelope } from '../../www/run/past-envelope.js';

const degree = Math.PI / 180;

test('swings are magnified to draw near 10–20°, and large ones are drawn to scale', () => {
  for (const [angle, factor] of [[15.2, 1], [13, 1], [25, 1], [3, 5], [1.28, 10], [0.6, 20], [0.3, 50], [0.01, 50], [0, 50]])
    assert.equal(magnificationFor(angle * degree), factor, `${angle}°`);
});

test('axes hold the swing and end at round degrees', () => {
  const { angle, rate, deformation } = limitsFor({ angle: 15.188 * degree, rate: 86, deformation: 0.0412 });
  assert.ok(Math.abs(angle / degree - 20) < 1e-9);
  assert.equal(rate, 100);
  assert.equal(deformation, 0.05);
  const rest = limitsFor({ angle: 0, rate: 0, deformation: 0 });
  assert.ok(rest.angle > 0 && rest.rate > 0 && rest.deformation > 0);
});

test('axes are kept while the motion fits and fills them', () => {
  const limits = { angle: 0.35, rate: 100, deformation: 0.05 };
  assert.ok(stillFits(limits, { angle: 0.3, rate: 90, deformation: 0.04 }));
  assert.ok(!stillFits(limits, { angle: 0.4, rate: 90, deformation: 0.04 }));
  assert.ok(!stillFits(limits, { angle: 0.01, rate: 3, deformation: 0.001 }));
});

/** A swing that has gone half of its way after each 0.1 s. */
const ahead = {
  time: Array.from({ length: 61 }, (_, i) => i / 10),
  low: Array.from({ length: 61 }, (_, i) => -(1 - 0.5 ** i)),
  high: Array.from({ length: 61 }, (_, i) => 1 - 0.5 ** i),
};

test('a motion has settled when two percent of its way are left', () => {
  assert.ok(Math.abs(settlingTime(ahead) - 0.6) < 1e-12);
  assert.equal(settlingTime({ time: [], low: [], high: [] }), 0);
  assert.equal(settlingTime({ time: [0, 1], low: [-1, -1], high: [1, 1] }), 0);
});

test('the timeline spans the settling, and grows when now comes near its end', () => {
  assert.deepEqual(spanFor(ahead, 0, [0, 0]), { from: 0, to: 0.8 });
  const { from, to } = spanFor({ ...ahead, time: ahead.time.map((time) => time + 30) }, 30, [0, 30]);
  assert.equal(from, 0);
  assert.ok(to > 33 && to < 45);
});

test('past stretches are asked for once, kept through a seek back, and follow another width', () => {
  /** @type {[number, number, number][]} */
  const asked = [];
  const source = {
    time: 0.55,
    range: [0, 10],
    /** @param {number} from @param {number} to @param {number} stretches */
    envelope: (from, to, stretches) => {
      asked.push([from, to, stretches]);
      return { low: new Float64Array(stretches).fill(-from), high: new Float64Array(stretches).fill(to) };
    },
  };
  const past = new PastEnvelope();
  const first = past.upTo(source, 0, 0.1);
  assert.deepEqual(asked[0], [0, 0.5, 5]);
  assert.equal(first.time.length, 6);
  assert.equal(first.time.at(-1), 0.55);
  asked.length = 0;
  source.time = 0.72;
  assert.equal(past.upTo(source, 0, 0.1).time.length, 8);
  assert.equal(asked.filter(([, , stretches]) => stretches === 2).length, 1, 'two new stretches in one question');
  asked.length = 0;
  source.time = 0.35;
  assert.equal(past.upTo(source, 0, 0.1).time.length, 4);
  assert.equal(asked.length, 1, 'only the present is asked for');
  source.time = 0.36;
  assert.equal(past.upTo(source, 0.1, 0.1).time.length, 3, 'what has gone out of the window is dropped');
  assert.equal(past.upTo(source, 0, 0.05).time.length, 8);
});
