import { test } from 'node:test';
import assert from 'node:assert/strict';
import { drawDeformationPortrait } from '../../www/view/deformation-portrait.js';
import { drawPhasePortrait } from '../../www/view/phase-portrait.js';
import { ghostDash } from '../../www/stage/gear/ghost.js';
import { freeCorner } from '../../www/view/corner.js';
import { firstLook } from '../../www/view/look.js';
import { drawOrbit } from '../../www/view/orbit.js';
import { ghostDashes } from '../../www/view/strokes.js';
import { voiceOf } from '../../www/words/voice.js';
import { numbersOf, recordingContext, written } from './plot-recorder.mjs';
import { theme } from './theme.mjs';

const degree = Math.PI / 180;
const size = { width: 604, height: 420 };
/** A cycle in which y lags ψ by 45°. @param {number} radius in rad */
const cycle = (radius, count = 128) => {
  const at = (/** @type {(phase: number) => number} */ value) => Float64Array.from({ length: count }, (_, i) => value((2 * Math.PI * i) / count));
  return {
    torsionAngle: at((phase) => radius * Math.cos(phase)),
    torsionRate: at((phase) => -300 * radius * Math.sin(phase)),
    lateralDeformation: at((phase) => 0.2 * radius * Math.cos(phase - Math.PI / 4)),
  };
};
const motion = {
  limits: { angle: 20 * degree, rate: 100, deformation: 0.06 },
  trail: cycle(10 * degree),
  orbit: cycle(15 * degree),
  orbitLabel: 'the cycle it settles on',
  state: [5 * degree, 25, -0.03],
  freeplay: 0,
};
const ghost = (/** @type {number} */ angle, /** @type {string} */ label) => ({ label, orbit: cycle(angle * degree) });

/** @param {typeof drawPhasePortrait | typeof drawDeformationPortrait} draw @param {object} [more] */
function drawn(draw, more = {}, area = size) {
  const recorder = recordingContext();
  draw(recorder.context, area, { ...motion, ...more }, theme, voiceOf('en'));
  return recorder;
}

test('y stands over ψ in millimeters, in its own color', () => {
  const { named } = drawn(drawDeformationPortrait);
  const words = written(named('fillText'));
  for (const number of ['20', '−40', '−20°']) assert.ok(words.includes(number), number);
  assert.ok(words.some((text) => text.includes('lateral deformation, mm')));
  const dot = named('arc').at(-1);
  assert.equal(dot?.style.fillStyle, theme.y);
  const [vertical, horizontal] = named('lineTo').filter(({ style }) => style.strokeStyle === theme.ghost).map(({ args }) => args);
  assert.ok(Math.abs((dot?.args[0] - vertical[0]) / (horizontal[0] - vertical[0]) - 0.25) < 0.01, '5° of 20°');
  assert.ok(Math.abs((dot?.args[1] - horizontal[1]) / (vertical[1] - horizontal[1]) - 0.5) < 0.01, '−30 mm of 60 mm');
});

test('what is too fast for the screen is an arc over the states of the exposure, and no point', () => {
  const all = cycle(12 * degree);
  const exposed = { torsionAngle: all.torsionAngle.slice(3, 90), torsionRate: all.torsionRate.slice(3, 90), lateralDeformation: all.lateralDeformation.slice(3, 90) };
  for (const [draw, color, present] of /** @type {const} */ ([[drawPhasePortrait, theme.psi, 'torsionRate'], [drawDeformationPortrait, theme.y, 'lateralDeformation']])) {
    const { named, calls } = drawn(draw, { exposed });
    assert.equal(named('arc').filter(({ args }) => args[2] > 2).length, 0, 'a single state can be read');
    const arcs = named('stroke').filter(({ style }) => style.strokeStyle === color && style.lineWidth > 10);
    assert.equal(arcs.length, 1);
    assert.ok(arcs[0].style.globalAlpha < 0.5, 'not translucent');
    // Its ends are those of the exposure: placed as a dot at these states would be.
    const end = calls.slice(0, calls.indexOf(arcs[0])).findLast(({ name }) => name === 'lineTo');
    const state = [exposed.torsionAngle[86], present === 'torsionRate' ? exposed.torsionRate[86] : 0, present === 'torsionRate' ? 0 : exposed.lateralDeformation[86]];
    const dot = drawn(draw, { state }).named('arc').at(-1);
    assert.ok(Math.hypot(end?.args[0] - dot?.args[0], end?.args[1] - dot?.args[1]) < 1e-9);
  }
});

test('a ghost is dashed, closed where it is a cycle, and named', () => {
  for (const draw of [drawPhasePortrait, drawDeformationPortrait]) {
    const { named } = drawn(draw, { ghosts: [ghost(12, 'c = 40 (shimmies)')] });
    const dashed = named('closePath').filter(({ style }) => style.strokeStyle === theme.ghost && style.dash.length > 0);
    assert.equal(dashed.length, 1);
    assert.deepEqual(dashed[0].style.dash, [6, 5]);
    assert.ok(written(named('fillText')).includes('ghost: c = 40 (shimmies)'));
    const open = drawn(draw, { ghosts: [{ label: 'c = 60', trail: cycle(4 * degree) }] });
    assert.equal(open.named('closePath').filter(({ style }) => style.strokeStyle === theme.ghost && style.dash.length > 0).length, 0);
  }
});

test('each of four ghosts has dashes of its own, the same at its curve, at its name and on the gear', () => {
  const ghosts = [12, 16, 8, 6].map((angle) => ghost(angle, `ψ = ${angle}°`));
  for (const draw of [drawPhasePortrait, drawDeformationPortrait, drawOrbit]) {
    const { named } = drawn(/** @type {typeof drawPhasePortrait} */ (draw), { ghosts, look: firstLook });
    const dashes = named('stroke').filter(({ style }) => style.strokeStyle === theme.ghost && style.dash.length > 0).map(({ style }) => style.dash.join());
    assert.deepEqual([...new Set(dashes)], ghostDashes.map((dash) => dash.join()));
    for (const dash of new Set(dashes)) assert.ok(dashes.filter((one) => one === dash).length >= 2, 'at the curve and at the name');
  }
  assert.deepEqual(ghostDashes.map((_, i) => ghostDash(/** @type {import('../../www/stage/gear/sheet.js').Sheet} */ ({ line: 1 }), i)), ghostDashes);
});

test('a ghost’s name too long for a phone leaves out what becomes of it', () => {
  const { named } = drawn(drawPhasePortrait, { ghosts: [ghost(12, 'e = 0.1 m, c = 5000, and more (creeps to rest)')] }, { width: 390, height: 280 });
  const words = written(named('fillText'));
  assert.ok(words.includes('ghost: e = 0.1 m, c = 5000, and more'), words.join(' | '));
});

test('several ghosts are told apart by numbers at their curves and names', () => {
  const { named } = drawn(drawPhasePortrait, { ghosts: [ghost(12, 'c = 40'), ghost(16, 'v = 60'), ghost(8, 'e = 0.2')] });
  const words = written(named('fillText'));
  for (const word of ['1: c = 40', '2: v = 60', '3: e = 0.2', '1', '2', '3']) assert.ok(words.includes(word), word);
  // The wider the cycle, the higher its number.
  const height = (/** @type {string} */ text) => named('fillText').find(({ args }) => args[0] === text)?.args[2];
  assert.ok(height('2') < height('1') && height('1') < height('3'));
});

test('what is veiled shows neither destination nor its name, but a question mark', () => {
  const { named } = drawn(drawPhasePortrait, { veiled: true });
  const words = written(named('fillText'));
  assert.ok(words.includes('?') && !words.includes(motion.orbitLabel));
  assert.equal(named('closePath').filter(({ style }) => style.strokeStyle === theme.ink && style.dash.length > 0).length, 0);
});

test('words keep off each other and stay on the canvas', () => {
  const ghosts = [ghost(12, 'c = 40 (shimmies)'), ghost(16, 'v = 60 (shimmies)')];
  for (const draw of [drawPhasePortrait, drawDeformationPortrait])
    for (const [width, height] of [[604, 420], [440, 500], [390, 280], [390, 174]]) {
      const { named, calls } = drawn(draw, { ghosts, freeplay: 0.5 * degree }, { width, height });
      assert.ok(numbersOf(calls).every(Number.isFinite));
      const keys = ['1: ', '2: ', 'the cycle', 'inside the gap'];
      const boxes = named('fillText').filter(({ args }) => keys.some((start) => args[0].startsWith(start))).map(({ args: [text, x, y], style }) => {
        const length = text.length * 0.5 * parseFloat(style.font.match(/([\d.]+)px/)[1]);
        const left = style.textAlign === 'center' ? x - length / 2 : x;
        assert.ok(left >= 0 && left + length <= width && y > 0 && y < height, `"${text}" at ${left}, ${y} of ${width} × ${height}`);
        return { left, right: left + length, y };
      });
      assert.ok(boxes.length >= 2, 'the names are missing');
      boxes.forEach((one, i) => boxes.slice(i + 1).forEach((other) =>
        assert.ok(Math.abs(one.y - other.y) > 8 || one.right <= other.left || other.right <= one.left, 'two names overlap')));
    }
});

test('on a phone the name of the destination stands beside that of the axis and costs the curves no height', () => {
  for (const language of /** @type {const} */ (['en', 'tr'])) {
    const recorder = recordingContext();
    const voice = voiceOf(language);
    drawPhasePortrait(recorder.context, { width: 390, height: 179 }, { ...motion, orbitLabel: voice.say('phase.heads.shimmies') }, theme, voice);
    const clip = recorder.named('rect')[0].args;
    assert.ok(clip[3] > 0.7 * 179, `the curves have ${clip[3]} of 179 px`);
    const word = recorder.named('fillText').find(({ args }) => args[0] === voice.say('phase.heads.shimmies'));
    assert.ok(word && word.args[2] > clip[1] + clip[3] && word.args[2] < 179);
  }
});

test('words go to the corner that no curve passes, and to the least passed where all are', () => {
  const frame = { left: 0, right: 400, top: 0, bottom: 300 };
  const label = { width: 100, height: 20 };
  const diagonal = { count: 400, x: (/** @type {number} */ i) => i, y: (/** @type {number} */ i) => (i * 3) / 4 };
  assert.deepEqual(freeCorner(frame, label, ['top-left', 'top-right'], [], []), { left: 0, right: 100, top: 0, bottom: 20 });
  assert.equal(freeCorner(frame, label, ['top-left', 'bottom-right', 'top-right'], [], [diagonal]).left, 300);
  assert.equal(freeCorner(frame, label, ['top-left', 'bottom-right', 'top-right'], [], [diagonal]).top, 0);
  const full = { count: 40_000, x: (/** @type {number} */ i) => i % 400, y: (/** @type {number} */ i) => 110 + Math.floor(i / 400) * 2 };
  const half = { count: 20_000, x: (/** @type {number} */ i) => 200 + (i % 200), y: (/** @type {number} */ i) => Math.floor(i / 200) * 3 };
  assert.equal(freeCorner(frame, label, ['bottom-right', 'bottom-left'], [], [full, half]).left, 0);
});
