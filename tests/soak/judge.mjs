// What the module may answer: numbers that are numbers, or an Error that says what was wrong. Anything else is a defect.

import { Booby } from './garbage.mjs';

/** The module broke its word. */
export class Defect extends Error {}

/** Words of a module that has fallen over, in whatever class they come. */
const FALLEN = /unreachable|recursive use|unsafe aliasing|panicked|null pointer passed|memory access|call stack|table index/i;

/**
 * Calls the module and judges its answer. Returns what it answered; `undefined` where it refused.
 * @template T
 * @param {string} what
 * @param {() => T} call
 * @param {(error: Error) => boolean} [expected] an error that would otherwise be a defect
 * @returns {T | undefined}
 */
export function judged(what, call, expected = () => false) {
  let answer;
  try {
    answer = call();
  } catch (error) {
    judgeError(what, error, expected);
    return undefined;
  }
  finite(what, answer);
  return answer;
}

/** @param {string} what @param {unknown} error @param {(error: Error) => boolean} expected */
function judgeError(what, error, expected) {
  if (error instanceof Booby) return;
  if (!(error instanceof Error)) throw new Defect(`${what} threw ${typeof error}, not an Error`);
  if (expected(error)) return;
  if (error instanceof WebAssembly.RuntimeError) throw new Defect(`${what} trapped: ${error.message}`, { cause: error });
  if (FALLEN.test(error.message)) throw new Defect(`${what} fell over: ${error.message.slice(0, 200)}`, { cause: error });
  const { code, field, value, allowed } = /** @type {Error & Record<string, unknown>} */ (error);
  if (typeof code !== 'string' || !code) throw new Defect(`${what}: an error without a code: ${error.message.slice(0, 200)}`, { cause: error });
  for (const [name, part] of Object.entries({ field, value, allowed })) {
    if (typeof part !== 'string') throw new Defect(`${what}: ${code} has no ${name}: ${error.message.slice(0, 200)}`, { cause: error });
  }
  if (!field) throw new Defect(`${what}: ${code} names no field: ${error.message.slice(0, 200)}`, { cause: error });
  if (!error.message) throw new Defect(`${what}: ${code} says nothing`, { cause: error });
  if (error.message.length > 2000) throw new Defect(`${what}: a message of ${error.message.length} characters`, { cause: error });
}

/** No NaN and no infinity anywhere in an answer. @param {string} what @param {unknown} answer */
function finite(what, answer) {
  if (typeof answer === 'number') {
    if (!Number.isFinite(answer)) throw new Defect(`${what} answered ${answer}`);
  } else if (answer instanceof Float64Array) {
    const bad = answer.findIndex((value) => !Number.isFinite(value));
    if (bad >= 0) throw new Defect(`${what} answered ${answer[bad]} at ${bad} of ${answer.length}`);
  } else if (answer instanceof Map) {
    throw new Defect(`${what} answered a Map`);
  } else if (answer && typeof answer === 'object' && !ArrayBuffer.isView(answer)) {
    for (const [key, value] of Object.entries(answer)) finite(`${what}: ${key}`, value);
  }
}

/** A trajectory's columns are as long as its time, and the time never falls. @param {string} what @param {any} trajectory */
export function judgeTrajectory(what, trajectory) {
  const { time } = trajectory;
  if (!(time instanceof Float64Array)) throw new Defect(`${what}: time is not a Float64Array`);
  for (let i = 1; i < time.length; i++) if (time[i] < time[i - 1]) throw new Defect(`${what}: time falls at ${i}`);
  for (const [name, column] of Object.entries(trajectory)) {
    if (column instanceof Float64Array && column.length !== time.length) {
      throw new Defect(`${what}: ${name} has ${column.length} values for ${time.length} times`);
    }
  }
}

/** @param {string} what @param {boolean} holds */
export function must(what, holds) {
  if (!holds) throw new Defect(what);
}
