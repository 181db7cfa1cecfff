import { test } from 'node:test';
import assert from 'node:assert/strict';
import { Quantity } from '../../www/controls/quantity.js';
import { ghostLabel } from '../../www/stage/ghost-label.js';
import { voiceOf } from '../../www/words/voice.js';

/** @param {string} name @param {string} symbol @param {string} unit */
const quantity = (name, symbol, unit) => new Quantity({ name, symbol, unit, default: 1, min: 0, max: 200, scale: 'linear', doc: '' });
const quantities = [
  quantity('velocity', 'v', 'm/s'), quantity('casterLength', 'e', 'm'), quantity('dampingConstant', 'c', 'N m s/rad'), quantity('freeplayAngle', 'ψ_fp', 'rad'),
];
const live = { velocity: 80, casterLength: 0.1, dampingConstant: 20, freeplayAngle: 0 };

test('a ghost is called by the values in which it differs', () => {
  const label = (/** @type {object} */ change, /** @type {'en' | 'tr'} */ language = 'en') => ghostLabel({ ...live, ...change }, live, quantities, voiceOf(language));
  assert.equal(label({}), '');
  assert.equal(label({ dampingConstant: 60 }), 'c = 60');
  assert.equal(label({ velocity: 62.5 }), 'v = 62.5 m/s');
  assert.equal(label({ velocity: 62.5 }, 'tr'), 'v = 62,5 m/s');
  assert.equal(label({ freeplayAngle: 0.5 * Math.PI / 180 }), 'ψfp = 0.5°');
  assert.equal(label({ velocity: 60, dampingConstant: 60 }), 'v = 60 m/s, c = 60');
  assert.equal(label({ velocity: 60, casterLength: 0.2, dampingConstant: 60 }), 'v = 60 m/s, e = 0.2 m, …');
});
