import { test } from 'node:test';
import assert from 'node:assert/strict';
import { firstLook, lowness, projectionOf, turnedByDrag, turnedByKey } from '../../www/view/look.js';
import { drawOrbit } from '../../www/view/orbit.js';
import { voiceOf } from '../../www/words/voice.js';
import { numbersOf, recordingContext, written } from './plot-recorder.mjs';
import { engine } from './stories.mjs';
import { theme } from './theme.mjs';

const degree = Math.PI / 180;
const size = { width: 604, height: 420 };
const area = { left: 50, right: 550, top: 10, bottom: 390 };
const cycle = (/** @type {number} */ radius, count = 256) => {
  const at = (/** @type {(phase: number) => number} */ value) => Float64Array.from({ length: count }, (_, i) => value((4 * Math.PI * i) / count));
  return {
    torsionAngle: at((phase) => radius * Math.cos(phase)),
    torsionRate: at((phase) => -300 * radius * Math.sin(phase)),
    lateralDeformation: at((phase) => 0.2 * radius * Math.cos(phase - 0.8)),
  };
};
const motion = {
  limits: { angle: 20 * degree, rate: 100, deformation: 0.06 },
  look: firstLook,
  trail: cycle(10 * degree),
  orbit: cycle(15 * degree, 128),
  orbitLabel: 'the cycle it settles on',
  state: [5 * degree, 25, 0.03],
  freeplay: 0,
};

/** @param {object} [more] @param {'en' | 'tr'} [language] */
function drawn(more = {}, language = 'en', canvas = size) {
  const recorder = recordingContext();
  drawOrbit(recorder.context, canvas, { ...motion, ...more }, theme, voiceOf(language));
  return recorder;
}
const angles = [0, 20, 45, 90, 135, 180, -160, -90, -30].flatMap((yaw) => [0, 15, 40, 75, 90].map((pitch) => ({ yaw: yaw * degree, pitch: pitch * degree })));

test('from where it is seen first no cycle is seen on edge: not the opening one, not that of figure 5.88a', () => {
  const figure = engine.atlas().find(({ id }) => id === 'Figure 5.88a')?.run;
  assert.ok(figure);
  const opening = { model: 'torsional', parameters: { velocity: 80, dampingConstant: 20 }, initial: { torsionAngle: 0.05 } };
  for (const { model, parameters, initial } of [opening, figure]) {
    const { orbit } = engine.outlook({ model, parameters, initial });
    const most = (/** @type {Float64Array} */ series) => series.reduce((largest, value) => Math.max(largest, Math.abs(value)), 0);
    const shares = [orbit.torsionAngle, orbit.torsionRate, orbit.lateralDeformation].map((series) => Array.from(series, (value) => value / most(series)));
    const { scale, across, up } = projectionOf(firstLook, area);
    const points = shares[0].map((x, i) => [across(x, shares[1][i]), up(x, shares[1][i], shares[2][i])]);
    const doubled = points.reduce((sum, [x, y], i) => { const [x2, y2] = points[(i + 1) % points.length]; return sum + x * y2 - x2 * y; }, 0);
    // A circle of the box's half width, seen face on, has π.
    assert.ok(Math.abs(doubled) / 2 / scale ** 2 > 0.65 * Math.PI, `${Math.abs(doubled) / 2 / scale ** 2}`);
  }
});

test('the projection is a turn: seen from any side a sphere stays a circle of one size', () => {
  for (const look of angles) {
    const { scale, across, up } = projectionOf(look, area);
    // Three axes of equal length project to vectors whose squares sum to twice theirs; z is drawn lower by `lowness`.
    const origin = [across(0, 0), up(0, 0, 0)];
    const squares = [[1, 0, 0], [0, 1, 0], [0, 0, 1 / lowness]].map(([x, y, z]) => (across(x, y) - origin[0]) ** 2 + (up(x, y, z) - origin[1]) ** 2);
    assert.ok(Math.abs(squares.reduce((sum, one) => sum + one) / scale ** 2 - 2) < 1e-12);
  }
});

test('from the front ψ goes right and y up, from above ψ̇ goes up; the whole box stays in its area', () => {
  const level = projectionOf({ yaw: 0, pitch: 0 }, area);
  assert.ok(level.across(1, 0) > level.across(0, 0) && level.up(0, 0, 1) < level.up(0, 0, 0));
  assert.ok(level.nearness(0, -1, 0) > level.nearness(0, 1, 0));
  const above = projectionOf({ yaw: 0, pitch: Math.PI / 2 }, area);
  assert.ok(above.up(0, 1, 0) < above.up(0, 0, 0));
  assert.ok(Math.abs(above.up(0, 0, 1) - above.up(0, 0, 0)) < 1e-9);
  for (const look of angles) {
    const { across, up } = projectionOf(look, area);
    for (const x of [-1, 1]) for (const y of [-1, 1]) for (const z of [-1, 1]) {
      assert.ok(across(x, y) >= area.left - 1e-6 && across(x, y) <= area.right + 1e-6);
      assert.ok(up(x, y, z) >= area.top - 1e-6 && up(x, y, z) <= area.bottom + 1e-6);
    }
  }
});

test('a hand turns the front with it, never to below, and keys do the same', () => {
  const look = { yaw: 0.3, pitch: 0.4 };
  const front = (/** @type {import('../../www/view/look.js').Look} */ seen) => {
    const { across, up } = projectionOf(seen, area);
    return { x: across(Math.sin(-0.3), -Math.cos(0.3)), y: up(Math.sin(-0.3), -Math.cos(0.3), 0) };
  };
  assert.ok(front(turnedByDrag(look, 10, 0)).x > front(look).x);
  assert.ok(front(turnedByDrag(look, 0, 10)).y > front(look).y);
  assert.deepEqual(turnedByDrag(look, 0, 1e4).pitch, Math.PI / 2);
  assert.deepEqual(turnedByDrag(look, 0, -1e4).pitch, 0);
  assert.ok(Math.abs(turnedByDrag(look, 1e5, 0).yaw) <= Math.PI);
  assert.ok((turnedByKey(look, 'ArrowRight')?.yaw ?? 0) > look.yaw && (turnedByKey(look, 'ArrowDown')?.pitch ?? 0) > look.pitch);
  assert.ok(Math.abs((turnedByKey(look, 'ArrowLeft')?.yaw ?? 0) - look.yaw + 5 * degree) < 1e-12);
  assert.ok(Math.abs((turnedByKey(look, 'ArrowUp', true)?.pitch ?? 0) - look.pitch + degree) < 1e-12);
  assert.equal(turnedByKey(look, 'Enter'), null);
});

test('the present stands where the state says, and drops straight onto the floor', () => {
  const { named } = drawn();
  const [dot, foot] = [named('arc').at(-1), named('arc').findLast(({ style }) => style.fillStyle === theme.ink2)];
  assert.equal(dot?.style.fillStyle, theme.psi);
  assert.ok(foot && dot && Math.abs(foot.args[0] - dot.args[0]) < 1e-9 && foot.args[1] > dot.args[1]);
  // y = 30 of ±60 mm stands three quarters up the box.
  // The floor is drawn first, from (−1, −1) to (1, −1).
  const scale = (named('lineTo')[0].args[0] - named('moveTo')[0].args[0]) / (2 * Math.cos(firstLook.yaw));
  const height = (1 + 0.5) * lowness * Math.cos(firstLook.pitch) * scale;
  assert.ok(Math.abs(foot.args[1] - dot.args[1] - height) < 1e-6);
});

test('what is too fast for the screen is an arc in the box, with neither point nor drop', () => {
  const { named } = drawn({ exposed: cycle(10 * degree, 60) });
  assert.equal(named('arc').filter(({ args }) => args[2] > 2).length, 0);
  const arcs = named('stroke').filter(({ style }) => style.strokeStyle === theme.psi && style.lineWidth > 10);
  assert.equal(arcs.length, 1);
  assert.ok(arcs[0].style.globalAlpha < 0.5);
});

test('the trail is the fainter, the older and the farther; its shadow lies on the floor', () => {
  const { named } = drawn();
  const trail = named('stroke').filter(({ style }) => style.strokeStyle === theme.psi);
  assert.equal(trail.length, 64);
  // Two turns: pieces half the trail apart are at the same place, so as near.
  for (let i = 0; i < 32; i++) {
    assert.ok(trail[i].style.globalAlpha < trail[i + 32].style.globalAlpha);
    assert.ok(Math.abs(trail[i].style.lineWidth - trail[i + 32].style.lineWidth) < 0.2);
  }
  const widths = trail.slice(32).map(({ style }) => style.lineWidth);
  assert.ok(Math.max(...widths) > 1.4 * Math.min(...widths), 'no depth');
  const points = (/** @type {string} */ color, /** @type {number} */ width) => named('lineTo').filter(({ style }) => style.strokeStyle === color && style.lineWidth >= width && style.dash.length === 0).map(({ args }) => args);
  const shown = points(theme.psi, 1);
  const shadow = points(theme.ink2, 1.5);
  assert.equal(shadow.length, shown.length);
  shown.forEach(([x, y], i) => {
    assert.ok(Math.abs(shadow[i][0] - x) < 1e-9 && shadow[i][1] > y, 'the shadow is not straight below');
  });
});

test('the destination is dotted, ghosts are dashed, both closed; veiled there is neither name nor dots', () => {
  const { named } = drawn({ ghosts: [{ label: 'c = 40', orbit: cycle(12 * degree, 128) }] });
  const dotted = named('lineTo').filter(({ style }) => style.strokeStyle === theme.ink && style.dash.length > 0);
  const dashed = named('lineTo').filter(({ style }) => style.strokeStyle === theme.ghost && style.dash[0] === 6);
  // One line from each point to the next and back to the first, and the sample in the key.
  assert.equal(dotted.length, 128 + 1);
  assert.equal(dashed.length, 128 + 1);
  const veiled = drawn({ veiled: true });
  assert.equal(veiled.named('lineTo').filter(({ style }) => style.strokeStyle === theme.ink && style.dash.length > 0).length, 0);
  assert.ok(written(veiled.named('fillText')).includes('?') && !written(veiled.named('fillText')).includes(motion.orbitLabel));
});

test('the gap is a band on the floor, named', () => {
  assert.ok(!drawn().named('fill').some(({ style }) => style.fillStyle === theme.freeplay));
  const { named } = drawn({ freeplay: degree });
  assert.equal(named('fill').filter(({ style }) => style.fillStyle === theme.freeplay && style.globalAlpha === 0.25).length, 1);
  assert.ok(written(named('fillText')).includes('inside the gap: no spring'));
});

test('at any angle, words stay on the canvas, the three axes are named and numbers do not overlap', () => {
  for (const language of /** @type {const} */ (['en', 'tr']))
    for (const canvas of [size, { width: 390, height: 280 }, { width: 440, height: 500 }])
      for (const look of angles) {
        const { named, calls } = drawn({ look }, language, canvas);
        assert.ok(numbersOf(calls).every(Number.isFinite));
        const boxes = named('fillText').map(({ args: [text, x, y], style, at }) => {
          const width = text.length * 0.5 * parseFloat(style.font.match(/([\d.]+)px/)[1]);
          const start = style.textAlign === 'right' ? x - width : style.textAlign === 'center' ? x - width / 2 : x;
          const [[left, top], [right]] = [at(start, y), at(start + width, y)];
          assert.ok(Math.min(left, right) >= -1 && Math.max(left, right) <= canvas.width + 1 && top >= 0 && top <= canvas.height + 1, `"${text}" at ${left}, ${top} of ${canvas.width} × ${canvas.height}, ${look.yaw}, ${look.pitch}`);
          return { text, left, right, top };
        });
        const numbers = boxes.filter(({ text }) => /^−?[\d,.]+°?$/.test(text));
        numbers.forEach((one, i) => numbers.slice(i + 1).forEach((other) =>
          assert.ok(Math.abs(one.top - other.top) > 8 || one.right <= other.left + 1 || other.right <= one.left + 1, `${one.text} on ${other.text} at ${look.yaw}, ${look.pitch}`)));
        const symbols = boxes.filter(({ text }) => ['ψ', 'y'].includes(text)).length;
        // An axis that points at the viewer has no name: y from far above; level, from a corner's side, one of the others.
        const isHidden = look.pitch > 1 || (look.pitch === 0 && Math.abs(Math.sin(2 * look.yaw)) < 1e-9);
        assert.ok(symbols >= (isHidden ? 2 : 3), `${symbols} names at ${look.yaw}, ${look.pitch}`);
      }
});
