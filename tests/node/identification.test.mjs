import assert from 'node:assert/strict';
import test from 'node:test';
import { refusal, shimmy } from './module.mjs';

const record = shimmy.damperRecord({ damper: { model: 'bouc-wen' }, excitation: { amplitude: 0.015 }, cycles: 2, samples: 200 });
const spec = { model: 'bouc-wen', records: [record], generations: 40, population: 30 };

test('a record has what an identification reads, and its noise has a seed', () => {
  assert.equal(record.force.length, 200);
  assert.equal(record.interval, 0.005);
  assert.equal(record.command, 1.5);
  const noisy = (/** @type {number} */ seed) => shimmy.damperRecord({ damper: { model: 'bouc-wen' }, samples: 200, noise: 0.05, seed }).force;
  assert.deepEqual(noisy(3), noisy(3));
  assert.notDeepEqual(noisy(3), noisy(4));
});

test('steps, shared generations and a job go the same way', () => {
  const alone = new shimmy.Identification(spec);
  const shared = new shimmy.Identification(spec);
  let last;
  while (!alone.done) {
    last = alone.step();
    assert.deepEqual(shared.tell(shimmy.fitness(spec, shared.ask())), last);
  }
  assert.ok(shared.done && last?.done);
  assert.ok(/** @type {number} */ (last?.bestError) < 0.005);
  const job = new shimmy.Job('identification', spec);
  while (!job.advance(5).done);
  const result = job.result();
  assert.deepEqual(result, alone.result());
  assert.equal(/** @type {any} */ (result).seed, 1);
  // What it gives is a damper.
  const { model, parameters, fits } = shared.result();
  const response = shimmy.damperResponse({ damper: { model, parameters }, excitation: { amplitude: 0.015 }, cycles: 2, samples: 200 });
  const largest = Math.max(...record.force);
  assert.ok(response.force.every((force, i) => Math.abs(force - fits[0].force[i]) < 1e-3 * largest));
  for (const made of [alone, shared, job]) made.free();
});

test('what the record does not fix is said', () => {
  const values = (/** @type {number} */ seed) => {
    const made = new shimmy.Identification({ ...spec, seed });
    while (!made.done) made.step();
    const { parameters } = made.result();
    made.free();
    return shimmy.dampers()[0].parameters.map(({ name }) => parameters[name]);
  };
  const known = shimmy.identifiability(spec, [1, 2, 3].flatMap(values));
  assert.equal(known.errors.length, 3);
  const unfixed = known.parameters.filter(({ fixed }) => !fixed).map(({ name }) => name);
  assert.deepEqual(unfixed, ['hysteresisGain', 'gamma', 'beta', 'amplitude']);
  assert.deepEqual(Object.keys(known.weak[0].parts), unfixed);
});

test('what cannot be is refused in words', () => {
  /** @param {any} change */
  const refused = (change) => refusal(() => new shimmy.Identification({ ...spec, ...change }));
  assert.equal(refused({ records: null }).field, 'records');
  assert.equal(refused({ records: [] }).field, 'records');
  assert.equal(refused({ records: [{ ...record, force: [1, 2] }] }).field, 'records[0].force');
  assert.equal(refused({ records: [record, { ...record, interval: 0 }] }).field, 'records[1].interval');
  assert.equal(refused({ bounds: { gamma: [2, 1] } }).field, 'bounds.gamma');
  assert.equal(refused({ bounds: { gama: [1, 2] } }).suggestion, 'gamma');
  assert.equal(refused({ population: 2 }).field, 'population');
  assert.equal(refused({ seed: 2 ** 53 }).field, 'seed');
  assert.equal(refusal(() => shimmy.fitness(spec, [1, 2, 3])).field, 'population');
});
