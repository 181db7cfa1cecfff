// Routh's array as one reads it: the sign that breaks, the conditions and their numbers.

import { test } from 'node:test';
import assert from 'node:assert/strict';
import { measured } from '../../www/controls/mathml.js';
import { conditionsOf, digitsApart, signChanges } from '../../www/lens/stability/routh-hurwitz.js';
import { linearLooks } from '../../www/run/linear-looks.js';
import { voiceOf } from '../../www/words/voice.js';
import { criticalSpeeds, cubicOf, rootsOf, usual } from './linear-gear.mjs';
import { engine } from './stories.mjs';

test('the conditions have the numbers of the cubic, and break just beyond the known critical speeds', () => {
  for (const [dampingConstant, speed] of criticalSpeeds) {
    const [below, beyond] = [0.999 * speed, 1.001 * speed].map((velocity) => conditionsOf([1, ...cubicOf({ velocity, dampingConstant })]));
    assert.ok(below.every(({ isMet }) => isMet));
    assert.deepEqual(beyond.map(({ isMet }) => isMet), [true, true, false]);
  }
  const [a2, a1, a0] = cubicOf({ velocity: 80, dampingConstant: 20 });
  const [first, second, third] = conditionsOf([1, a2, a1, a0]);
  assert.deepEqual([first.value, first.bound, second.value, second.bound, third.value, third.bound], [a2, 0, a0, 0, a2 * a1, a0]);
  assert.deepEqual([third.terms, third.than], [[2, 1], 0]);
  assert.deepEqual(conditionsOf([1, 2, 3, 6]).map(({ isMet, isEqual }) => [isMet, isEqual]), [[true, false], [true, false], [false, true]], 'on the boundary a condition is not met');
  assert.deepEqual(conditionsOf([1, 2, 3]), [], 'written so for a third degree alone');
});

test('at a critical value in full the gear is on the boundary; a little beyond, digits enough tell the difference', () => {
  for (const [dampingConstant, near] of criticalSpeeds) {
    const at = (/** @type {Record<string, number>} */ values) => linearLooks(engine, { model: 'torsional', parameters: { ...usual, dampingConstant, ...values } });
    const [velocity] = at({}).routhHurwitz().criticalVelocities;
    assert.ok(Math.abs(velocity - near) < 5e-4);
    const { neutralRoots, unstableRoots, coefficients } = at({ velocity }).routhArray();
    assert.deepEqual([neutralRoots, unstableRoots], [2, 0]);
    assert.deepEqual(conditionsOf(coefficients).map(({ isEqual }) => isEqual), [false, false, true]);
    const beyond = conditionsOf(at({ velocity: velocity * (1 + 1e-6) }).routhArray().coefficients)[2];
    assert.ok(!beyond.isEqual && !beyond.isMet);
    const digits = digitsApart(beyond.value, beyond.bound);
    assert.notEqual(beyond.value.toPrecision(digits), beyond.bound.toPrecision(digits));
  }
  assert.equal(digitsApart(2, 1), 5);
  assert.equal(digitsApart(1, 1), 5);
  assert.equal(digitsApart(0, 0), 5);
});

test('each change of sign is a root that grows', () => {
  for (const values of [{ velocity: 80, dampingConstant: 20 }, { velocity: 80, dampingConstant: 60 }, { casterLength: -0.8, torsionalStiffness: 20_000 }]) {
    const { rows, unstableRoots } = linearLooks(engine, { model: 'torsional', parameters: { ...usual, ...values } }).routhArray();
    const changes = signChanges(rows.map(([one]) => one)).filter(Boolean).length;
    assert.equal(changes, rootsOf(values).filter(({ re }) => re > 0).length);
    assert.equal(changes, unstableRoots);
  }
});

test('a sign changes from the last that there was', () => {
  assert.deepEqual(signChanges([1, 290, -18806, 3.6e7]), [false, false, true, true]);
  assert.deepEqual(signChanges([1, 0, -2, -3]), [false, false, true, false]);
  assert.deepEqual(signChanges([-1, -2, 4]), [false, false, true]);
});

test('numbers of any size are typeset: plain, or as a power of ten', () => {
  const read = (/** @type {number} */ value, language = /** @type {'en' | 'tr'} */ ('en')) => markup(measured(value, voiceOf(language))).replaceAll(/<[^>]+>/g, ' ').replaceAll(/ +/g, ' ').trim();
  assert.equal(read(1), '1');
  assert.equal(read(0), '0');
  assert.equal(read(290.0416), '290.04');
  assert.equal(read(-18806.3), '− 18\u202f806');
  assert.equal(read(3.62667e7), '3.6267 · 10 7');
  assert.equal(read(-2.5e-9), '− 2.5000 · 10 −9');
  assert.equal(read(290.0416, 'tr'), '290,04');
});

/** @param {unknown} template @returns {string} */
function markup(template) {
  if (Array.isArray(template)) return template.map(markup).join('');
  if (typeof template !== 'object' || template === null || !('strings' in template)) return String(template);
  const { strings, values } = /** @type {import('lit').TemplateResult} */ (template);
  return strings.map((text, i) => text + (i < values.length ? markup(values[i]) : '')).join('');
}
