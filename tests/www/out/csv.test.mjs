import assert from 'node:assert/strict';
import { test } from 'node:test';
import { csvOf } from '../../../www/out/csv.js';
import { shimmy } from '../../node/module.mjs';
import { opening, tableOf } from './runs.mjs';

test('the CSV holds what simulate gives, number for number', () => {
  const motion = shimmy.simulate(opening());
  const text = csvOf(motion, tableOf('torsional'));
  assert.ok(text.endsWith('\r\n'));
  const [header, ...rows] = text.trimEnd().split('\r\n');
  assert.equal(header, 'time (s),torsionAngle (rad),torsionRate (rad/s),lateralDeformation (m)');
  assert.equal(rows.length, 4001);
  const numbers = rows.map((row) => row.split(',').map(Number));
  for (const [at, name] of /** @type {const} */ (['time', 'torsionAngle', 'torsionRate', 'lateralDeformation']).entries())
    assert.deepEqual(numbers.map((row) => row[at]), [...motion[name]], name);
});

test('a field with a comma, a quote or a line break is quoted, and a pure number has no unit', () => {
  const table = { state: [{ name: 'x, "raw"', unit: '1' }, { name: 'y', unit: 'm' }] };
  const columns = { time: [0, 0.1 + 0.2], 'x, "raw"': [1e-300, -2.5e21], y: [1 / 3, -0.5] };
  const text = csvOf(columns, table);
  assert.equal(text, 'time (s),"x, ""raw""",y (m)\r\n0,1e-300,0.3333333333333333\r\n0.30000000000000004,-2.5e+21,-0.5\r\n');
});
