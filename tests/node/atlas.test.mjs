import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';
import { shimmy } from './module.mjs';

const models = new Set(shimmy.models().map(({ name }) => name));

test('the atlas is what its file says, anew at each call', () => {
  const file = JSON.parse(readFileSync(new URL('../../src/atlas.json', import.meta.url), 'utf8'));
  const atlas = shimmy.atlas();
  assert.equal(atlas.length, 283);
  assert.deepEqual(atlas, file);
  atlas[0].title = 'mine';
  assert.deepEqual(shimmy.atlas(), file);
});

test('a run of a gear that is here can be handed to simulate as it is', () => {
  const entry = shimmy.atlas().find(({ id }) => id === 'Figure 6.20');
  assert.ok(entry?.run && models.has(entry.run.model));
  const { lateralDeformation } = shimmy.simulate(entry.run);
  assert.ok(lateralDeformation.length > 100);
});
