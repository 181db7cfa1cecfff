// Labels stay on the canvas and clear of the wheel and of each other, whatever the state.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { gearEn, gearTr } from '../../www/words/gear.js';
import { Placer } from '../../www/stage/gear/placer.js';
import { grabTarget } from '../../www/stage/gear/grab.js';
import { DEGREE, record, sceneOf, sizes } from './gear-scene.mjs';

/** @typedef {import('../../www/stage/gear/scene.js').LayoutName} LayoutName */
/** @typedef {{left: number, right: number, top: number, bottom: number, text: string}} Line */

/** A repeatable sequence of numbers in 0 … 1. @param {number} seed */
function sequence(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

/** @param {() => number} random */
function randomScene(random) {
  const magnification = [1, 2, 5, 10, 20, 50][Math.floor(6 * random())];
  const layout = /** @type {LayoutName[]} */ (['desktop', 'projector', 'phone', 'big'])[Math.floor(4 * random())];
  const within = (/** @type {number} */ size) => (2 * random() - 1) * size;
  const swing = ((8 + 12 * random()) * DEGREE) / magnification;
  const freeplayAngle = random() < 0.5 ? 0 : random() * 2 * DEGREE;
  const poseOfGhost = () => sceneOf({ psi: within(swing), y: within(0.25 * swing), swing: 0.5 * swing }, { magnification });
  const ghosts = Array.from({ length: Math.floor(4 * random()) }, (_, i) => ({ ...poseOfGhost(), label: `c = ${10 * i}` }));
  const fan = Array.from({ length: 16 }, () => ({ psi: within(swing), y: within(0.25 * swing) }));
  return sceneOf(
    { psi: within(swing), y: within(0.25 * swing), swing: 0.5 * swing, shift: within(3) },
    {
      magnification,
      layout,
      ghosts,
      fan: random() < 0.15 ? fan : null,
      extremes: [-swing, swing],
      forceScale: { force: 60_000 * 0.25 * swing, moment: 20_000 * 0.25 * swing },
      parameters: { casterLength: within(0.5), velocity: 1 + 119 * random(), freeplayAngle },
    },
  );
}

/**
 * Lines of text as boxes: runs that follow each other on a line are one.
 *
 * @param {import('./recording-context.mjs').RecordingContext} context
 * @returns {Line[]}
 */
function linesOf({ texts }) {
  /** @type {Line[]} */
  const lines = [];
  for (const { text, x, y, width, size, halo } of texts) {
    if (halo) continue;
    const last = lines.at(-1);
    if (last && Math.abs(last.right - x) < 1e-6) {
      last.right = x + width;
      last.text += text;
      continue;
    }
    lines.push({ left: x, right: x + width, top: y - 0.5 * size, bottom: y + 0.5 * size, text });
  }
  return lines;
}

/** @param {Line} a @param {Line} b */
const touch = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

/** @param {{x: number, y: number}} point @param {Line} line */
const inside = (point, line) =>
  point.x > line.left && point.x < line.right && point.y > line.top && point.y < line.bottom;

/** The outline of the wheel, or of all the fan's. @param {import('./gear-scene.mjs').Scene} scene */
function wheelsOf(scene) {
  const poses = scene.fan ?? [{ psi: scene.state[0], y: scene.state[2] }];
  return poses.flatMap(({ psi, y }) => grabTarget(sizes[scene.layout], { ...scene, state: [psi, 0, y], fan: null }).outline);
}

test('in 1000 random states no label leaves the canvas or touches another or the wheel', () => {
  const random = sequence(7);
  for (let i = 0; i < 1000; i++) {
    const scene = randomScene(random);
    const { width, height } = sizes[scene.layout];
    const context = record(scene, i % 2 ? gearTr : gearEn);
    const state = JSON.stringify([scene.layout, scene.state, scene.magnification, scene.parameters]);
    assert.equal(context.depth, 0);
    const lines = linesOf(context);
    const moving = lines.filter(({ text }) => /^[ψyαFM]/.test(text));
    const outline = wheelsOf(scene);
    lines.forEach((line, k) => {
      assert.ok(
        line.left >= 0 && line.right <= width && line.top >= 0 && line.bottom <= height,
        `"${line.text}" leaves the canvas at ${state}`,
      );
      for (const other of lines.slice(k + 1)) {
        assert.ok(!touch(line, other), `"${line.text}" touches "${other.text}" at ${state}`);
      }
    });
    for (const line of moving) {
      assert.ok(!outline.some((point) => inside(point, line)), `"${line.text}" is on the wheel at ${state}`);
    }
  }
});

test('ψ and the side force are named in nearly every state', () => {
  const random = sequence(11);
  const seen = { psi: 0, force: 0, states: 0 };
  for (let i = 0; i < 600; i++) {
    const scene = randomScene(random);
    if (scene.fan || Math.abs(scene.parameters.casterLength - 0.1) > 0.1) continue;
    if (Math.abs(scene.forces.sideForce) < 0.2 * scene.forceScale.force) continue;
    const lines = linesOf(record(scene)).map(({ text }) => text);
    seen.states++;
    if (lines.some((text) => text.startsWith('ψ'))) seen.psi++;
    if (lines.some((text) => text.startsWith('Fy'))) seen.force++;
  }
  assert.ok(seen.states > 50);
  assert.ok(seen.psi > 0.98 * seen.states, JSON.stringify(seen));
  assert.ok(seen.force > 0.95 * seen.states, JSON.stringify(seen));
});

test('numbers are true whatever the magnification, and written in the page’s language', () => {
  const scene = sceneOf({ psi: 1.2 * DEGREE, y: 0.0038, swing: 0.01 }, { magnification: 10 });
  const english = linesOf(record(scene)).map(({ text }) => text);
  assert.ok(english.includes('ψ +1.2°'), english.join(' | '));
  assert.ok(english.includes('y 3.8 mm'), english.join(' | '));
  assert.ok(english.includes('TOP: angles and tire drawn ×\u200910,'), english.join(' | '));
  assert.ok(english.includes('the scale shows true degrees'), english.join(' | '));
  const turkish = linesOf(record(scene, gearTr)).map(({ text }) => text);
  assert.ok(turkish.includes('ψ +1,2°'), turkish.join(' | '));
});

test('a model without speed, limits and freeplay is drawn too, and no speed is made up', () => {
  const scene = sceneOf({ psi: 0.1, y: 0.02 });
  const { casterLength, halfContactLength, relaxationLength } = scene.parameters;
  const bare = { ...scene, parameters: { casterLength, halfContactLength, relaxationLength } };
  const said = linesOf(record(bare)).map(({ text }) => text);
  assert.ok(said.includes('ψ +5.7°') && said.includes('caster e 100 mm'), said.join(' | '));
  assert.ok(!said.some((text) => text.startsWith('v')), said.join(' | '));
  const nothing = linesOf(record({ ...scene, parameters: {} })).map(({ text }) => text);
  assert.ok(nothing.includes('caster e 0 mm') && nothing.includes('2a 200 mm'), nothing.join(' | '));
});

test('the protractor shows true degrees', () => {
  const ticks = (/** @type {number} */ magnification) =>
    linesOf(record(sceneOf({ swing: 0 }, { magnification })))
      .map(({ text }) => text)
      .filter((text) => /^[+−0][\d.]*°?$/.test(text));
  assert.deepEqual(ticks(1), ['−20°', '−10°', '0', '+10°', '+20°']);
  assert.deepEqual(ticks(10), ['−2°', '−1°', '0', '+1°', '+2°']);
  assert.deepEqual(ticks(50), ['−0.4°', '−0.2°', '0', '+0.2°', '+0.4°']);
});

test('the side view tells whether the wheel trails or leads its axis', () => {
  const said = (/** @type {number} */ casterLength) =>
    linesOf(record(sceneOf({}, { parameters: { casterLength } }))).map(({ text }) => text);
  assert.ok(said(0.1).includes(gearEn.wheelTrails));
  assert.ok(said(-0.1).includes(gearEn.wheelLeads));
  assert.ok(said(-0.1).some((text) => text.endsWith('e −100 mm')));
  assert.ok(said(0).includes(gearEn.wheelCentered));
});

test('wild values are drawn without a wild number', () => {
  for (const wild of [1e6, -1e300, NaN, Infinity]) {
    const scene = sceneOf({ swing: 0.1 });
    record({ ...scene, state: [wild, wild, wild], extremes: [-wild, wild] });
    record({ ...scene, forces: { ...scene.forces, sideForce: wild, aligningMoment: wild, springAngle: wild } });
  }
});

test('a label takes its first free wish, else the nearest free place, else none', () => {
  const placer = new Placer({ x: 0, y: 0, width: 100, height: 40 });
  placer.blockBox({ x: 0, y: 0, width: 50, height: 40 });
  assert.deepEqual(placer.place(20, 10, [{ x: 40, y: 0 }, { x: 60, y: 5 }]), { x: 60, y: 5, width: 20, height: 10 });
  const near = placer.place(20, 10, [{ x: 40, y: 20 }]);
  assert.ok(near && near.x >= 50 && near.y >= 15);
  assert.equal(placer.place(60, 10, [{ x: 40, y: 20 }]), null);
});

test('a slanted obstacle blocks what it covers and not its whole box', () => {
  const placer = new Placer({ x: 0, y: 0, width: 100, height: 100 });
  placer.blockLine({ x: 0, y: 0 }, { x: 100, y: 100 }, 4);
  assert.equal(placer.place(20, 20, [{ x: 75, y: 5 }])?.x, 75);
  assert.notDeepEqual(placer.place(20, 20, [{ x: 40, y: 40 }]), { x: 40, y: 40, width: 20, height: 20 });
});

test('a label is there or it is not, however small what it names', () => {
  for (const y of [0, 0.0005, 0.004, 0.008, 0.012, 0.03])
    for (const { text, opacity } of record(sceneOf({ psi: 0.05, y })).texts) assert.equal(opacity, 1, `${text} at ${y} m`);
});
