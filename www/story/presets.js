/**
 * The presets. Each tells its story in one sentence (`preset.<name>.tells`) and, step by step, in more of them
 * (`preset.<name>.1`, …). The numbers in a sentence are not written here: facts.js asks the engine for them.
 *
 * @typedef {import('./story.js').Step} Step
 * @typedef {import('./story.js').Setting} Setting
 * @typedef {import('./story.js').Story} Story
 */

import { settingOf } from './landings.js';

const degree = Math.PI / 180;
const twist = { torsionAngle: 0.05 };
const touch = { torsionAngle: 0.01 };
const wide = { torsionAngle: 0.45 };

const portrait = { lens: 'phase', views: { phase: 'portrait' } };
const orbit = { lens: 'phase', views: { phase: 'orbit' } };
const sideForce = { lens: 'forces', views: { forces: 'sideForce' } };
/** The branches of cycles over a value. @param {string} range as a link has it @param {Readonly<Record<string, string>>} [more] */
const branches = (range, more) => ({ lens: 'cycles', views: { cycles: 'branch', branch: `${range},torsionAngle`, ...more } });
const overSpeed = branches('velocity:1:120');
const overGap = branches(`freeplayAngle:0:${3 * degree}`);

const strobe = /** @type {const} */ ({ clock: { mode: 'strobe', slow: null } });

/**
 * @param {number} velocity in m/s
 * @param {number} dampingConstant in N m s/rad
 * @param {Readonly<Record<string, number>>} [others] in SI
 * @returns {Setting}
 */
const rolling = (velocity, dampingConstant, others) => ({ parameters: { velocity, dampingConstant, ...others }, initial: twist });

/** The gear of the freeplay stories: calm without a gap. @param {number} halfGap in degrees @param {number} [velocity] in m/s */
const gapped = (halfGap, velocity = 50) => ({
  ...rolling(velocity, 100, { freeplayAngle: halfGap * degree }), initial: { torsionAngle: 1.5 * Math.max(halfGap, 1) * degree }, knobs: ['freeplayAngle', 'velocity', 'dampingConstant', 'casterLength'],
});

/** A landing from 80 m/s down to 5. @param {number} deceleration in m/s² @param {number | null} current of the MR damper, in A */
const landed = (deceleration, current) => settingOf({
  model: 'torsional', parameters: { dampingConstant: 20 }, initial: touch, touchdownVelocity: 80, deceleration, finalVelocity: 5,
  ...(current !== null && { damper: { model: 'current-dependent-bouc-wen', command: current } }),
}, 'roll');

const opening = rolling(80, 20);
const softAndAhead = { casterLength: -0.5, torsionalStiffness: 50_000 };
/** A gear whose branch folds: its tire's side force meets its limit early, its aligning moment late, and the wheel leads a little. @param {number} velocity in m/s @param {number} torsionAngle in rad */
const folding = (velocity, torsionAngle) => ({
  ...rolling(velocity, 10, { casterLength: -0.05, sideForceLimitAngle: 3 * degree, aligningMomentLimitAngle: 20 * degree }), initial: { torsionAngle },
});
/** A gear with two endings: from near rest it dies out, from farther it shimmies. */
export const twoEndings = folding(40, 0.3);
/** A gear that dry friction holds at rest, however fast it rolls. @param {number} torsionAngle in rad */
const rubbing = (torsionAngle) => ({ ...rolling(40, 20, { 'friction.moment': 300 }), initial: { torsionAngle }, knobs: ['friction.moment', 'velocity', 'dampingConstant', 'casterLength'] });
const damping = { knobs: ['dampingConstant', 'velocity', 'casterLength', 'freeplayAngle'] };
const caster = { knobs: ['casterLength', 'velocity', 'dampingConstant', 'torsionalStiffness'] };

/** @type {Readonly<Record<string, readonly Step[]>>} */
const stories = {
  'first-look': [
    { state: opening },
    { state: opening, goesOn: true },
    { state: { ...opening, ...sideForce }, goesOn: true },
    { state: opening, goesOn: true, asks: { dampingConstant: 60 } },
    { state: rolling(80, 60), goesOn: true },
  ],
  'quiet-taxi': [
    { state: rolling(20, 20) },
    { state: rolling(20, 20), goesOn: true },
    { state: rolling(12, 0) },
  ],
  growing: [
    { state: rolling(26, 20) },
    { state: { ...rolling(30, 20), initial: touch, ...strobe } },
    { state: { ...rolling(40, 20), initial: touch, ...strobe } },
  ],
  'limit-cycle': [
    { state: { ...opening, initial: touch, ...portrait } },
    { state: { ...opening, initial: touch, ...orbit }, goesOn: true },
    { state: { ...opening, initial: touch, ...portrait }, goesOn: true },
    { state: { ...rolling(80, 10), ghosts: [{ parameters: { dampingConstant: 20 } }], ...portrait } },
  ],
  cure: [
    { state: { ...rolling(80, 10), ...damping } },
    { state: { ...rolling(80, 30), ...damping }, goesOn: true },
    { state: { ...rolling(80, 30), ...damping }, goesOn: true, asks: { dampingConstant: 60 } },
    { state: { ...rolling(80, 60), ...damping }, goesOn: true },
  ],
  'too-fast': [
    { state: rolling(30, 30) },
    { state: rolling(30, 30), asks: { velocity: 80 } },
    { state: rolling(80, 30), goesOn: true },
  ],
  freeplay: [
    { state: gapped(0) },
    { state: gapped(1) },
    { state: gapped(1), goesOn: true, asks: { freeplayAngle: 0.5 * degree } },
    { state: { ...gapped(0.5), ghosts: [{ parameters: { freeplayAngle: degree } }] }, goesOn: true },
    { state: { ...gapped(1), lens: 'forces', views: { forces: 'restoringMoment' } } },
    { state: { ...gapped(1), ...overSpeed } },
    { state: { ...gapped(1, 80), ...strobe } },
  ],
  'double-gap': [
    { state: gapped(0.5) },
    { state: { ...gapped(1), ghosts: [{ parameters: { freeplayAngle: 0.5 * degree } }] } },
    {
      state: {
        ...gapped(2), lens: 'compare',
        ghosts: [{ parameters: { freeplayAngle: degree } }, { parameters: { freeplayAngle: 0.5 * degree } }],
      },
    },
    { state: { ...gapped(2), ...overGap } },
  ],
  caster: [
    { state: { ...opening, ...caster } },
    { state: { ...rolling(80, 20, { casterLength: 0.35 }), ...caster } },
    { state: { ...opening, ...caster }, asks: { casterLength: -0.1 } },
    { state: { ...rolling(80, 20, { casterLength: -0.1 }), ...caster }, goesOn: true },
    { state: { ...rolling(80, 20, softAndAhead), ...caster } },
  ],
  'two-starts': [
    { state: { ...opening, initial: touch, ...portrait } },
    { state: { ...opening, initial: wide, ...portrait } },
    { state: { ...opening, initial: wide, ghosts: [{ initial: touch }], ...portrait } },
  ],
  born: [
    { state: { ...rolling(26, 20), ...overSpeed } },
    { state: { ...rolling(30, 20), ...overSpeed } },
    { state: { ...opening, ...overSpeed } },
    { state: { ...opening, lens: 'cycles', views: { cycles: 'methods' } } },
  ],
  folded: [
    { state: { ...folding(40, 0.05), ...branches('velocity:20:80') } },
    { state: { ...twoEndings, ...branches('velocity:20:80') } },
    { state: { ...twoEndings, ...branches('velocity:20:80', { branchSweep: 'on' }) }, goesOn: true },
    { state: { ...folding(34, 0.3), ...branches('velocity:20:80') } },
    { state: { ...twoEndings, lens: 'cycles', views: { cycles: 'folds', folds: 'velocity:20:80,dampingConstant:0:30' } } },
  ],
  held: [
    { state: rubbing(0.05) },
    { state: rubbing(0.2) },
    { state: { ...rubbing(0.2), ...branches('velocity:20:120') }, goesOn: true },
    { state: { ...rubbing(0.2), lens: 'cycles', views: { cycles: 'basins' } }, goesOn: true },
    { state: { ...rubbing(0.2), ...branches('friction.moment:0:600') }, goesOn: true },
  ],
  landing: [
    { state: landed(3, null) },
    { state: landed(3, null), goesOn: true },
    { state: landed(1, null) },
    { state: landed(3, 0) },
    { state: landed(3, 0.5) },
  ],
  linear: [
    { state: { ...opening, object: 'torsional-linear' } },
    { state: { ...opening, ...sideForce } },
    { state: { ...rolling(80, 60), object: 'torsional-linear' } },
  ],
};

/** @type {readonly Story[]} */
export const presets = Object.entries(stories).map(([name, steps]) => ({ name, kind: 'preset', steps, isReady: true }));
