// Where the numbers of the damper current-dependent-bouc-wen come from: `npm run identify` prints them anew.
//
// Records of Spencer's modified damper at steady commands from 0 to 1.5 (1 V counts as 1 A), one motion for all of them, and
// a search for 15 values; the best of three seeds. Two are held: the exponent 2, which is the model's
// form, and the amplitude A at Spencer's 301, because of a Bouc–Wen element's scale no record tells.

import { readFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';

const MODEL = 'current-dependent-bouc-wen';
const COMMANDS = [0, 0.25, 0.5, 0.75, 1, 1.25, 1.5];
const SEEDS = [1, 2, 3];
/** Digits that are kept of each value. */
const DIGITS = 4;

/** Amplitude and frequency grow together: from where the element hardly yields to 1.3 m/s. */
const MOTION = { excitation: { amplitude: 0.002, endAmplitude: 0.02, frequency: 1, endFrequency: 10 }, cycles: 10, samples: 1000 };

/** What is asked. @param {any} shimmy @param {number} seed */
export function recipe(shimmy, seed) {
  const records = COMMANDS.map((command) => shimmy.damperRecord({ damper: { model: 'modified-bouc-wen', command }, ...MOTION }));
  return { model: MODEL, records, bounds: { amplitude: [301, 301] }, seed };
}

/**
 * What is found: values by name, as they are shipped, their error beside the records, and what the records do not fix.
 * @param {any} shimmy the engine
 */
export function identified(shimmy) {
  const names = shimmy.dampers().find((/** @type {any} */ damper) => damper.name === MODEL).parameters.map((/** @type {any} */ p) => p.name);
  const found = SEEDS.map((seed) => {
    const search = new shimmy.Identification(recipe(shimmy, seed));
    while (!search.done) search.step();
    const { parameters } = search.result();
    search.free();
    return parameters;
  });
  const spec = recipe(shimmy, SEEDS[0]);
  const known = shimmy.identifiability(spec, found.flatMap((values) => names.map((/** @type {string} */ name) => values[name])));
  const best = found[known.best];
  const values = Object.fromEntries(names.map((/** @type {string} */ name) => [name, Number(best[name].toPrecision(DIGITS))]));
  const [error] = shimmy.fitness(spec, names.map((/** @type {string} */ name) => values[name]));
  return { values, error, known };
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const { default: init, ...shimmy } = await import('../www/pkg/shimmy.js');
  await init({ module_or_path: await readFile(new URL('../www/pkg/shimmy_bg.wasm', import.meta.url)) });
  const { values, error, known } = identified(shimmy);
  const percent = (/** @type {number} */ part) => `${(100 * part).toFixed(2)} %`;
  for (const [name, value] of Object.entries(values)) {
    const spread = known.parameters.find((/** @type {any} */ p) => p.name === name);
    const note = spread ? `range of seeds ${spread.range.map((/** @type {number} */ x) => x.toPrecision(DIGITS)).join(' … ')}${spread.fixed ? '' : ', not fixed by the records'}` : 'held';
    console.log(`${name.padEnd(28)}${String(value).padStart(12)}   ${note}`);
  }
  console.log(`error beside all records ${percent(error)}; by command: ${known.fits.map((/** @type {any} */ fit) => `${fit.command} A ${percent(fit.error)}`).join(', ')}`);
  for (const { change, parts } of known.weak) console.log('weak', change.toExponential(2), JSON.stringify(parts));
}
