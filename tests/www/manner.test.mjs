// What the verdict says of a wheel that comes to rest: at rest only where it is, over the real engine.

import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { test } from 'node:test';
import init, * as engine from '../../www/pkg/shimmy.js';
import { destination } from '../../www/lens/destination.js';
import { mannerOf } from '../../www/stage/manner.js';
import { numbersOf, wordOf } from '../../www/stage/verdict-line.js';
import { voiceOf } from '../../www/words/voice.js';

await init({ module_or_path: await readFile(new URL('../../www/pkg/shimmy_bg.wasm', import.meta.url)) });

/** @param {Record<string, number>} parameters @param {Record<string, number>} initial */
const outlookOf = (parameters, initial) => engine.outlook({ model: 'torsional', parameters, initial });

/** The motion after some seconds. @param {Record<string, number>} parameters @param {Record<string, number>} initial @param {number} after */
function later(parameters, initial, after) {
  const { time: _, events: __, stats: ___, ...states } = engine.simulate({ model: 'torsional', parameters, initial, duration: after, samples: 2 });
  return outlookOf(parameters, Object.fromEntries(Object.entries(states).map(([name, series]) => [name, series[1]])));
}

/** @param {import('../../www/engine/engine.js').Outlook} outlook @param {'en' | 'tr'} [language] */
function told(outlook, language = 'en') {
  const voice = voiceOf(language);
  const line = numbersOf(outlook, voice).map(({ text }) => text).join(' · ');
  return { manner: mannerOf(outlook), word: voice.say(wordOf(outlook)), line, destination: destination(outlook, voice) };
}

// A long trailing arm at walking pace has no beat: e ψ̇ = −v ψ, so ψ falls by the factor e in e/v = 5 s.
const arm = { velocity: 1, dampingConstant: 0, casterLength: 5 };

test('a wheel that creeps back is not told to rest, in either language', () => {
  const outlook = later(arm, { torsionAngle: 0.05 }, 1);
  const { manner, word, line, destination: goal } = told(outlook);
  assert.equal(manner, 'creeps');
  assert.equal(word, 'It creeps to rest');
  assert.match(line, /^2\.\d+° from straight ahead and falling$/);
  assert.equal(goal, 'No limit cycle from here: the wheel creeps to rest.');
  const turkish = told(outlook, 'tr');
  assert.equal(turkish.word, 'Salınmadan duruyor');
  assert.match(turkish.line, /^düz doğrultudan 2,\d+°, azalıyor$/);
});

test('one that a huge damper holds creeps too, though the engine’s word for it is that it rests', () => {
  const outlook = outlookOf({ velocity: 1, dampingConstant: 5000 }, { torsionAngle: 0.05 });
  assert.equal(outlook.verdict, 'rests');
  assert.equal(told(outlook).manner, 'creeps');
});

test('one that swings on to a rest aside says where it will stand, and once it stands there that it does', () => {
  // Far ahead of its axis with a weak spring the tire turns the wheel aside and holds it there.
  const ahead = { velocity: 80, dampingConstant: 100, casterLength: -0.3, freeplayAngle: 0.3 };
  const outlook = outlookOf(ahead, { torsionAngle: 0.05 });
  const { manner, line, destination: goal } = told(outlook);
  assert.equal(manner, 'stops');
  assert.equal(line, 'It comes to a stop 19.9° from straight ahead.');
  assert.equal(goal, 'No limit cycle from here: the wheel comes to rest 19.9° from straight ahead.');
  const there = { ...outlook, present: { ...outlook.present, amplitude: outlook.amplitude.torsionAngle + 1e-6 } };
  assert.deepEqual(told(there), { manner: 'rests', word: 'It rests', line: 'It stands 19.9° from straight ahead.', destination: 'The wheel is at rest.' });
});

test('a wheel that friction stops is told to stick, and where', () => {
  // Within M_f/k = 400/1e5 rad = 0.23°.
  const rubbed = { velocity: 30, dampingConstant: 60, 'friction.moment': 400 };
  const swinging = told(outlookOf(rubbed, { torsionAngle: 0.05 }));
  assert.equal(swinging.manner, 'stops');
  assert.match(swinging.line, /^Friction will hold it at 0\.\d\d°\.$/);
  const held = outlookOf(rubbed, { torsionAngle: 0.002 });
  assert.deepEqual(told(held), { manner: 'rests', word: 'It sticks', line: 'Friction holds it at 0.11°.', destination: 'The wheel is at rest.' });
  assert.deepEqual([told(held, 'tr').word, told(held, 'tr').line], ['Takılı kaldı', 'Sürtünme onu 0,11° açıda tutuyor.']);
  assert.equal(told(outlookOf(rubbed, {})).line, 'Nothing moves. Kick the wheel.');
});

test('a wheel at rest rests, and swings keep their words', () => {
  assert.deepEqual(told(outlookOf({}, {})), { manner: 'rests', word: 'It rests', line: 'Nothing moves. Kick the wheel.', destination: 'The wheel is at rest.' });
  assert.equal(told(outlookOf({ velocity: 80, dampingConstant: 20 }, { torsionAngle: 0.05 })).manner, 'shimmies');
  const dying = told(outlookOf({ velocity: 80, dampingConstant: 60 }, { torsionAngle: 0.05 }));
  assert.equal(dying.manner, 'dies-out');
  assert.match(dying.line, /Hz/);
});

test('a swing on an unstable cycle is told to be on it, not to settle there', () => {
  const parameters = { velocity: 42, dampingConstant: 10, casterLength: -0.05, sideForceLimitAngle: (3 * Math.PI) / 180, aligningMomentLimitAngle: (20 * Math.PI) / 180 };
  const { cycles } = engine.bifurcation({ model: 'torsional', parameters, parameter: 'velocity', from: 42, to: 46 });
  const branch = cycles.find(({ stable }) => stable.includes(0));
  const place = branch?.velocity.indexOf(42) ?? -1;
  assert.ok(branch && place >= 0 && !branch.stable[place]);
  const initial = Object.fromEntries(Object.entries(branch.state).map(([name, series]) => [name, series[place]]));
  const { word, line, destination: goal } = told(outlookOf(parameters, initial));
  assert.equal(word, 'It shimmies');
  assert.equal(line, '±6.2° · 49.7 Hz · on an unstable cycle · a small push decides');
  assert.equal(goal, 'On an unstable cycle: ±6.163° (0.10756 rad) · 49.75 Hz');
  assert.match(told(outlookOf(parameters, initial), 'tr').destination, /^Kararsız çevrimde: ±6,163°/);
});
