/**
 * The views that a pen may draw on: the gear, and each picture of the lens in force. A stroke belongs to one of them by
 * its name; those on a view that is not shown wait for it.
 *
 * @typedef {Pick<import('../store.js').State, 'lens' | 'views'>} Looked
 */

export const gear = 'gear';

/** The name of the lens' view in force. @param {Looked} state */
export function lensView({ lens, views }) {
  return views[lens] ? `${lens}.${views[lens]}` : lens;
}

/** The name of one of its pictures, counted from 0. @param {Looked} state @param {number} place */
export function pictureOf(state, place) {
  return place === 0 ? lensView(state) : `${lensView(state)}#${place}`;
}

/**
 * Whether a view is on the screen.
 * @param {string} view
 * @param {Looked} state
 */
export function isShown(view, state) {
  return view === gear || view.split('#')[0] === lensView(state);
}
