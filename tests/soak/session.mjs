// A live simulator, used well and badly; it must go on living after every error.

import { garbage, NUMBERS, shown } from './garbage.mjs';
import { Defect, judged, must } from './judge.mjs';
import { hostileRun, shortRun } from './runs.mjs';

/** @typedef {import('./random.mjs').Random} Random */
/** @typedef {import('./runs.mjs').Model} Model */
/** @typedef {typeof import('../../www/pkg/shimmy.js')} Shimmy */

const MOVES = 12;

/** Errors of the motion itself, not of a call: extreme parameters end a motion, and it stays ended until they change. */
const ENDED = new Set(['step-limit', 'diverged', 'step-too-small']);

/**
 * What can be done to a simulator, each with arguments of the right kind.
 * @type {Record<string, (random: Random, simulator: any, model: Model) => unknown[]>}
 */
const MOVE = {
  advance: (random) => [random.pick([0, 1e-6, 1e-3, 5e-3, 0.016])],
  set: (random, _, model) => {
    const { name, min, max } = random.pick(model.parameters);
    return [name, random.between(min, max)];
  },
  setState: (random, _, model) => {
    const { name, scale } = random.pick(model.state);
    return [name, random.between(-1, 1) * scale];
  },
  kick: (random) => [random.between(-10, 10)],
  reset: () => [],
  seek: (random, simulator) => {
    const [from, to] = simulator.range;
    return [random.between(from, to)];
  },
  state: () => [],
  parameters: () => [],
  trace: (random) => [2 + random.below(100)],
  history: (random, simulator) => [...window(random, simulator), 2 + random.below(50)],
  envelope: (random, simulator) => [...window(random, simulator), 1 + random.below(50)],
  snapshot: () => [],
};

const NAMES = Object.keys(MOVE);

/** @param {Random} random @param {any} simulator */
function window(random, simulator) {
  const [from, to] = simulator.range;
  return [random.between(from, to), random.between(from, to)].sort((a, b) => a - b);
}

/**
 * Makes a simulator and plays with it. Throws a Defect, with the moves that led there.
 * @param {Shimmy} shimmy
 * @param {Random} random
 * @param {Model[]} models
 */
export function play(shimmy, random, models) {
  const { run, wrong } = random.chance(0.2)
    ? hostileRun(random, models)
    : { run: shortRun(random, models), wrong: ['nothing'] };
  const moves = [`new Simulator, wrong: ${wrong.join('; ')}`];
  try {
    const simulator = judged('new Simulator', () => new shimmy.Simulator(/** @type {any} */ (run)));
    if (!simulator) return;
    const model = models.find(({ name }) => name === /** @type {any} */ (run).model) ?? models[0];
    for (let i = 0; i < MOVES; i++) {
      if (random.chance(0.1)) restoring(random, simulator, moves);
      else if (random.chance(0.05)) reentering(random, simulator, moves);
      else move(random, simulator, model, moves);
      alive(simulator);
    }
    simulator.free();
    afterFree(random, simulator, model, moves);
  } catch (error) {
    if (!(error instanceof Defect)) throw error;
    throw new Defect(`${error.message}\n  after ${moves.join('\n    ')}`, { cause: error.cause ?? error });
  }
}

/** @param {Random} random @param {any} simulator @param {Model} model @param {string[]} moves */
function move(random, simulator, model, moves) {
  const name = random.pick(NAMES);
  const right = MOVE[name](random, simulator, model);
  const args = random.chance(0.4) ? spoiled(random, name, right) : right;
  moves.push(`${name}(${args.map(shown).join(', ')})`);
  const answer = /** @type {any} */ (judged(name, () => simulator[name](...args)));
  if (name === 'seek' && args === right && answer !== undefined) {
    must('seek went elsewhere', Math.abs(simulator.time - /** @type {number} */ (right[0])) < 1e-9);
  }
}

/** The arguments with one of them spoiled, left out, or one too many. @param {Random} random @param {string} name @param {unknown[]} right */
function spoiled(random, name, right) {
  const args = [...right];
  const at = random.below(args.length + 1);
  if (random.chance(0.1)) return args.slice(0, at);
  args[at] = random.chance(0.5) ? random.pick(NUMBERS) : garbage(random).value;
  // A window may be long; so many samples of it may rightly take a minute.
  if (name === 'history' && typeof args[2] === 'number' && args[2] > 1000) args[2] = 1e12;
  return args;
}

/** Takes a snapshot, goes on, and restores it: whole, or damaged. @param {Random} random @param {any} simulator @param {string[]} moves */
function restoring(random, simulator, moves) {
  const before = simulator.state();
  const time = simulator.time;
  const bytes = simulator.snapshot();
  must('a snapshot is bytes', bytes instanceof Uint8Array);
  const ended = judged('advance', () => [simulator.advance(1e-3)]) === undefined;
  const [what, damaged] = damage(random, bytes);
  moves.push(`restore(${what})`);
  const here = simulator.time;
  const kept = simulator.state();
  let refused = true;
  judged('restore', () => {
    simulator.restore(/** @type {any} */ (damaged));
    refused = false;
  });
  if (refused) {
    // A motion that cannot go on may have no moment to go on from.
    must('a whole snapshot was refused', what !== 'whole' || ended);
    must('a refused snapshot changed the time', simulator.time === here);
    must('a refused snapshot changed the state', same(simulator.state(), kept));
  } else if (what === 'whole') {
    must('restore brings back the time', simulator.time === time);
    must('restore brings back the state', same(simulator.state(), before));
  }
}

/** @param {Random} random @param {Uint8Array} bytes @returns {[string, unknown]} */
function damage(random, bytes) {
  if (random.chance(0.3)) return ['whole', bytes];
  const copy = Uint8Array.from(bytes);
  switch (random.below(7)) {
    case 0: {
      const at = random.below(copy.length);
      copy[at] ^= 1 << random.below(8);
      return [`bit flipped in byte ${at} of ${copy.length}`, copy];
    }
    case 1: {
      const length = random.below(copy.length);
      return [`cut to ${length} of ${copy.length}`, copy.subarray(0, length)];
    }
    case 2:
      return ['with a byte more', Uint8Array.of(...copy, 0)];
    case 3: {
      for (let i = 0; i < copy.length; i++) if (random.chance(0.1)) copy[i] = random.below(256);
      return ['every tenth byte random', copy];
    }
    case 4: {
      // Eight bytes that are NaN, an infinity or a huge count.
      const at = 8 * random.below(Math.max(1, copy.length >> 3));
      const view = new DataView(copy.buffer);
      if (at + 8 <= copy.length) view.setFloat64(at, random.pick([NaN, Infinity, -1, 1e308]), true);
      return [`a hostile number at ${at} of ${copy.length}`, copy];
    }
    case 5: {
      // One number replaced, and the checksum made right again: no accident, a forgery.
      const words = new DataView(copy.buffer);
      const at = 8 * (1 + random.below((copy.length >> 3) - 2));
      if (random.chance(0.5)) words.setFloat64(at, random.pick(NUMBERS), true);
      else words.setBigUint64(at, random.pick([0n, 1n, 3n, 2n ** 40n, 2n ** 53n, 2n ** 64n - 1n]), true);
      words.setBigUint64(copy.length - 8, fnv(copy.subarray(0, -8)), true);
      return [`forged at ${at} of ${copy.length}`, copy];
    }
    default: {
      const { name, value } = garbage(random);
      return [name, value];
    }
  }
}

/** The checksum of a snapshot, FNV-1a. @param {Uint8Array} bytes */
function fnv(bytes) {
  let hash = 0xcbf29ce484222325n;
  for (const byte of bytes) hash = BigInt.asUintN(64, (hash ^ BigInt(byte)) * 0x100000001b3n);
  return hash;
}

/** An argument that calls the simulator while it is being read. @param {Random} random @param {any} simulator @param {string[]} moves */
function reentering(random, simulator, moves) {
  const name = random.pick(['advance', 'kick', 'seek', 'set', 'restore']);
  const inner = random.pick(['advance', 'reset', 'state', 'snapshot']);
  moves.push(`${name} with an argument that calls ${inner}`);
  const again = () => {
    simulator[inner](inner === 'advance' ? 1e-4 : undefined);
    return 1e-4;
  };
  const argument = { valueOf: again, toString: again, [Symbol.toPrimitive]: again };
  judged(name, () => simulator[name](...(name === 'set' ? ['velocity', argument] : [argument])));
}

/** Whatever was done to it: its time and state can be told, and it goes on or says why not. @param {any} simulator */
function alive(simulator) {
  const state = simulator.state();
  must('the state is a Float64Array', state instanceof Float64Array && state.length > 0);
  must(`the state is ${state.join(', ')}`, state.every(Number.isFinite));
  const before = simulator.time;
  must(`the time is ${before}`, Number.isFinite(before));
  const [from, to] = simulator.range;
  must(`the range is ${from} … ${to} at ${before}`, from <= before && before <= to);
  let ended = '';
  judged('advance after all that', () => simulator.advance(1e-4), (error) => {
    ended = /** @type {any} */ (error).code;
    if (!ENDED.has(ended)) throw new Defect(`it does not go on: ${error.message}`, { cause: error });
    return true;
  });
  if (!ended) must(`the time stands at ${before}`, Math.abs(simulator.time - before - 1e-4) < 1e-9 * Math.max(1, before));
}

/** @param {Random} random @param {any} simulator @param {Model} model @param {string[]} moves */
function afterFree(random, simulator, model, moves) {
  const name = random.pick(['advance', 'state', 'snapshot', 'kick', 'reset', 'time', 'free']);
  moves.push(`${name} after free`);
  try {
    if (name === 'time') void simulator.time;
    else simulator[name](...(MOVE[name]?.(random, { range: [0, 1] }, model) ?? []));
  } catch (error) {
    must(`${name} after free threw ${error}`, error instanceof Error && !(error instanceof WebAssembly.RuntimeError));
    return;
  }
  must(`${name} after free said nothing`, name === 'free');
}

/** @param {Float64Array} a @param {Float64Array} b */
const same = (a, b) => a.length === b.length && a.every((value, i) => Object.is(value, b[i]));
