import { test } from 'node:test';
import assert from 'node:assert/strict';
import { decimalsFor, decimalsOf, formatNumber, parseNumber } from '../../www/words/number.js';

test('both decimal signs are read alike', () => {
  for (const [text, value] of /** @type {[string, number][]} */ ([
    ['80', 80], ['80.5', 80.5], ['80,5', 80.5], ['-0,1', -0.1], ['−0.1', -0.1], ['.5', 0.5], [',5', 0.5], ['5.', 5],
    ['1e3', 1000], ['1,5e-3', 0.0015], [' 100 000 ', 100000], ['100\u202f000', 100000], ['1.234,5', 1234.5],
    ['1,234.5', 1234.5], ['1.234.567', 1234567], ['+3', 3], ["1'000", 1000],
  ])) assert.equal(parseNumber(text), value, text);
});

test('what is no number is not guessed at', () => {
  for (const text of ['', ' ', 'abc', '1.2.3', '12.34.567', '1,2.3,4', '1.23,456,789', '--5', '5 m', '0x10', 'Infinity', 'NaN', '1e', '.', ',', '1e5.5'])
    assert.ok(Number.isNaN(parseNumber(text)), `"${text}" gave ${parseNumber(text)}`);
});

test('numbers are written in the language of the page and read back', () => {
  assert.equal(formatNumber(80, 1, 'en'), '80.0');
  assert.equal(formatNumber(80, 1, 'tr'), '80,0');
  assert.equal(formatNumber(-13.46, 1, 'tr'), '−13,5');
  assert.equal(formatNumber(-0.001, 1, 'en'), '0.0');
  assert.equal(formatNumber(100000, 0, 'en'), '100\u202f000');
  assert.equal(formatNumber(9000, 0, 'en'), '9000');
  for (const language of /** @type {const} */ (['en', 'tr']))
    for (const value of [0, -1.5, 123456.789, 0.000123, -99999])
      assert.equal(parseNumber(formatNumber(value, 6, language)), value);
});

test('a value is shown with all its digits, and with the field’s own at least', () => {
  assert.equal(decimalsOf(80, 1), 1);
  assert.equal(decimalsOf(80.25, 1), 2);
  assert.equal(decimalsOf(0.0001, 2), 4);
  assert.equal(decimalsOf(1e-9, 0), 9);
  assert.equal(decimalsOf(100000, 0), 0);
  assert.equal(decimalsOf(1 / 3, 1), 6);
});

test('significant digits decide the decimals, and whole digits always stand', () => {
  assert.deepEqual([1596, 195, 24.71, 1.3, 0.022268, -15.2, 0].map((value) => decimalsFor(value, 3)), [0, 0, 1, 2, 4, 1, 2]);
});
