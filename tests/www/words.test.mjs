import { test } from 'node:test';
import assert from 'node:assert/strict';
import { readFile, readdir } from 'node:fs/promises';
import { languages, voiceOf } from '../../www/words/voice.js';

const { en, tr } = languages;
const placeholders = (/** @type {string} */ text) => [...text.matchAll(/\{(\w+)\}/g)].map(([, name]) => name).sort();

test('both languages have the same words, with the same places to fill', () => {
  assert.deepEqual(Object.keys(tr).sort(), Object.keys(en).sort());
  for (const key of /** @type {(keyof typeof en)[]} */ (Object.keys(en)))
    assert.deepEqual(placeholders(tr[key]), placeholders(en[key]), key);
});

test('every word that the page asks for is there, and every word there is asked for', async () => {
  const root = new URL('../../www/', import.meta.url);
  const files = (await readdir(root, { recursive: true }))
    .filter((name) => /\.js$/.test(name) && !/^(pkg|words)\//.test(name));
  const source = (await Promise.all(files.map((name) => readFile(new URL(name, root), 'utf8')))).join('\n');
  const asked = new Set([...source.matchAll(/\bsay\(\s*(?:[^'`)]*\? )?'([\w.-]+)'/g)].map(([, key]) => key));
  for (const key of asked) assert.ok(Object.hasOwn(en, key), `no word for ${key}`);
  const used = (/** @type {string} */ key) =>
    source.includes(`'${key}'`) || [...source.matchAll(/`([\w.-]*)\$\{[^}]+\}([\w.-]*)`/g)]
      .some(([, head, tail]) => head.includes('.') && key.startsWith(head) && key.endsWith(tail));
  for (const key of Object.keys(en)) assert.ok(used(key), `${key} is never said`);
});

test('a voice fills places and writes numbers in its language', () => {
  assert.equal(voiceOf('en').say('clock.slow', { slow: 50 }), 'Slow 1/50');
  assert.equal(voiceOf('tr').say('clock.slow', { slow: 50 }), 'Yavaş 1/50');
  assert.equal(voiceOf('tr').number(15.2, 1), '15,2');
});
