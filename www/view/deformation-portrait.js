import { drawPortrait } from './portrait.js';

/**
 * The tire's lateral deformation over torsion angle.
 * @param {CanvasRenderingContext2D} context
 * @param {import('./canvas.js').Size} size
 * @param {import('./portrait.js').Motion & { limits: { angle: number, deformation: number } }} motion `limits` in rad, m
 * @param {import('../style/theme.js').Theme} theme
 * @param {import('../words/voice.js').Voice} voice
 */
export function drawDeformationPortrait(context, size, motion, theme, voice) {
  drawPortrait(context, size, motion, {
    up: 'lateralDeformation',
    present: motion.state[2],
    limits: { angle: motion.limits.angle, up: motion.limits.deformation },
    // Where y leans with ψ the ellipse lies along the rising diagonal.
    corners: ['top-left', 'bottom-right', 'top-right', 'bottom-left'],
  }, theme, voice);
}
