/**
 * A worker: an instance of the module of its own, which works on jobs in slices. The page hands it the compiled module first.
 *
 * @typedef {import('./slices.js').Told} Told
 * @typedef {{ module: WebAssembly.Module } | import('./slices.js').Asked | { cancel: number }} Message
 */

import { initSync, Job } from '../pkg/shimmy.js';
import { plain } from './fitted.js';
import { Slices, transferable } from './slices.js';

const slices = new Slices(
  (kind, spec) => new Job(/** @type {any} */ (kind), /** @type {any} */ (plain(spec))),
  (told) => postMessage(told, { transfer: transferable(told) }),
);

addEventListener('message', ({ data }) => {
  const message = /** @type {Message} */ (data);
  if ('module' in message) initSync({ module: message.module });
  else if ('cancel' in message) slices.cancel(message.cancel);
  else slices.work(message);
});
