import { test } from 'node:test';
import assert from 'node:assert/strict';
import { readLink, writeLink } from '../../www/link.js';

const table = {
  name: 'torsional',
  parameters: [{ name: 'velocity', default: 50 }, { name: 'dampingConstant', default: 10 }, { name: 'freeplayAngle', default: 0 }],
  state: [{ name: 'torsionAngle' }, { name: 'torsionRate' }, { name: 'lateralDeformation' }],
};
/** Stands for the engine's own check: speeds above 0, angles below 10 rad. */
const accepts = (/** @type {Record<string, number>} */ parameters, /** @type {Record<string, number>} */ initial) =>
  (parameters.velocity ?? 1) > 0 && Math.abs(initial.torsionAngle ?? 0) < 10;

const linked = {
  parameters: { velocity: 80, dampingConstant: 20, freeplayAngle: 0 },
  run: { initial: { torsionAngle: 0.05 } },
  clock: { slow: 25 },
  lens: 'phase',
};

test('a link is readable and carries only what differs from the defaults', () => {
  assert.equal(writeLink(linked, table), '#shimmy=1&velocity=80&dampingConstant=20&initial.torsionAngle=0.05&slow=25');
});

test('what a link carries comes back, to the last bit', () => {
  const odd = { ...linked, parameters: { velocity: 1 / 3, dampingConstant: 1e-300, freeplayAngle: 0.1 + 0.2 }, clock: { slow: null } };
  for (const state of [linked, odd]) {
    const read = readLink(writeLink(state, table), table, accepts);
    assert.deepEqual(read, { state, problems: [] });
  }
});

test('an address without an experiment is none', () => {
  for (const text of ['', '#', '#top', '?utm=1']) assert.equal(readLink(text, table, accepts), null);
});

test('a bad link opens what could be read and lists what could not', () => {
  const read = readLink('#shimmy=1&velocity=-3&dampingConstant=20&freeplayAngle=wide&colour=red&initial.torsionAngle=99'
    + '&initial.torsionRate=2&slow=7&lens=nowhere&dampingConstant=30&initial.velocity=1&%E0%A4%A', table, accepts);
  assert.deepEqual(read?.state, {
    parameters: { velocity: 50, dampingConstant: 20, freeplayAngle: 0 },
    run: { initial: { torsionRate: 2 } },
    clock: { slow: null },
    lens: 'phase',
  });
  assert.deepEqual(read?.problems.slice(0, 8).map(({ key, reason }) => [key, reason]), [
    ['velocity', 'refused'], ['freeplayAngle', 'not-a-number'], ['colour', 'unknown'], ['initial.torsionAngle', 'refused'],
    ['slow', 'refused'], ['lens', 'unknown'], ['dampingConstant', 'twice'], ['initial.velocity', 'unknown'],
  ]);
});

test('a link of a newer version says so and is read as far as it goes', () => {
  const read = readLink('#shimmy=9&velocity=70', table, accepts);
  assert.equal(read?.state.parameters.velocity, 70);
  assert.deepEqual(read?.problems, [{ key: 'shimmy', value: '9', reason: 'newer' }]);
  assert.equal(readLink('#shimmy=abc', table, accepts)?.problems[0].reason, 'version');
});

test('a link that lost its version, or is a query, is read and says what it lost', () => {
  for (const text of ['#velocity=40', '?velocity=40']) {
    const read = readLink(text, table, accepts);
    assert.equal(read?.state.parameters.velocity, 40);
    assert.deepEqual(read?.problems, [{ key: 'shimmy', value: '1', reason: 'missing' }]);
  }
});

test('what is left out says what stands instead', () => {
  const read = readLink('#shimmy=1&velocity=1e400&dampingConstant=20&dampingConstant=30&initial.torsionAngle=99', table, accepts);
  assert.deepEqual(read?.problems, [
    { key: 'velocity', value: '1e400', reason: 'too-large', instead: 50 },
    { key: 'dampingConstant', value: '30', reason: 'twice', instead: 20 },
    { key: 'initial.torsionAngle', value: '99', reason: 'refused', instead: 0 },
  ]);
});

test('names of the language itself are unknown keys, not keys', () => {
  const read = readLink('#shimmy=1&__proto__=1&constructor=2&initial.toString=3', table, accepts);
  assert.deepEqual(read?.problems.map(({ reason }) => reason), ['unknown', 'unknown', 'unknown']);
});
