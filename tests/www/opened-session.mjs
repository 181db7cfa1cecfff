// The session over the real engine, as the page opens it, and what a drawing asks of it.

import { modelsOf } from '../../www/engine/models.js';
import { openingObject, openingParameters, openingRun } from '../../www/opening.js';
import { Session } from '../../www/run/session.js';
import { Store } from '../../www/store.js';
import { engine } from './stories.mjs';

/** The opening object's own table, and its values where nobody has set any. */
export const table = /** @type {import('../../www/engine/engine.js').Model} */ (modelsOf(engine).find(({ name }) => name === openingObject));
export const defaults = Object.fromEntries(table.parameters.map(({ name, default: usual }) => [name, usual]));

export function opened() {
  const store = new Store({
    object: openingObject, parameters: { ...defaults, ...openingParameters }, run: openingRun, links: {}, ghosts: [],
    clock: { mode: 'slow', slow: null }, lens: 'phase', views: {}, story: null, predict: null, isBig: false, velocityUnit: 'm/s', language: 'en', theme: 'system',
  });
  return { store, session: new Session(engine, store) };
}

/** A session whose damping a hand has dragged from 20 to 60 within 0.4 s, from 0.2 s on. */
export function dragged() {
  const { store, session } = opened();
  session.advance(0.2);
  for (let c = 21; c <= 60; c++) {
    session.set('dampingConstant', c, 'drag');
    session.advance(0.01);
  }
  session.settle();
  return { store, session };
}

/** @type {Parameters<Session['scene']>[0]} */
export const wanted = { moment: [-0.08, 0.02], trackLength: 1.2, stretches: 200, exposure: 0 };

/** @param {ArrayLike<number>} one @param {ArrayLike<number>} other */
export const isClose = (one, other, share = 1e-9) => Array.from(one).every((value, i) => Math.abs(value - other[i]) < share * Math.max(1, Math.abs(value)));
