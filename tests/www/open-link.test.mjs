// What the page says of the links that it opens: over the real engine, without elements.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { App } from '../../www/app.js';
import { engine, openedApp } from './stories.mjs';

/** A page that finds these addresses when it opens, the browser's kept one last. @param {string[]} addresses */
function opened(...addresses) {
  const app = new App();
  app.open(engine, addresses, { isStill: false });
  return app;
}

const kept = '#shimmy=2&velocity=33&initial.torsionAngle=0.05';

test('what a misspelt address named is said, though the kept experiment opens after it', () => {
  const app = opened('#velocty=30', '', kept);
  assert.equal(app.state.parameters.velocity, 33);
  assert.deepEqual(app.notes.map(({ text }) => text), ['Not all of the link could be read: velocty (unknown).']);
});

test('a kept experiment with a fault of its own adds its note', () => {
  const app = opened('#velocty=30', '', `${kept}&view.phase=orbt`);
  assert.deepEqual(app.notes.map(({ text }) => text), [
    'Not all of the link could be read: velocty (unknown).', 'Not all of the link could be read: view.phase = orbt (not understood).',
  ]);
});

test('a link that opens later takes the place of what was said before', () => {
  const app = opened('#velocty=30', '', kept);
  app.openLink('#shimmy=2&velocity=40&initial.torsionAngle=0.05');
  assert.deepEqual(app.notes, []);
});

test('a step beyond the end of a story is said, and the story is at its end', () => {
  const app = openedApp('#shimmy=2&initial.torsionAngle=0.05&story=cure,99');
  const { steps } = /** @type {import('../../www/story/story.js').Story} */ (app.stories.find(({ name }) => name === 'cure'));
  assert.deepEqual(app.state.story, { name: 'cure', step: steps.length - 1 });
  assert.match(app.notes[0].text, /story cure,99 \(ends before/);
});
