import { test } from 'node:test';
import assert from 'node:assert/strict';
import { figuresOf } from '../../www/story/atlas.js';
import { presets } from '../../www/story/presets.js';
import { indexOf, search } from '../../www/story/search.js';
import { voiceOf } from '../../www/words/voice.js';
import { engine } from './stories.mjs';

const index = indexOf([...presets, ...figuresOf(engine.atlas())], [voiceOf('en'), voiceOf('tr')]);
const found = (/** @type {string} */ query) => search(index, query).map(({ story }) => story.name);

test('nothing typed finds all, presets first', () => {
  assert.equal(found('').length, presets.length + 283);
  assert.deepEqual(found('').slice(0, 2), ['first-look', 'quiet-taxi']);
});

test('a figure is found by its number, whole or begun', () => {
  assert.deepEqual(found('5.88a'), ['figure-5.88a']);
  assert.deepEqual(found('5.88'), ['figure-5.88a', 'figure-5.88b', 'figure-5.88c', 'figure-5.88d']);
  assert.deepEqual(found('5,88B'), ['figure-5.88b']);
  assert.deepEqual(found('figure 6.1').slice(0, 3), ['figure-6.1', 'figure-6.10', 'figure-6.11']);
  assert.deepEqual(found('table 5.8'), ['table-5.8']);
  assert.deepEqual(found('tablo 5.8'), ['table-5.8']);
  assert.deepEqual(found('şekil a.3'), ['figure-a.3']);
});

test('values are found by symbol or by word, exactly where they occur', () => {
  const freeplay = found('freeplay 1 deg');
  assert.ok(freeplay.includes('figure-6.4') && freeplay.includes('double-gap') && freeplay.includes('figure-6.23a'));
  assert.ok(!freeplay.includes('figure-6.5') && !freeplay.includes('figure-6.3'), '1 is neither 1.5 nor 0.5');
  assert.deepEqual(found('boşluk 1°'), freeplay);
  const both = found('v 50 c 100');
  assert.deepEqual(found('v=50 m/s, c=100 N m s/rad'), both);
  assert.deepEqual(found('hız 50 sönüm 100'), both);
  for (const { story } of search(index, 'v 50 c 100'))
    assert.ok(story.steps.some(({ state: { parameters } }) => parameters.velocity === 50 && parameters.dampingConstant === 100), story.name);
  assert.ok(both.length > 20);
  assert.ok(!found('c 10').includes('figure-5.72'), 'c = 100 is not c = 10');
  assert.ok(found('v 5').includes('figure-5.72'), 'nothing has v = 5, so what begins with it');
  assert.ok(found('psi(0) 1').every((name) => /figure-5\.9[4-9]|table-5\.1[01]/.test(name)));
});

test('shimmy is found as it is heard and by its other names, with or without marks', () => {
  const shimmy = found('shimmy');
  assert.ok(shimmy.includes('growing') && shimmy.includes('linear'));
  for (const query of ['şimmy', 'simmy', 'şimmi', 'simmi', 'şimi', 'simi', 'ŞİMMİ', 'ŞIMMY', 'SHIMMI', 'yalpa', 'yalpalama', 'titreşim', 'titresim', 'wobble'])
    assert.deepEqual(found(query), shimmy, query);
  assert.deepEqual(found('büyüyen şimi'), ['growing']);
  assert.deepEqual(found('şimendifer'), []);
});

test('words of both languages are found, with or without their marks', () => {
  for (const query of ['boşluk', 'bosluk', 'BOŞLUK', 'freeplay']) assert.ok(found(query).includes('freeplay') && found(query).includes('figure-6.3'), query);
  assert.ok(found('takırtı').includes('double-gap'));
  assert.ok(found('takirti').includes('double-gap'));
  assert.ok(found('İLK').includes('first-look'));
  assert.deepEqual(found('limit cycle orbit'), found('limit çevrim uzayda'));
  assert.equal(found('limit cycle orbit').length, 28);
  assert.deepEqual(found('no such thing'), []);
});
