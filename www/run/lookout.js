/**
 * What the engine sees ahead of the live run: what becomes of it if nothing changes, and what goes in and out of a cycle.
 * While the future is veiled it looks at nothing, so that no word, axis or scale tells what comes before it is guessed.
 *
 * @typedef {import('../engine/engine.js').Engine} Engine
 * @typedef {import('../engine/engine.js').Outlook} Outlook
 * @typedef {import('../engine/engine.js').Energy} Energy
 * @typedef {import('./live-run.js').LiveRun} LiveRun
 * @typedef {{ model: string, parameters: Readonly<Record<string, number>>, initial: Record<string, number>, maxSteps: number }} Onward
 *   a run as it goes on from now
 */

/** Steps that one look ahead may take: some ten thousand look 6 s ahead; an absurd gear is stopped, for the page must never block. */
export const stepsAhead = 30_000;
const samplesPerCycle = 64;

export class Lookout {
  #engine;
  /** What becomes of the motion if nothing changes. @type {Outlook} */ outlook = nothingAhead;
  /** Energy of the coming cycle by element; null for a wheel that does not swing. @type {Energy | null} */ energy = null;
  /** When it looked last, in s. */ lookedAt = 0;
  /** Whether it is older than the last change. */ isStale = false;
  /** Whether it may not look. */ isVeiled;

  /** @param {Engine} engine @param {boolean} isVeiled */
  constructor(engine, isVeiled) {
    this.#engine = engine;
    this.isVeiled = isVeiled;
  }

  /** The frequency of the motion now, or of where it goes. */
  get frequency() {
    return this.outlook.present.frequency ?? this.outlook.frequency ?? null;
  }

  /** Looks ahead from where the run is. Throws where the engine can not. @param {LiveRun} live */
  look(live) {
    this.isStale = this.isVeiled;
    if (this.isVeiled) return;
    this.lookedAt = live.time;
    const run = onward(live);
    const outlook = this.#engine.outlook(run);
    const frequency = outlook.present.frequency ?? outlook.frequency;
    this.energy = frequency ? this.#energyOfCycle(live, run, 1 / frequency) : null;
    this.outlook = outlook;
  }

  /**
   * The outlook with the swing as it was seen last: the engine tells of the coming cycle, while trail and marks show the
   * one gone by. Just after a start or a blow there is none yet.
   * @param {LiveRun} live
   * @returns {Outlook}
   */
  seen(live) {
    const { time, range, struckAt } = live;
    const since = time - 1 / (this.frequency ?? 50);
    if (since < range[0] || since < struckAt) return this.outlook;
    const { torsionAngle } = live.history(since, time, 2 * samplesPerCycle);
    const amplitude = torsionAngle.reduce((most, angle) => Math.max(most, Math.abs(angle)), 0);
    return { ...this.outlook, present: { ...this.outlook.present, amplitude } };
  }

  /** The envelope ahead, at times of the run. */
  get ahead() {
    const { envelope } = this.outlook;
    return { ...envelope, time: envelope.time.map((at) => at + this.lookedAt) };
  }

  /**
   * The energy of the coming cycle. Just after a start or a blow the tire has yet to follow the wheel, which makes that
   * cycle unlike all others: then it is the one after.
   * @param {LiveRun} live @param {Onward} run @param {number} beat in s
   */
  #energyOfCycle({ time, struckAt }, run, beat) {
    const isFresh = time - Math.max(0, struckAt) < beat;
    if (!isFresh) return this.#engine.energy({ ...run, duration: beat });
    const { time: _, events: __, stats: ___, ...states } = this.#engine.simulate({ ...run, duration: beat, samples: 2 });
    const initial = Object.fromEntries(Object.entries(states).map(([name, series]) => [name, series[1]]));
    return this.#engine.energy({ ...run, initial, duration: beat });
  }
}

/** The run as it goes on from now. @param {LiveRun} live @returns {Onward} */
export function onward({ present: { object: model, parameters }, stateByName: initial }) {
  return { model, parameters, initial, maxSteps: stepsAhead };
}

/** Stands for an outlook where the very first look ahead failed, or may not be. @type {Outlook} */
const nothingAhead = {
  verdict: 'rests',
  settled: true,
  held: false,
  amplitude: { torsionAngle: 0, torsionRate: 0, lateralDeformation: 0 },
  frequency: null,
  present: { amplitude: 0, frequency: null, trend: 'steady', stable: null },
  envelope: { time: new Float64Array(), low: new Float64Array(), high: new Float64Array() },
  orbit: { time: new Float64Array(), torsionAngle: new Float64Array(), torsionRate: new Float64Array(), lateralDeformation: new Float64Array() },
};
