/**
 * The timeline's two lanes: the whole run with what comes, and the instants around now.
 *
 * @typedef {import('../style/theme.js').Theme} Theme
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {import('../view/axes.js').Box} Box
 * @typedef {import('../view/time-history.js').History} History
 * @typedef {import('../view/time-history.js').StateName} StateName
 * @typedef {import('../run/scene.js').Scene} Scene
 * @typedef {import('./lanes.js').Lanes} Lanes
 * @typedef {{
 *   scene: Scene, moment: [number, number], shown: StateName, cursors: number[], labels: string[], isVeiled: boolean,
 * }} Picture `moment`: the window of the lower lane, in s around now; `labels`: what sets each ghost apart
 */

import { drawRunEnvelope } from '../view/run-envelope.js';
import { textFont } from '../view/text.js';
import { drawTimeHistory } from '../view/time-history.js';

/** Which end of the axes is whose. */
export const limitOf = /** @type {const} */ ({ torsionAngle: 'angle', torsionRate: 'rate', lateralDeformation: 'deformation' });

/**
 * @param {CanvasRenderingContext2D} context
 * @param {Lanes} lanes
 * @param {Picture} picture
 * @param {Theme} theme
 * @param {Voice} voice
 */
export function drawTimeline(context, lanes, picture, theme, voice) {
  const { scene, moment: [from, to], shown, cursors, labels, isVeiled } = picture;
  if (lanes.run) drawRun(context, lanes.run, picture, lanes.hasWords, theme, voice);
  drawTimeHistory(context, lanes.moment, {
    past: since(scene.past, scene.time),
    future: scene.future,
    from, to, shown, cursors,
    limit: scene.scales.limits[limitOf[shown]],
    freeplay: scene.parameters.freeplayAngle ?? 0,
    value: valueOf(scene, shown),
    frequency: scene.outlook.present.frequency ?? null,
    ghosts: scene.fan ? [] : scene.ghosts.map(({ past }, i) => ({ label: labels[i] ?? '', past: since(past, scene.time) })),
    veiled: isVeiled,
    exposure: scene.fan ? scene.exposure : 0,
  }, theme, voice, { isSmall: !lanes.hasWords });
}

/** The state's value now. @param {Scene} scene @param {StateName} shown */
function valueOf({ past }, shown) {
  const series = past[shown];
  return series[series.length - 1];
}

/** The same with times from now. @template {History} Columns @param {Columns} history @param {number} now @returns {Columns} */
export function since(history, now) {
  return { ...history, time: Array.from(history.time, (at) => at - now) };
}

/**
 * @param {CanvasRenderingContext2D} context @param {Box} box @param {Picture} picture @param {boolean} hasWords
 * @param {Theme} theme @param {Voice} voice
 */
function drawRun(context, box, { scene: { run, time }, moment: [from, to], cursors, isVeiled }, hasWords, theme, voice) {
  drawRunEnvelope(context, box, { ...run, now: time, bracket: [time + from, time + to], veiled: isVeiled }, theme);
  context.font = textFont(theme, 0.9);
  context.fillStyle = theme.ink2;
  context.textBaseline = 'middle';
  context.textAlign = 'right';
  context.fillText(voice.say('timeline.run'), box.left - theme.size * 0.7, (box.top + box.bottom) / 2);
  context.textAlign = 'left';
  context.fillText(`${voice.number(run.to, run.to < 10 ? 1 : 0)} s`, box.right + theme.size * 0.5, (box.top + box.bottom) / 2);
  // What cursors read stands in the same corner.
  if (!hasWords || isVeiled || cursors.length > 0) return;
  context.textBaseline = 'alphabetic';
  context.textAlign = 'right';
  const words = voice.say('timeline.future');
  if (context.measureText(words).width < (box.right - box.left) * 0.42) context.fillText(words, box.right, box.bottom + theme.size * 1.5);
}
