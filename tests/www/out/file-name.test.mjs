import assert from 'node:assert/strict';
import { test } from 'node:test';
import { fileName } from '../../../www/out/file-name.js';
import { tableOf } from './runs.mjs';

const table = tableOf('torsional');
const usual = Object.fromEntries(table.parameters.map(({ name, default: value }) => [name, value]));

test('a name says speed and damping, and what differs from the usual gear', () => {
  assert.equal(fileName(table, { ...usual, velocity: 80, dampingConstant: 20 }, 'phase', 'png'), 'shimmy-v80-c20-phase.png');
  assert.equal(fileName(table, usual, '', 'csv'), 'shimmy-v50-c10.csv');
  const loose = { ...usual, velocity: 27.6, freeplayAngle: Math.PI / 180, relaxationLength: 0.25 };
  assert.equal(fileName(table, loose, 'gear', 'svg'), 'shimmy-v27.6-c10-sigma0.25-psifp1deg-gear.svg');
});

test('whatever the values, every system takes the name', () => {
  const wild = Object.fromEntries(table.parameters.map(({ name }, i) => [name, [-1e30, 1e-30, 1 / 3][i % 3]]));
  const name = fileName(table, wild, 'phase', 'png');
  assert.match(name, /^[A-Za-z0-9.-]+$/);
  assert.ok(name.length < 100, name);
});
