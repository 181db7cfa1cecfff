/**
 * The views that a pen may draw on, by name: the gear, and each picture of the lens in force. A stroke belongs to one of
 * them; those on a view that is not shown wait for it.
 */

export const gear = 'gear';

/**
 * One of the lens' pictures.
 * @param {string} lens
 * @param {string} view which of the lens' views, '' where it has but one
 * @param {number} place among the pictures of that view, counted from 0
 */
export function pictureOf(lens, view, place) {
  return [lens, view, place > 0 ? place : ''].filter((part) => part !== '').join('.');
}
