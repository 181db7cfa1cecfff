import assert from 'node:assert/strict';
import { test } from 'node:test';
import { readLink } from '../../../www/link/read.js';
import { modelsOf } from '../../../www/engine/models.js';
import { linkOfRun } from '../../../www/out/link-of-run.js';
import { runJson } from '../../../www/out/run-json.js';
import { shimmy } from '../../node/module.mjs';
import { opening, tableOf, wholeRun } from './runs.mjs';

test('simulate takes the file as it is, and needs no default of its own', () => {
  const run = JSON.parse(runJson(opening()));
  const table = tableOf('torsional');
  const named = [...Object.keys(run.parameters), ...Object.keys(run.friction).map((name) => `friction.${name}`)];
  assert.deepEqual(named, table.parameters.map(({ name }) => name));
  assert.deepEqual(run.initial, { torsionAngle: 0.05, torsionRate: 0, lateralDeformation: 0 });
  const motion = shimmy.simulate(run);
  assert.equal(motion.time.length, 4001);
  assert.equal(motion.time.at(-1), 2);
  // The same run with looser tolerance and defaults left out goes the same way.
  const plain = shimmy.simulate({ model: 'torsional', parameters: { velocity: 80, dampingConstant: 20 }, initial: { torsionAngle: 0.05 }, samples: 4001 });
  const apart = Math.max(...motion.torsionAngle.map((angle, i) => Math.abs(angle - plain.torsionAngle[i])));
  assert.ok(apart < 1e-5, `${apart} rad apart`);
});

test('a long run is sampled less finely, a short one still at both ends', () => {
  assert.equal(wholeRun('torsional', {}, 60).samples, 60_001);
  assert.equal(wholeRun('torsional', {}, 1e-5).samples, 2);
});

test('the page opens it again: every value comes back to the last bit', () => {
  const run = wholeRun('torsional', { velocity: 1 / 3, freeplayAngle: Math.PI / 180, torsionalStiffness: 1e-300, 'friction.moment': 100 / 3 }, 2);
  const read = readLink(linkOfRun(runJson(run)), modelsOf(shimmy), () => true);
  assert.deepEqual(read?.problems, []);
  assert.equal(read?.state.object, 'torsional');
  assert.deepEqual(run.friction, { moment: 100 / 3 });
  assert.deepEqual(read?.state.parameters, { ...run.parameters, 'friction.moment': 100 / 3 });
  assert.deepEqual(read?.state.run.initial, run.initial);
});

test('what the page cannot take of a file is listed, as of a link; what is no run is refused', () => {
  const text = JSON.stringify({ model: 'perpetuum-mobile', parameters: { sigma: 10, velocity: 'fast', dampingConstant: null }, initial: { torsionRate: 1 } });
  const read = readLink(linkOfRun(text), modelsOf(shimmy), () => true);
  assert.deepEqual(read?.problems.map(({ key, reason }) => [key, reason]),
    [['model', 'unknown'], ['sigma', 'unknown'], ['velocity', 'not-a-number'], ['dampingConstant', 'not-a-number']]);
  assert.equal(read?.state.run.initial.torsionRate, 1);
  for (const wrong of ['', 'time (s),torsionAngle (rad)', '[]', '{}', 'null', '{"model": 3}'])
    assert.throws(() => linkOfRun(wrong), wrong);
});
