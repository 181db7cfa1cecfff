// Roots in the complex plane, their ways, and where a pair crosses the axis.

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { Loci } from '../../www/lens/stability/loci.js';
import { RootsLimits } from '../../www/lens/stability/roots-limits.js';
import { RootsWalk, crossingBetween } from '../../www/lens/stability/roots-walk.js';
import { becomes, becomesBriefly, becomesInSigns, becomesInTheory, lineInTheory } from '../../www/lens/stability/say.js';
import { linearLooks } from '../../www/run/linear-looks.js';
import { modeLabel } from '../../www/stage/ghost-label.js';
import { drawComplexPlane } from '../../www/view/complex-plane.js';
import { drawRootLocus } from '../../www/view/root-locus.js';
import { pathsOf, pathsThrough } from '../../www/view/root-paths.js';
import { drawRoots } from '../../www/view/roots.js';
import { voiceOf } from '../../www/words/voice.js';
import { criticalSpeeds, cubicOf, rootsOf, usual } from './linear-gear.mjs';
import { recordingContext, written } from './plot-recorder.mjs';
import { engine } from './stories.mjs';
import { theme } from './theme.mjs';

const voice = voiceOf('en');
const size = { width: 300, height: 200 };
const limits = { left: -40, right: 20, top: 400 };
const circle = 2 * Math.PI;
const near = (/** @type {number} */ one, /** @type {number} */ other, by = 1e-6) => assert.ok(Math.abs(one - other) <= by, `${one} for ${other}`);

const unstable = rootsOf({ velocity: 80, dampingConstant: 30 });
const shown = { roots: unstable, trail: [], crossing: null, readings: ['53.8 Hz'], limits };
const places = drawComplexPlane(recordingContext().context, size, limits, theme, voice);

test('a pair is a cross at its place, in the color of what it does; its mirror image is left out', () => {
  for (const [values, color] of /** @type {const} */ ([[{ velocity: 80, dampingConstant: 30 }, theme.unstable], [{ velocity: 80, dampingConstant: 60 }, theme.stable]])) {
    const roots = rootsOf(values);
    const [pair] = roots;
    const { context, named } = recordingContext();
    drawRoots(context, size, { ...shown, roots }, theme, voice);
    const arms = named('moveTo', 'lineTo').filter(({ style }) => style.lineCap === 'round' && style.strokeStyle === color);
    assert.equal(arms.length, 4);
    near(arms.reduce((sum, { args }) => sum + args[0], 0) / 4, places.x(pair.re));
    near(arms.reduce((sum, { args }) => sum + args[1], 0) / 4, places.y(pair.im));
  }
});

test('a root beyond the picture is an arrow at its edge with its number', () => {
  const { context, named } = recordingContext();
  drawRoots(context, size, shown, theme, voice);
  const real = unstable.find(({ im }) => im === 0);
  assert.ok(real && real.re < limits.left);
  assert.ok(written(named('fillText')).includes(voice.number(real.re, 0)));
  const [tip] = named('moveTo').filter(({ style }) => style.fillStyle === theme.stable).slice(-1);
  near(tip.args[0], places.frame.left);
});

test('rays have their damping ratio and rings their natural frequency', () => {
  const { context, named } = recordingContext();
  drawComplexPlane(context, size, limits, theme, voice);
  const dotted = named('lineTo').filter(({ style }) => style.dash.length > 0);
  const ratios = written(named('fillText')).filter((text) => text.startsWith('ζ')).map((text) => Number(text.slice(2)));
  assert.ok(dotted.length > 0 && dotted.length === ratios.length);
  dotted.forEach(({ args: [x, y] }, i) => {
    const re = limits.left + ((x - places.frame.left) / (places.frame.right - places.frame.left)) * 60;
    const im = (1 - (y - places.frame.top) / (places.frame.bottom - places.frame.top)) * 400;
    near(-re / Math.hypot(re, im), ratios[i], 1e-9);
  });
  for (const { args: [x, y, , radiusY] } of named('ellipse')) {
    near(x, places.x(0));
    near(y, places.y(0));
    const frequency = radiusY / (places.y(0) - places.y(1)) / circle;
    near(frequency, Math.round(frequency), 1e-9);
  }
});

test('the unstable half is hatched, and no more', () => {
  const { context, named } = recordingContext();
  drawComplexPlane(context, size, limits, theme, voice);
  const ends = named('moveTo', 'lineTo').filter(({ style }) => style.strokeStyle === theme.unstable);
  assert.ok(ends.length > 10 && ends.every(({ args: [x] }) => x >= places.x(0) - 1e-3 && x <= places.frame.right + 1e-3));
});

test('a crossing is marked on the axis with its kind; veiled, there is nothing of all this', () => {
  const crossing = { at: { re: 0, im: 314 }, text: 'Hopf, 50.0 Hz' };
  const { context, named } = recordingContext();
  drawRoots(context, size, { ...shown, crossing, trail: [[{ re: -10, im: 300 }, { re: 10, im: 310 }]] }, theme, voice);
  assert.deepEqual(named('arc')[0].args.slice(0, 2), [places.x(0), places.y(314)]);
  assert.ok(written(named('fillText')).includes('Hopf, 50.0 Hz'));
  const hidden = recordingContext();
  drawRoots(hidden.context, size, { ...shown, crossing, veiled: true }, theme, voice);
  assert.ok(hidden.named('stroke').every(({ style }) => ![theme.unstable, theme.stable].includes(style.strokeStyle)));
  assert.ok(!written(hidden.named('fillText')).some((text) => /Hz|ζ/.test(text)));
});

test('a root keeps its way though the order of the roots changes', () => {
  const at = (/** @type {number} */ t) => [{ re: -10 + 20 * t, im: 300 }, { re: -10 + 20 * t, im: -300 }, { re: 5 - 20 * t, im: 0 }].sort((one, other) => other.re - one.re || other.im - one.im);
  const paths = pathsThrough(Array.from({ length: 21 }, (_, i) => at(i / 20)));
  for (const path of paths) assert.ok(path.every(({ im }) => im === path[0].im));
  near(paths.find(([{ im }]) => im === 0)?.at(-1)?.re ?? NaN, -15);
});

test('the walk finds where the pair crossed: at the critical values, with ω² = a₁', () => {
  for (const [dampingConstant, speed] of criticalSpeeds) {
    const from = { ...usual, dampingConstant, velocity: 0.8 * speed };
    const to = { ...usual, dampingConstant, velocity: 1.1 * speed };
    const crossing = crossingBetween(rootsOf, from, to);
    assert.ok(crossing);
    assert.equal(crossing.kind, 'hopf');
    assert.equal(crossing.isStable, false);
    const [, a1] = cubicOf({ ...usual, dampingConstant, velocity: speed });
    near(crossing.at.im, Math.sqrt(a1), 2e-3);
    near(crossing.at.re, 0, 1e-6);
    assert.equal(crossingBetween(rootsOf, to, from)?.isStable, true);
  }
  // A soft wheel that leads its axis turns aside: a real root crosses.
  const soft = { ...usual, torsionalStiffness: 20_000, dampingConstant: 300 };
  const aside = crossingBetween(rootsOf, { ...soft, casterLength: 0.5 }, { ...soft, casterLength: -0.5 });
  assert.equal(aside?.kind, 'divergence');
  // k = −(c_Mα + e c_Fα)F_z at the boundary, so the tire's moment has taken all of the spring's: e is −0.2111.
  near(cubicOf({ ...soft, casterLength: -(20_000 / 9000 + 2) / 20 })[2], 0, 1e-6);
  const leap = crossingBetween((values) => [{ re: values.gap > 0 ? 5 : -5, im: 100 }], { gap: 0 }, { gap: 1 });
  assert.equal(leap, null);
});

/** A gear whose linear theory is the test's own. @param {Record<string, number>} values */
const gear = (values) => ({
  object: 'torsional', parameters: { ...usual, ...values },
  linear: /** @type {import('../../www/run/linear-looks.js').LinearLooks} */ (/** @type {unknown} */ ({ eigenvalues: (/** @type {object} */ others) => rootsOf({ ...usual, ...values, ...others }) })),
});

test('a walk grows while values change and begins anew after a rest; a crossing is told once', () => {
  const walk = new RootsWalk();
  walk.follow(gear({ velocity: 20, dampingConstant: 20 }), 0);
  assert.equal(walk.follow(gear({ velocity: 20, dampingConstant: 20 }), 0.5), 'same');
  assert.equal(walk.follow(gear({ velocity: 25, dampingConstant: 20 }), 10), 'changed');
  assert.equal(walk.follow(gear({ velocity: 30, dampingConstant: 20 }), 10.1), 'crossed');
  assert.equal(walk.trail.length, 3);
  near(walk.crossing?.at.im ?? NaN, Math.sqrt(cubicOf({ velocity: 27.6, dampingConstant: 20 })[1]), 0.01);
  assert.equal(walk.follow(gear({ velocity: 35, dampingConstant: 20 }), 10.2), 'changed');
  assert.ok(walk.crossing);
  assert.equal(walk.follow(gear({ velocity: 36, dampingConstant: 20 }), 20), 'changed');
  assert.equal(walk.crossing, null);
  assert.equal(walk.trail.length, 2);
});

test('a trail keeps each root in its place, whichever of them leads', () => {
  const walk = new RootsWalk();
  // The pair overtakes the real root, and with it the order by real parts changes.
  for (const [i, re] of [-60, -55, -45, -40].entries()) {
    const roots = [{ re, im: 300 }, { re, im: -300 }, { re: -50, im: 0 }].sort((one, other) => other.re - one.re);
    const linear = /** @type {import('../../www/run/linear-looks.js').LinearLooks} */ (/** @type {unknown} */ ({ eigenvalues: () => roots }));
    walk.follow({ object: 'torsional', parameters: { velocity: i }, linear }, i / 10);
  }
  const paths = pathsOf(walk.trail);
  assert.deepEqual(paths.map((path) => path.map(({ im }) => im)), [[0, 0, 0, 0], [300, 300, 300, 300], [-300, -300, -300, -300]]);
  assert.deepEqual(paths[1].map(({ re }) => re), [-60, -55, -45, -40]);
  assert.equal(walk.roots[0].im, 300, 'what leads is told first all the same');
});

test('who undoes a walk, or several, has no way behind', () => {
  const walk = new RootsWalk();
  const at = (/** @type {number} */ velocity, /** @type {number} */ now) => walk.follow(gear({ velocity, dampingConstant: 20 }), now);
  at(20, 0);
  at(24, 10);
  at(30, 10.1);
  assert.ok(walk.crossing);
  assert.equal(at(20, 12), 'changed');
  assert.deepEqual([walk.trail, walk.crossing], [[walk.roots], null]);
  at(30, 20);
  at(40, 30);
  at(30, 40);
  assert.deepEqual([walk.trail, walk.crossing], [[walk.roots], null]);
  at(20, 40.2);
  assert.deepEqual([walk.trail, walk.crossing], [[walk.roots], null]);
});

test('who walks on from a beginning that was undone to has a way behind through what came after it then', () => {
  const walk = new RootsWalk();
  const at = (/** @type {number} */ velocity, /** @type {number} */ now) => walk.follow(gear({ velocity, dampingConstant: 20 }), now);
  [20, 30, 40, 20].forEach((velocity, i) => at(velocity, 10 * i));
  assert.equal(walk.trail.length, 1, 'undone to the first');
  at(25, 40);
  at(30, 40.1);
  assert.equal(walk.trail.length, 3);
  assert.ok(walk.crossing);
});

test('from one run to the next, as from figure to figure, no way is come and nothing crosses', () => {
  const walk = new RootsWalk();
  const [first, second] = [{}, {}];
  walk.follow({ ...gear({ velocity: 20 }), begun: first }, 0);
  assert.equal(walk.follow({ ...gear({ velocity: 80 }), begun: second }, 0.1), 'changed');
  assert.deepEqual([walk.trail, walk.crossing], [[walk.roots], null]);
  assert.equal(walk.follow({ ...gear({ velocity: 20 }), begun: second }, 0.2), 'crossed');
  assert.equal(walk.trail.length, 2);
});

test('the way of a walk has an end, another object has none behind it, and values that cannot be computed with leave nothing', () => {
  const walk = new RootsWalk();
  walk.follow(gear({ velocity: 20 }), 0);
  for (let i = 1; i <= 1000; i++) walk.follow(gear({ velocity: 20 + i / 100 }), 10 + i / 1000);
  assert.ok(walk.trail.length > 100 && walk.trail.length < 500, `${walk.trail.length}`);
  assert.deepEqual(walk.trail.at(-1), walk.roots);
  walk.follow({ ...gear({ velocity: 31 }), object: 'torsional-linear' }, 11.1);
  assert.deepEqual([walk.trail, walk.crossing], [[walk.roots], null]);
  walk.follow(gear({ velocity: 20, dampingConstant: 20 }), 20);
  walk.follow(gear({ velocity: 30, dampingConstant: 20 }), 30);
  assert.ok(walk.crossing);
  const broken = gear({ velocity: 21 });
  assert.equal(walk.follow({ ...broken, linear: /** @type {any} */ ({ eigenvalues: () => { throw new Error('not finite'); } }) }, 30.1), 'changed');
  assert.deepEqual([walk.roots, walk.trail, walk.crossing], [[], [], null]);
});

test('the picture of the roots widens for a pair and narrows only when it is fitted', () => {
  const held = new RootsLimits();
  const [first, second] = [{}, {}];
  held.hold([{ re: 5, im: 300 }], first);
  const before = held.limits;
  held.hold([{ re: -5, im: 310 }], first);
  assert.equal(held.limits, before);
  held.hold([{ re: -500, im: 0 }, { re: 40, im: 300 }, { re: 40, im: -300 }], first);
  assert.ok(held.limits.right > 40 && held.limits.left > -500);
  const wide = held.limits;
  held.hold([{ re: 5, im: 300 }], first);
  assert.equal(held.limits, wide);
  held.hold([{ re: 5, im: 300 }], second);
  assert.deepEqual(held.limits, before);
});

test('loci: one for each value of the other, through the roots there, colored by the sweep', () => {
  const loci = new Loci();
  const locus = { sweep: { parameter: 'velocity', from: 0.5, to: 100 }, family: { parameter: 'casterLength', from: 0, to: 0.5, count: 6 } };
  const found = loci.look(gear({ dampingConstant: 20 }), locus);
  assert.ok(found);
  assert.equal(loci.look(gear({ dampingConstant: 20, velocity: 3, casterLength: 0.4 }), locus), found, 'what varies is no reason to look anew');
  assert.notEqual(loci.look(gear({ dampingConstant: 30 }), locus), found);
  assert.deepEqual(found.ways.map(({ value }) => Number(value?.toFixed(12))), [0, 0.1, 0.2, 0.3, 0.4, 0.5]);
  // At e = 0.1 and c = 20 the pair crosses at 27.600 m/s.
  const [, way] = found.ways;
  const pair = way.paths.find((path) => path.every(({ im }) => im > 0));
  assert.ok(pair);
  const after = pair.findIndex(({ re }) => re > 0);
  assert.ok(way.at[after - 1] < 27.6 && way.at[after] > 27.5996 && way.at[after] - way.at[after - 1] < 5);
  const { context, named } = recordingContext();
  drawRootLocus(context, { width: 600, height: 500 }, {
    ways: found.ways.map(({ value, at, paths }) => ({ label: `e ${value}`, paths, shares: at.map((swept) => (swept - 0.5) / 99.5) })),
    roots: rootsOf({ velocity: 80, dampingConstant: 20 }), limits: found.limits, sweep: { symbol: 'v', from: '0.5', to: '100 m/s' },
  }, theme, voice);
  const colors = new Set(named('stroke').filter(({ style }) => style.lineCap === 'round' && style.lineWidth === 2.2).map(({ style }) => style.strokeStyle));
  assert.ok(colors.size > 15, `${colors.size} colors`);
  const names = named('fillText').filter(({ args }) => String(args[0]).startsWith('e '));
  assert.equal(names.length, 6);
  names.sort((one, other) => one.args[2] - other.args[2]).forEach(({ args }, i) => assert.ok(i === 0 || args[2] - names[i - 1].args[2] > theme.size));
});

test('where the ends of loci crowd, their names stand in a column, each with a line to the end of its own', () => {
  const locus = { sweep: { parameter: 'velocity', from: 0.5, to: 100 }, family: { parameter: 'casterLength', from: 0, to: 0.5, count: 6 } };
  const found = new Loci().look(gear({ dampingConstant: 20 }), locus);
  assert.ok(found);
  const { context, named } = recordingContext();
  const large = { ...theme, size: 17 };
  drawRootLocus(context, { width: 440, height: 300 }, {
    ways: found.ways.map(({ value, at, paths }) => ({ label: `e ${value?.toFixed(1)}`, paths, shares: at.map((swept) => (swept - 0.5) / 99.5) })),
    roots: rootsOf({ velocity: 80, dampingConstant: 20 }), limits: found.limits, sweep: { symbol: 'v', from: '0.5', to: '100 m/s' },
  }, large, voice);
  const names = named('fillText').filter(({ args }) => String(args[0]).startsWith('e ')).sort((one, other) => one.args[2] - other.args[2]);
  // The larger the caster, the faster the gear swings at the end of the sweep.
  assert.deepEqual(names.map(({ args }) => args[0]), ['e 0.5', 'e 0.4', 'e 0.3', 'e 0.2', 'e 0.1', 'e 0.0']);
  names.forEach(({ args }, i) => assert.ok(i === 0 || args[2] - names[i - 1].args[2] > large.size, 'none over another'));
  const dots = named('arc').filter(({ args, style }) => args[2] === 2 * large.line && style.fillStyle === large.ink);
  const leaders = named('lineTo').filter(({ args }) => names.some(({ args: [, x, y] }) => Math.abs(args[0] - x + 0.2 * large.size) < 1e-9 && Math.abs(args[1] - y) < 1e-9));
  assert.equal(leaders.length, 6);
  assert.equal(dots.length, 6);
});

test('what linear theory leaves out of a gear is said with whatever it says', () => {
  const english = voiceOf('en');
  const left = (/** @type {Record<string, number>} */ parameters) => linearLooks(engine, { model: 'torsional', parameters: { velocity: 40, dampingConstant: 20, ...parameters } }).leavesOut;
  assert.deepEqual([left({}), left({ freeplayAngle: 0.01 }), left({ 'friction.moment': 100 }), left({ freeplayAngle: 0.01, 'friction.moment': 100 })], [null, 'gap', 'friction', 'both']);
  const roots = [{ re: 12.3, im: 320 }, { re: 12.3, im: -320 }];
  assert.equal(becomesInTheory(roots, 'friction', english), `${becomes(roots, english)} (linear theory, without friction)`);
  assert.equal(becomesInTheory(roots, null, english), becomes(roots, english));
  assert.equal(becomesBriefly(roots, 'both', english)[0], `${becomes(roots, english)} (linear theory, inside the gap, without friction)`);
  assert.equal(becomesInSigns(roots, 'friction', english), 'linear theory: +12.3 s⁻¹');
  assert.equal(lineInTheory('Press a case.', 'friction', voiceOf('tr')), 'Sürtünmesiz doğrusal kuram. Press a case.');
  assert.equal(modeLabel({ ...linearLooks(engine, { model: 'torsional', parameters: {} }).modes()[0], eigenvalue: roots[0] }, 'friction', english), 'mode 50.9 Hz (linear theory, without friction)');
});
