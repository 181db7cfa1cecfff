/** Words on the plots, in English. */
export const plots = {
  'state.torsionAngle': 'torsion angle',
  'state.torsionRate': 'torsion rate',
  'state.lateralDeformation': 'lateral deformation',

  'forces.slipAngle': 'slip angle',
  'forces.sideForce': 'side force',
  'forces.aligningMoment': 'aligning moment',
  'forces.restoringMoment': 'restoring moment',

  'plot.ghost': 'ghost: {label}',

  'cursor.ago': '{time} ms ago',
  'cursor.ahead': 'in {time} ms',
  'cursor.peaks': 'pk–pk {value}',

  'spectrum.frequency': 'frequency',
  'spectrum.amplitude': 'amplitude',
};
