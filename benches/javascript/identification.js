// Generations a second of a search for a damper's values, on one core.

/** @typedef {typeof import('../../www/pkg/shimmy.js')} Shimmy */
/** @typedef {{ what: string, perSecond: number, goal?: string }} Row */

const GOAL = '≥ 60 with 11 parameters';
const INDIVIDUALS = 60;
const GENERATIONS = 60;
const SEEDS = [1, 2, 3];

/** By amplitude and by frequency, at four commands. */
const MOTIONS = [
  { amplitude: 0.015, frequency: 2.5 },
  { amplitude: 0.002, endAmplitude: 0.02, frequency: 2 },
  { amplitude: 0.005, frequency: 1, endFrequency: 8 },
  { amplitude: 0.008, frequency: 4 },
];

/** Of a Bouc–Wen element's scale no record tells: A is held. @type {[string, Record<string, number[]>, number][]} */
const SEARCHES = [
  ['bouc-wen', { amplitude: [120, 120] }, 6],
  ['modified-bouc-wen', { amplitude: [301, 301] }, 11],
  ['current-dependent-bouc-wen', { amplitude: [301, 301] }, 15],
];

/**
 * @param {Shimmy} shimmy
 * @param {string} place
 * @returns {Row[]}
 */
export const identifications = (shimmy, place) =>
  SEARCHES.map(([model, bounds, parameters]) => {
    const records = MOTIONS.map((excitation, i) =>
      shimmy.damperRecord({ damper: { model, command: 0.5 * i }, excitation, cycles: 3, samples: 500, noise: 0.02, seed: i }),
    );
    const spec = { model, records, bounds, population: INDIVIDUALS, polish: false };
    // The first one warms up. What a candidate costs changes on the way: every seed from its beginning.
    const [, ...times] = [0, ...SEEDS].map((seed) => {
      const search = new shimmy.Identification({ ...spec, seed });
      const began = performance.now();
      for (let i = 0; i < GENERATIONS; i += 1) search.step();
      const time = performance.now() - began;
      search.free();
      return time;
    });
    const perSecond = (1000 * GENERATIONS * times.length) / times.reduce((sum, time) => sum + time, 0);
    return { what: `shimmy, wasm in ${place}: ${model}, ${parameters} parameters`, perSecond, goal: parameters === 11 ? GOAL : '' };
  });
