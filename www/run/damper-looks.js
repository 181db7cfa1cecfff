/**
 * What the engine says of dampers by themselves, on a bench that moves their piston.
 *
 * @typedef {import('../engine/engine.js').Engine} Engine
 * @typedef {ReturnType<Engine['dampers']>[number]} DamperTable
 * @typedef {{ model: string, command: number, parameters?: Readonly<Record<string, number>> }} Damper
 * @typedef {{ amplitude: number, frequency: number }} Motion in m and Hz
 * @typedef {Omit<ReturnType<Engine['damperResponse']>, 'time'>} Cycle one of them, equally spaced, its end left out
 * @typedef {ReturnType<typeof damperLooks>} DamperLooks
 */

/** Cycles that it takes to forget how it began. */
const cyclesBefore = 3;
export const samplesPerCycle = 512;

/** @type {WeakMap<object, DamperTable[]>} */
const tables = new WeakMap();

/** @param {Engine} engine */
export function damperLooks(engine) {
  return {
    /** The tables of all dampers: they never change. */
    get tables() {
      const known = tables.get(engine) ?? engine.dampers();
      tables.set(engine, known);
      return known;
    },
    /** A piston that is led by hand; whoever has it frees it. @param {Damper} damper */
    piston: (damper) => new engine.Piston(damper),
    /** A record made by a damper on the bench, with noise. @param {import('../pkg/shimmy.js').DamperRecordSpec} spec */
    record: (spec) => /** @type {{ displacement: Float64Array, velocity: Float64Array, force: Float64Array, command: number, interval: number }} */ (engine.damperRecord(spec)),
    /**
     * One settled cycle, its end as its start. @param {Damper} damper @param {Motion} excitation @returns {Cycle}
     */
    cycle: (damper, excitation) => {
      const cycles = cyclesBefore + 1;
      const { time: _, ...series } = engine.damperResponse({ damper, excitation, cycles, samples: cycles * samplesPerCycle });
      return /** @type {Cycle} */ (Object.fromEntries(Object.entries(series).map(([name, values]) => [name, values.slice(-samplesPerCycle)])));
    },
  };
}

/**
 * What a loop takes out of the motion, in J: its area.
 * @param {Pick<Cycle, 'displacement' | 'force'>} cycle
 */
export function energyOf({ displacement, force }) {
  let energy = 0;
  for (let i = 0, before = force.length - 1; i < force.length; before = i++) energy += 0.5 * (force[i] + force[before]) * (displacement[i] - displacement[before]);
  return energy;
}

/**
 * The dashpot that takes out as much: E = π c ω X², in N s/m.
 * @param {number} energy @param {Motion} motion
 */
export const equivalentDamping = (energy, { amplitude, frequency }) => energy / (2 * Math.PI ** 2 * frequency * amplitude ** 2);
