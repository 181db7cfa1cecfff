// What the sliders' tracks tell beforehand, against the critical values of the closed form: c 22.808 at v = 30, 48.530 at
// v = 80; v 15.2593 at c = 0, 20.511 and 1040.97 at 10, 27.600 and 501.75 at 20, 51.881 and 205.13 at 40, none from 49.7927.

import { test } from 'node:test';
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import init, * as engine from '../../www/pkg/shimmy.js';
import { Quantity } from '../../www/controls/quantity.js';
import { scentOf } from '../../www/controls/scent.js';
import { gap, placeLabels } from '../../www/controls/scent-labels.js';
import { LinearTheory } from '../../www/run/linear-theory.js';
import { voiceOf } from '../../www/words/voice.js';

await init({ module_or_path: await readFile(new URL('../../www/pkg/shimmy_bg.wasm', import.meta.url)) });

/** @param {string} name */
const tableOf = (name) => /** @type {import('../../www/engine/engine.js').Model} */ (engine.models().find((model) => model.name === name));
/** @param {string} name @param {import('../../www/controls/unit.js').VelocityUnit} [unit] */
const quantity = (name, unit) => new Quantity(/** @type {Quantity['parameter']} */ (tableOf('torsional').parameters.find((parameter) => parameter.name === name)), unit);
/** @param {Record<string, number>} [some] @param {Record<string, boolean>} [links] @param {string} [object] */
const gear = (some = {}, links = {}, object = 'torsional') => {
  const usual = Object.fromEntries(tableOf(object).parameters.map((parameter) => [parameter.name, parameter.default]));
  return { object, parameters: { ...usual, ...some }, links };
};
const theory = new LinearTheory(engine);
/** @param {string} name @param {ReturnType<typeof gear>} of @param {{ language?: 'en' | 'tr', unit?: import('../../www/controls/unit.js').VelocityUnit }} [options] */
const scent = (name, of, { language = 'en', unit } = {}) => {
  const unstable = theory.unstable(of, name);
  assert.ok(unstable, `${name} has no scent`);
  return scentOf(unstable, quantity(name, unit), voiceOf(language));
};
/** @param {readonly { place: number }[]} marks @param {number[]} values @param {string} name @param {number} off */
const assertAt = (marks, values, name, off) => {
  assert.equal(marks.length, values.length);
  const { parameter: { min, max } } = quantity(name);
  marks.forEach(({ place }, i) => assert.ok(Math.abs(min + place * (max - min) - values[i]) <= off, `${min + place * (max - min)} is not ${values[i]}`));
};
const opening = { velocity: 80, dampingConstant: 20 };

test('the ticks stand at the critical values', () => {
  assertAt(scent('dampingConstant', gear({ velocity: 30 })).marks, [22.808], 'dampingConstant', 5e-4);
  assertAt(scent('dampingConstant', gear({ velocity: 80 })).marks, [48.53], 'dampingConstant', 5e-4);
  assertAt(scent('velocity', gear({ dampingConstant: 0 })).marks, [15.2593], 'velocity', 5e-5);
  assertAt(scent('velocity', gear({ dampingConstant: 20 })).marks, [27.6], 'velocity', 5e-4);
  assertAt(scent('velocity', gear({ dampingConstant: 40 })).marks, [51.881], 'velocity', 5e-4);
});

test('numbers are rounded to the side on which the swing dies out', () => {
  assert.deepEqual(scent('dampingConstant', gear({ velocity: 80 })).marks.map(({ number }) => number), ['48.6']);
  assert.deepEqual(scent('dampingConstant', gear({ velocity: 30 })).marks.map(({ number }) => number), ['22.9']);
  assert.deepEqual(scent('velocity', gear({ dampingConstant: 20 })).marks.map(({ number }) => number), ['27.6']);
  assert.deepEqual(scent('velocity', gear({ dampingConstant: 0 })).marks.map(({ number }) => number), ['15.2']);
  assert.deepEqual(scent('velocity', gear({ dampingConstant: 40 })).marks.map(({ number }) => number), ['51.8']);
  assert.deepEqual(scent('casterLength', gear(opening)).marks.map(({ number }) => number), ['−0.044', '0.319']);
  assert.deepEqual(scent('dampingConstant', gear({ velocity: 80 }), { language: 'tr' }).marks.map(({ number }) => number), ['48,6']);
});

test('each number by itself is stable, in every unit; a little to the other side is not', () => {
  for (const unit of /** @type {const} */ (['m/s', 'kn', 'km/h']))
    for (const dampingConstant of [0, 5, 20, 37, 40, 45]) {
      const [{ number }] = scent('velocity', gear({ dampingConstant }), { unit }).marks;
      const shown = quantity('velocity', unit);
      const stable = (/** @type {number} */ value) => engine.routhHurwitz({ model: 'torsional', parameters: { dampingConstant, velocity: shown.toSI(value) } }).stable;
      // What is nearer than a hundredth of the last digit to a round number is written as that number.
      assert.ok(stable(Number(number) - 0.01 * shown.grain), `${number} ${unit} at c = ${dampingConstant}`);
      assert.ok(!stable(Number(number) + 1.01 * shown.grain));
    }
});

test('what is hatched is unstable, and what is not is stable', () => {
  for (const name of tableOf('torsional-linear').parameters.map((parameter) => parameter.name))
    for (const start of /** @type {Record<string, number>[]} */ ([opening, { velocity: 30, dampingConstant: 20 }, { casterLength: -0.3 }, { torsionalStiffness: 5000, casterLength: -0.2 }])) {
      const of = gear(start);
      const { hatches } = scent(name, of);
      const shown = quantity(name);
      for (let place = 0.013; place < 1; place += 0.0517) {
        const { min, max } = shown.parameter;
        const value = shown.isLogarithmic ? min * (max / min) ** place : min + place * (max - min);
        const isHatched = hatches.some(({ from, to }) => place > from && place < to);
        assert.equal(isHatched, !engine.routhHurwitz({ model: 'torsional', parameters: { ...of.parameters, [name]: value } }).stable, `${name} = ${value}`);
      }
    }
});

test('the caption says what is on which side', () => {
  const captions = (/** @type {string} */ name, /** @type {ReturnType<typeof gear>} */ of, /** @type {'en' | 'tr'} */ language = 'en') => scent(name, of, { language }).captions;
  const damping = captions('dampingConstant', gear(opening));
  assert.deepEqual([damping.above, damping.below], [['dies out above'], ['shimmies below']]);
  const speed = captions('velocity', gear(opening));
  assert.deepEqual([speed.above, speed.below], [['shimmies above'], ['dies out below']]);
  assert.deepEqual(captions('casterLength', gear(opening)).between, ['shimmies between']);
  assert.deepEqual(captions('torsionalStiffness', gear(opening)).all, ['shimmies everywhere here']);
  assert.deepEqual(scent('velocity', gear({ dampingConstant: 60 })), {
    hatches: [], marks: [], captions: { above: [], below: [], between: [], all: [], least: [] }, inWords: 'dies out everywhere here',
  });
  assert.deepEqual(captions('dampingConstant', gear(opening), 'tr').above, ['üstünde sönüyor']);
});

test('a wheel without spring that leads its axis turns aside and does not shimmy', () => {
  const of = gear({ torsionalStiffness: 0, casterLength: -0.3 });
  assert.deepEqual(scent('dampingConstant', of).captions.all, ['turns aside everywhere here']);
  // At c = 200 the spring must outweigh the tire: k > −(c_Mα + e c_Fα) F_z = 36 kN m/rad.
  const stiffness = scent('torsionalStiffness', gear({ casterLength: -0.3, dampingConstant: 200, velocity: 5 }));
  assertAt(stiffness.marks, [36000], 'torsionalStiffness', 1);
  assert.deepEqual([stiffness.captions.above, stiffness.captions.below], [['dies out above'], ['turns aside below']]);
});

test('with freeplay it is linear theory alone, of the gear with its spring', () => {
  const of = gear({ velocity: 50, freeplayAngle: 0.0175 });
  const { marks, captions, inWords } = scent('dampingConstant', of);
  assert.deepEqual(marks.map(({ number }) => number), ['39.0']);
  assert.deepEqual(captions.above, ['linear theory, spring engaged: stable above', 'linear theory: stable above']);
  assert.equal(inWords, 'linear theory, spring engaged: stable above 39.0 N m s/rad');
  for (const name of ['velocity', 'casterLength', 'torsionalStiffness'])
    for (const language of /** @type {const} */ (['en', 'tr'])) {
      const told = scent(name, of, { language });
      assert.doesNotMatch(JSON.stringify(told), /dies out|shimm|sönüyor/);
      // However narrow a slider is in the dock, the reservation is there.
      for (const width of [150, 205, 240, 300]) assert.match(placeLabels(told, width, (text) => 6.6 * text.length).caption?.text ?? '', /^(linear theory|doğrusal kuram)/);
    }
});

test('with friction it is linear theory alone, of the gear without it', () => {
  const of = gear({ velocity: 80, 'friction.moment': 50 });
  const { marks, captions, inWords } = scent('dampingConstant', of);
  // The critical damping at 80 m/s, 48.530, as without friction.
  assert.deepEqual(marks.map(({ number }) => number), ['48.6']);
  assert.deepEqual(captions.above, ['linear theory, without friction: stable above', 'linear theory, no friction: stable above']);
  assert.equal(inWords, 'linear theory, without friction: stable above 48.6 N m s/rad');
  const both = scent('dampingConstant', gear({ velocity: 80, 'friction.moment': 50, freeplayAngle: 0.01 }));
  assert.deepEqual(both.captions.above, ['linear theory, spring engaged, without friction: stable above', 'linear theory, spring, no friction: stable above']);
  assert.match(scent('dampingConstant', of, { language: 'tr' }).inWords, /^doğrusal kuram, sürtünmesiz: /);
  assert.equal(theory.unstable(of, 'friction.moment'), null);
});

test('what does not enter linear theory has no scent; the linear gear has the same ones', () => {
  for (const name of ['sideForceLimitAngle', 'aligningMomentLimitAngle', 'freeplayAngle']) assert.equal(theory.unstable(gear(opening), name), null);
  for (const { name } of tableOf('torsional-linear').parameters)
    assert.deepEqual(new LinearTheory(engine).unstable(gear(opening, {}, 'torsional-linear'), name), new LinearTheory(engine).unstable(gear(opening), name));
  assert.equal(theory.unstable({ ...gear(opening), object: 'lorenz' }, 'velocity'), null);
});

test('what is linked follows along the slider', () => {
  const contact = (/** @type {Record<string, boolean>} */ links) => scent('halfContactLength', gear(opening, links));
  assert.deepEqual(contact({ relaxationLength: false, treadWidthMomentConstant: false }).captions.all, ['shimmies everywhere here']);
  const linked = contact({ relaxationLength: true, treadWidthMomentConstant: true });
  assert.deepEqual(linked.captions.between, ['shimmies between']);
  for (const { from, to } of linked.hatches)
    for (const place of [from + 0.01, to - 0.01, from - 0.01, to + 0.01]) {
      const halfContactLength = 0.01 + place * 0.29;
      // σ = 3a and κ = 0.15 a² c_Fα F_z.
      const follow = { relaxationLength: 3 * halfContactLength, treadWidthMomentConstant: 0.15 * halfContactLength ** 2 * 20 * 9000 };
      const { stable } = engine.routhHurwitz({ model: 'torsional', parameters: { ...opening, halfContactLength, ...follow } });
      assert.equal(stable, place < from || place > to, `${halfContactLength}`);
    }
});

test('it is asked anew when a value or a link has changed, and only then', () => {
  const asked = /** @type {string[]} */ ([]);
  const counting = new LinearTheory({
    ...engine, unstableIntervals: (run, variation) => { asked.push(variation.parameter); return engine.unstableIntervals(run, variation); },
  });
  const of = gear(opening);
  counting.unstable(of, 'velocity');
  assert.equal(counting.unstable({ ...of }, 'velocity'), counting.unstable(of, 'velocity'));
  assert.deepEqual(asked, ['velocity']);
  counting.unstable({ ...of, parameters: { ...of.parameters, dampingConstant: 30 } }, 'velocity');
  counting.unstable({ ...of, links: { relaxationLength: true } }, 'velocity');
  assert.equal(asked.length, 3);
});

test('the same in words, for who cannot see the track', () => {
  assert.equal(scent('dampingConstant', gear(opening)).inWords, 'dies out above 48.6 N m s/rad');
  assert.equal(scent('velocity', gear(opening)).inWords, 'shimmies above 27.6 m/s');
  assert.equal(scent('velocity', gear(opening), { unit: 'kn' }).inWords, 'shimmies above 53.6 kn');
  assert.equal(scent('casterLength', gear(opening)).inWords, 'shimmies between −0.044 m and 0.319 m');
  assert.equal(scent('verticalForce', gear(opening)).inWords, 'shimmies above 3.8 kN');
  assert.equal(scent('torsionalStiffness', gear(opening)).inWords, 'shimmies everywhere here');
  assert.equal(scent('dampingConstant', gear(opening), { language: 'tr' }).inWords, '48,6 N m s/rad üstünde sönüyor');
  // A soft spring, and a wheel that may lead far: aside at one end, shimmy in the middle.
  const { inWords, marks, captions } = scent('casterLength', gear({ torsionalStiffness: 30000, dampingConstant: 5 }));
  assert.equal(marks.length, 3);
  // With so many numbers the caption says which one it is of.
  assert.deepEqual([captions.above, captions.below], [[`dies out above ${marks[2].number}`], [`turns aside below ${marks[0].number}`]]);
  assert.equal(inWords, `turns aside below ${marks[0].number} m; shimmies between ${marks[1].number} m and ${marks[2].number} m`);
});

/** Every letter is 7 px wide. @param {string} text */
const measure = (text) => 7 * text.length;

test('labels never collide and never leave the track', () => {
  const captions = [
    { above: ['linear theory: stable above', 'linear: stable above'], below: ['linear theory: unstable below', 'linear: unstable below'], between: [], all: [], least: [] },
    { above: ['dies out above'], below: ['shimmies below'], between: ['shimmies between'], all: [], least: [] },
    { above: [], below: [], between: [], all: ['shimmies everywhere here'], least: [] },
  ];
  for (const width of [20, 60, 130, 190, 255, 450])
    for (const one of captions)
      for (const places of [[], [0], [0.02], [0.5], [1], [0.1, 0.12], [0.5, 0.8], [0.97, 1], [0, 0.4, 1], [0.3, 0.31, 0.32]]) {
        const marks = places.map((place) => ({ place, number: '−0.044' }));
        const { numbers, caption } = placeLabels({ marks, captions: one }, width, measure);
        const row = [...numbers, ...(caption?.row === 0 ? [caption] : [])].map(({ x, text }) => ({ from: x, to: x + measure(text) }));
        for (const { from, to } of [...row, ...(caption ? [{ from: caption.x, to: caption.x + measure(caption.text) }] : [])])
          assert.ok(from >= 0 && to <= width, `${from} … ${to} of ${width}`);
        row.sort((a, b) => a.from - b.from).forEach(({ from }, i) => assert.ok(i === 0 || from - row[i - 1].to >= gap - 1e-9, JSON.stringify({ width, places, row })));
        if (width >= 190) assert.equal(numbers.length, places.length, 'a number is left out');
      }
});

test('the caption stands by its number, and takes the second row before it is left out', () => {
  const captions = { above: ['dies out above'], below: ['shimmies below'], between: [], all: [], least: [] };
  const at = (/** @type {number} */ place, width = 255) => placeLabels({ marks: [{ place, number: '48.6' }], captions }, width, measure);
  assert.deepEqual(at(0.2).caption, { x: 51 + 14 + gap, text: 'dies out above', row: 0 });
  assert.deepEqual(at(0.9).caption, { x: 229.5 - 14 - gap - 98, text: 'shimmies below', row: 0 });
  assert.deepEqual(at(0.5, 180).caption, { x: 90 - 49, text: 'dies out above', row: 1 });
  assert.equal(at(0.5, 90).caption, null);
  const long = { above: ['linear theory: stable above', 'linear: stable above'], below: [], between: [], all: [], least: [] };
  assert.equal(placeLabels({ marks: [{ place: 0.3, number: '39.0' }], captions: long }, 255, measure).caption?.text, 'linear: stable above');
});
