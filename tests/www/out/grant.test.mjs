import assert from 'node:assert/strict';
import { test } from 'node:test';
import { grant } from '../../../www/out/grant.js';
import { linkOfFile } from '../../../www/out/link-of-file.js';
import { voiceOf } from '../../../www/words/voice.js';
import { shimmy } from '../../node/module.mjs';
import { tableOf } from './runs.mjs';

const material = {
  engine: shimmy, table: tableOf('torsional'), duration: 2, link: 'https://example.org/#shimmy=1',
  experiment: { object: 'torsional', parameters: { velocity: 80 }, run: { initial: {} } },
};
/** @param {object} navigator @returns {import('../../../www/out/download.js').Place} */
const placeWith = (navigator) => /** @type {any} */ ({ navigator, document: {} });

test('a link is copied, or said to be for copying by hand', async () => {
  /** @type {string[]} */
  const copied = [];
  const says = (/** @type {object} */ navigator) => grant({ what: 'link', view: '' }, material, voiceOf('en'), placeWith(navigator));
  assert.equal(await says({ clipboard: { writeText: async (/** @type {string} */ text) => copied.push(text) } }), 'The link is copied.');
  assert.deepEqual(copied, [material.link]);
  const byHand = 'This browser does not let the page copy. Copy the link by hand.';
  assert.equal(await says({ clipboard: { writeText: () => Promise.reject(new Error('not allowed')) } }), byHand);
  assert.equal(await says({}), byHand);
});

test('what the engine refuses is told in its words', async () => {
  const experiment = { ...material.experiment, parameters: { velocity: -3 } };
  assert.equal(await grant({ what: 'csv', view: '' }, { ...material, experiment }, voiceOf('en'), placeWith({})),
    'That could not be made: velocity must be > 0 m/s, got -3');
});

test('a picture without a view is a mistake of the page, and told', async () => {
  assert.match(await grant({ what: 'png', view: 'phase' }, material, voiceOf('tr'), placeWith({})), /^Bu yapılamadı: /);
});

test('a saved file leads to its link, another to a sentence', () => {
  const voice = voiceOf('en');
  assert.deepEqual(linkOfFile({ name: 'a.json', text: '{"model": "torsional", "parameters": {"velocity": 60}}' }, voice),
    { link: '#shimmy=2&model=torsional&velocity=60', said: '' });
  assert.deepEqual(linkOfFile({ name: 'holiday.jpg', text: '\u{fffd}' }, voice),
    { link: '', said: 'No run could be read from holiday.jpg.' });
});
