// A damper is fitted to the gear from the list of values, and one that was identified takes its place with its own values.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openedApp } from '../stories.mjs';

test('the choice in the drawer fits a damper, and one undo takes it off', () => {
  const app = openedApp();
  app.run('fitting', { damper: 'bouc-wen' });
  assert.equal(app.state.object, 'torsional.bouc-wen');
  app.run('undo');
  assert.equal(app.state.object, 'torsional');
});

test('an identified damper comes with its values, but for what would preload the gear; twice, its values alone change', () => {
  const app = openedApp();
  app.run('fitDamper', { model: 'modified-bouc-wen', parameters: { viscousDampingBase: 2345, offset: 0.143 } });
  assert.equal(app.state.object, 'torsional.modified-bouc-wen');
  assert.equal(app.state.parameters['damper.parameters.viscousDampingBase'], 2345);
  assert.equal(app.state.parameters['damper.parameters.offset'], 0);
  app.run('fitDamper', { model: 'modified-bouc-wen', parameters: { viscousDampingBase: 1234 } });
  assert.equal(app.state.parameters['damper.parameters.viscousDampingBase'], 1234);
  app.run('undo');
  assert.equal(app.state.parameters['damper.parameters.viscousDampingBase'], 2345);
  assert.equal(app.session?.failure, null);
});
