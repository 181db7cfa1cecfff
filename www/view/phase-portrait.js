import { drawPortrait } from './portrait.js';

/**
 * Torsion rate over torsion angle.
 * @param {CanvasRenderingContext2D} context
 * @param {import('./canvas.js').Size} size
 * @param {import('./portrait.js').Motion & { limits: { angle: number, rate: number } }} motion `limits` in rad, rad/s
 * @param {import('../style/theme.js').Theme} theme
 * @param {import('../words/voice.js').Voice} voice
 */
export function drawPhasePortrait(context, size, motion, theme, voice) {
  drawPortrait(context, size, motion, {
    up: 'torsionRate',
    present: motion.state[1],
    limits: { angle: motion.limits.angle, up: motion.limits.rate },
    // An upright ellipse leaves all corners free.
    corners: ['top-left', 'top-right', 'bottom-right', 'bottom-left'],
  }, theme, voice);
}
