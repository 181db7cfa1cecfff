import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { shimmy, SHIMMY, STATES } from './module.mjs';

/** @typedef {'torsionAngle' | 'torsionRate' | 'lateralDeformation'} State */

/** Trajectories computed with SciPy, split at the kinks; each good to about 1e-9 of its largest value. */
const { trajectories } = JSON.parse(readFileSync(new URL('../reference.json', import.meta.url), 'utf8'));
const models = new Set(shimmy.models().map(({ name }) => name));

/** Cases of gears that are there; a damper is not yet part of any. */
for (const { id, run, expect } of trajectories.filter((/** @type {any} */ c) => models.has(c.run.model) && !c.run.damper)) {
  test(`meets the reference to 1e-6 of each series' largest value: ${id}`, () => {
    const trajectory = shimmy.simulate(run);
    assert.deepEqual([...trajectory.time], run.times);
    for (const state of /** @type {State[]} */ (Object.keys(expect))) {
      const largest = Math.max(...expect[state].map(Math.abs));
      for (const [index, value] of expect[state].entries()) {
        const error = Math.abs(trajectory[state][index] - value) / largest;
        assert.ok(error < 1e-6, `${state} at ${run.times[index]} s is off by ${error}`);
      }
    }
  });
}

test('a trajectory is a plain object of series, each its own Float64Array', () => {
  const trajectory = shimmy.simulate({ ...SHIMMY, samples: 11 });
  assert.equal(Object.getPrototypeOf(trajectory), Object.prototype);
  assert.deepEqual(Object.keys(trajectory).sort(), ['time', 'events', 'stats', ...STATES].sort());
  const series = [trajectory.time, ...STATES.map((name) => trajectory[name])];
  for (const values of series) {
    assert.ok(values instanceof Float64Array);
    assert.equal(values.length, 11);
    assert.equal(values.buffer.byteLength, 11 * 8, 'a copy, not a window into the memory of the module');
  }
  assert.equal(new Set(series.map(({ buffer }) => buffer)).size, series.length);
});

test('a series stays as it is while the module goes on', () => {
  const first = shimmy.simulate({ ...SHIMMY, samples: 101 });
  const before = first.torsionAngle.slice();
  for (let i = 0; i < 20; i++) shimmy.simulate({ ...SHIMMY, samples: 10_001 });
  assert.deepEqual(first.torsionAngle, before);
});

test('samples are spaced equally from 0 to the duration', () => {
  const { time } = shimmy.simulate({ ...SHIMMY, duration: 0.5, samples: 6 });
  for (const [index, t] of time.entries()) assert.ok(Math.abs(t - index / 10) < 1e-15);
});

test('times may begin late, and set the duration; a Float64Array and an array of numbers do the same', () => {
  const times = [0.1, 0.25, 0.3];
  const list = shimmy.simulate({ ...SHIMMY, times });
  const typed = shimmy.simulate({ ...SHIMMY, times: new Float64Array(times) });
  assert.deepEqual([...list.time], times);
  assert.deepEqual(list, typed);
});

test("without samples or times it is the solver's own steps, from 0 to 2 s", () => {
  const { time, stats } = shimmy.simulate(SHIMMY);
  assert.equal(time[0], 0);
  assert.equal(time.at(-1), 2);
  assert.ok(time.length >= stats.steps / 2);
  assert.ok(time.every((t, index) => index === 0 || t >= time[index - 1]));
});

test('an absent key, undefined and null mean the same', () => {
  const plain = shimmy.simulate({ model: 'torsional', initial: { torsionAngle: 0.05 }, samples: 5 });
  const nothing = { parameters: null, method: null, rtol: undefined, atol: null, step: undefined, times: null };
  assert.deepEqual(shimmy.simulate({ model: 'torsional', initial: { torsionAngle: 0.05 }, samples: 5, ...nothing }), plain);
});

test('events are told: where the side force meets its limit, in ascending time, each with its kind', () => {
  const { events, stats } = shimmy.simulate(SHIMMY);
  assert.ok(events.time instanceof Float64Array && events.kind instanceof Uint8Array);
  assert.equal(events.time.length, events.kind.length);
  assert.equal(events.time.length, stats.events);
  assert.ok(stats.events > 100, 'it shimmies with 52 Hz, and passes the limit four times a cycle');
  assert.ok(events.time.every((t, index) => index === 0 || t >= events.time[index - 1]));
  assert.ok(events.kind.every((kind) => typeof events.kinds[kind] === 'string'));
});

test('the count of work is told', () => {
  const { stats } = shimmy.simulate(SHIMMY);
  assert.deepEqual(Object.keys(stats).sort(), ['evaluations', 'events', 'method', 'rejected', 'steps', 'stiff']);
  assert.ok(stats.evaluations > stats.steps);
  assert.equal(stats.stiff, false);
});

test('the wheel settles on its cycle: 0.26508 rad at 51.87 Hz', () => {
  const { time, torsionAngle } = shimmy.simulate({ ...SHIMMY, duration: 8, samples: 800_001, rtol: 1e-9 });
  const settled = torsionAngle.subarray(700_000);
  assert.ok(Math.abs(settled.reduce((most, angle) => Math.max(most, Math.abs(angle)), 0) - 0.26508) < 5e-6);

  const crossings = [];
  for (let i = 700_001; i < torsionAngle.length; i++) {
    const [before, after] = [torsionAngle[i - 1], torsionAngle[i]];
    if (before < 0 && after >= 0) crossings.push(time[i - 1] - (before / (after - before)) * (time[i] - time[i - 1]));
  }
  const frequency = (crossings.length - 1) / (crossings[crossings.length - 1] - crossings[0]);
  assert.ok(Math.abs(frequency - 51.87) < 5e-3, `${frequency} Hz`);
});

// A tire that relaxes within 1e-276 m: the place of a switch, corrected, once lay before the step that led there.
test('the time never falls, where a switch lies at the very start, too', () => {
  const { time } = shimmy.simulate({
    model: 'torsional',
    parameters: {
      velocity: 120,
      casterLength: 0.2582156006246805,
      torsionalStiffness: 0,
      sideForceDerivative: 50,
      sideForceLimitAngle: 0.10916997219446051,
      aligningMomentLimitAngle: 0.5235987755982988,
      freeplayAngle: 0.04047535057033931,
      relaxationLength: 1.248035460142802e-276,
    },
    initial: { torsionAngle: 0.12724206512793898, torsionRate: -54.9194067902863 },
    duration: 0.0057696250426583,
  });
  assert.ok(time.every((t, index) => index === 0 || t >= time[index - 1]));
});
