// Landing rolls of 25 s, with and without a damper, in Node: `node benches/javascript/landings.js` after the module is built.
// Beside each the plain gear's 6 s of shimmy, as absolute times drift between machines.

import { readFile } from 'node:fs/promises';
import init, * as shimmy from '../../www/pkg/shimmy.js';
import { shortest } from './contest.js';

await init({ module_or_path: await readFile(new URL('../../www/pkg/shimmy_bg.wasm', import.meta.url)) });

const plain = { model: 'torsional', parameters: { velocity: 80, dampingConstant: 20 }, initial: { torsionAngle: 0.01 }, duration: 6, samples: 1000 };
console.log(`plain gear, 6 s at 80 m/s: ${shortest(() => shimmy.simulate(plain)).least.toFixed(2)} ms`);
for (const dampingConstant of [20, 40]) {
  for (const command of [null, 0, 0.5, 1]) {
    const damper = command === null ? null : { model: 'modified-bouc-wen', command };
    const run = { model: 'torsional', parameters: { dampingConstant }, initial: { torsionAngle: 0.01 }, touchdownVelocity: 80, rows: 4000, damper };
    const { stats } = shimmy.landingRoll(run);
    const { least } = shortest(() => shimmy.landingRoll(run));
    console.log(`c = ${dampingConstant}, ${command === null ? 'no damper' : `${command} A`}: ${least.toFixed(1)} ms, ${stats.steps} steps, ${stats.events} events, ${stats.method}`);
  }
}
