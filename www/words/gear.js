/**
 * The words on the gear's drawing. Braces mark what the drawing fills in.
 *
 * @module
 */

export const gearEn = {
  /** @type {import('./number.js').Language} decides the decimal sign */
  language: 'en',
  top: 'TOP',
  drawnToScale: 'drawn to scale',
  drawnLarger: 'angles and tire drawn ×\u2009{factor}, the scale shows true degrees',
  drawnLargerShort: 'angles and tire ×\u2009{factor}',
  drawnLargerShortest: '×\u2009{factor}',
  bendsFurther: 'the tire bends further than drawn',
  bendsFurtherShort: 'tire bends further',
  tooFast: 'too fast for the screen',
  trackOnTheGround: 'track on the ground',
  atItsLimit: ', at its limit',
  spring: 'spring',
  damper: 'damper',
  friction: 'friction',
  gap: 'gap ±{angle} (drawn ×\u2009{factor})',
  gapShort: 'gap ±{angle}',
  side: 'SIDE',
  seenFromTheRight: 'seen from the right',
  steeringAxis: 'steering axis',
  caster: 'caster',
  wheelTrails: 'the wheel trails its axis',
  wheelLeads: 'the wheel leads its axis',
  wheelCentered: 'the wheel stands on its axis',
};

/** @type {typeof gearEn} */
export const gearTr = {
  language: 'tr',
  top: 'ÜSTTEN',
  drawnToScale: 'ölçekli çizim',
  drawnLarger: 'açılar ve lastik {factor} kat büyük, ölçek gerçek dereceyi gösterir',
  drawnLargerShort: 'açılar ve lastik {factor} kat',
  drawnLargerShortest: '{factor} kat',
  bendsFurther: 'lastik çizilenden daha çok bükülü',
  bendsFurtherShort: 'lastik daha çok bükülü',
  tooFast: 'ekran için fazla hızlı',
  trackOnTheGround: 'yerdeki iz',
  atItsLimit: ', sınırında',
  spring: 'yay',
  damper: 'sönümleyici',
  friction: 'sürtünme',
  gap: 'boşluk ±{angle} (çizim ×\u2009{factor})',
  gapShort: 'boşluk ±{angle}',
  side: 'YANDAN',
  seenFromTheRight: 'sağdan görünüş',
  steeringAxis: 'dönme ekseni',
  caster: 'kaster',
  wheelTrails: 'tekerlek eksenini izliyor',
  wheelLeads: 'tekerlek ekseninin önünde',
  wheelCentered: 'tekerlek ekseninin altında',
};
