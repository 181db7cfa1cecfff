// A gear whose speed is set down by and by as it runs: a landing roll made of the live simulator alone, in small steps.

import { engine } from './stories.mjs';

/** Steps between two speeds. */
const block = 16;

/**
 * @param {Readonly<Record<string, number>>} parameters
 * @param {{ from: number, to: number, braking: number, start?: number }} roll in SI
 * @returns {import('../../www/lens/landing/roll.js').Roll}
 */
export function standInRoll(parameters, { from, to, braking, start = 0.01 }) {
  const simulator = new engine.Simulator({ model: 'torsional', parameters: { ...parameters, velocity: from }, initial: { torsionAngle: start } });
  const count = Math.ceil((1600 * (from - to)) / braking) + 1;
  const interval = (from - to) / braking / (count - 1);
  const time = Float64Array.from({ length: count }, (_, i) => i * interval);
  const velocity = time.map((at) => from - braking * at);
  const [torsionAngle, torsionRate] = [new Float64Array(count), new Float64Array(count)];
  torsionAngle[0] = start;
  for (let i = 1; i < count; i++) {
    if (i % block === 1) simulator.set('velocity', velocity[i]);
    simulator.advance(interval);
    [torsionAngle[i], torsionRate[i]] = simulator.state();
  }
  simulator.free();
  return { time, velocity, torsionAngle, torsionRate };
}
