/**
 * A worker: an instance of the module of its own, which works on jobs in slices. The page hands it the compiled module first.
 *
 * @typedef {import('./slices.js').Told} Told
 * @typedef {{ module: WebAssembly.Module } | import('./slices.js').Asked | { cancel: number }} Message
 */

import { fitness, identifiability, initSync, Job } from '../pkg/shimmy.js';
import { plain } from './fitted.js';
import { Slices, transferable } from './slices.js';

/** What is done at a stroke, as a job. @type {Readonly<Record<string, (spec: any) => unknown>>} */
const strokes = {
  fitness: ({ spec, population }) => fitness(spec, population),
  identifiability: ({ spec, population }) => identifiability(spec, population),
};

/** @param {() => unknown} work */
function atOnce(work) {
  /** @type {unknown} */ let result;
  return {
    advance: () => {
      result = work();
      return { done: true, fraction: 1 };
    },
    result: () => result,
    free: () => {},
  };
}

const slices = new Slices(
  (kind, spec) => (Object.hasOwn(strokes, kind) ? atOnce(() => strokes[kind](spec)) : new Job(/** @type {any} */ (kind), /** @type {any} */ (plain(spec)))),
  (told) => postMessage(told, { transfer: transferable(told) }),
);

addEventListener('message', ({ data }) => {
  const message = /** @type {Message} */ (data);
  if ('module' in message) initSync({ module: message.module });
  else if ('cancel' in message) slices.cancel(message.cancel);
  else slices.work(message);
});
