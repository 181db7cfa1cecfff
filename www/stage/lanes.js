/**
 * Where the lanes of the timeline are; a low one (a phone) has the lower lane only.
 *
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../view/axes.js').Box} Box
 * @typedef {import('../view/canvas.js').Size} Size
 * @typedef {{ run: Box | null, moment: Box, hasWords: boolean }} Lanes `hasWords`: whether there is room for them between
 *   the lanes
 */

/**
 * @param {Size} size
 * @param {Theme} theme
 * @returns {Lanes}
 */
export function lanesOf({ width, height }, theme) {
  const left = theme.size * 4.4;
  const right = width - theme.size * 1.6;
  const bottom = height - theme.size * 1.7;
  if (height < 110) return { run: null, moment: { left, right, top: theme.size * 0.5, bottom }, hasWords: false };
  // The run's lane leaves room for the time at its end.
  const run = { left, right: right - theme.size * 1.6, top: theme.size * 0.6, bottom: theme.size * 0.6 + height * 0.25 };
  // With large type (a projector) the words between the lanes give way to the lanes.
  const hasWords = height > 10 * theme.size;
  return { run, moment: { left, right, top: run.bottom + theme.size * (hasWords ? 2.3 : 1.1), bottom }, hasWords };
}
