/** Words on the plots, in Turkish. @type {typeof import('../en/plots.js').plots} */
export const plots = {
  'state.torsionAngle': 'burulma açısı',
  'state.torsionRate': 'burulma hızı',
  'state.lateralDeformation': 'yanal şekil değişimi',

  'forces.slipAngle': 'kayma açısı',
  'forces.sideForce': 'yanal kuvvet',
  'forces.aligningMoment': 'doğrultma momenti',
  'forces.restoringMoment': 'geri çağırma momenti',

  'plot.ghost': 'hayalet: {label}',

  'cursor.ago': '{time} ms önce',
  'cursor.ahead': '{time} ms sonra',
  'cursor.peaks': 'tepe–tepe {value}',

  'spectrum.frequency': 'frekans',
  'spectrum.amplitude': 'genliği',
};
