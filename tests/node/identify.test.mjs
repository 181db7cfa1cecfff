import assert from 'node:assert/strict';
import test from 'node:test';
import { identified, recipe } from '../../scripts/identify.mjs';
import { shimmy } from './module.mjs';

test('the numbers of the current-dependent damper are what the script finds', () => {
  const { values, error, known } = identified(shimmy);
  const table = shimmy.dampers()[3].parameters;
  const shipped = Object.fromEntries(table.map(({ name, default: value }) => [name, value]));
  assert.equal(Object.keys(values).length, 17);
  const [of] = shimmy.fitness(recipe(shimmy, 1), table.map((parameter) => parameter.default));
  // The text beside the table says 4.6 %: of all records together, and of each by itself.
  assert.ok(Math.abs(of - 0.0459) < 0.0001, `shipped numbers: ${of}`);
  assert.ok(Math.abs(of / error - 1) < 1e-3, `shipped ${of}, found ${error}`);
  assert.ok(known.fits[0].error < 0.008 && known.fits[6].error < 0.067);
  // The seeds end where the error is the same.
  assert.ok(known.errors.every((/** @type {number} */ one) => one < 1.01 * known.errors[known.best]));
  // What the records fix is the same number; what they do not may be another where the search goes another way.
  for (const { name, fixed } of known.parameters) {
    if (fixed && !/^preload|Saturation$/.test(name)) assert.ok(Math.abs(values[name] / shipped[name] - 1) < 0.03, `${name}: ${values[name]} for ${shipped[name]}`);
  }
  assert.ok(known.parameters.filter((/** @type {any} */ { fixed }) => fixed).length === 10);
});
