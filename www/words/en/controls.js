/** Words of the knobs, in English. */
export const controls = {
  'dock.name': 'Values',
  'dock.choose': 'Which value the slider sets',
  'dock.all': 'All {count} values',
  'dock.all.short': 'All {count}',
  'dock.close': 'Close',
  'dock.reset': 'Reset all',

  'knob.reset': '{name} back to {value}',
  'knob.far': 'Far beyond the slider’s {min} to {max}.',
  'knob.number': '{name}, exact number',

  'parameter.velocity': 'Speed',
  'parameter.casterLength': 'Caster',
  'parameter.halfContactLength': 'Half contact length',
  'parameter.relaxationLength': 'Relaxation length',
  'parameter.momentOfInertia': 'Moment of inertia',
  'parameter.torsionalStiffness': 'Stiffness',
  'parameter.dampingConstant': 'Damping',
  'parameter.verticalForce': 'Vertical force',
  'parameter.sideForceDerivative': 'Side force slope',
  'parameter.aligningMomentDerivative': 'Aligning moment slope',
  'parameter.sideForceLimitAngle': 'Side force limit',
  'parameter.aligningMomentLimitAngle': 'Aligning moment limit',
  'parameter.treadWidthMomentConstant': 'Tread width constant',
  'parameter.freeplayAngle': 'Freeplay, half gap',

  'refused.above': '{name} must be above {limit}. It stays at {kept}.',
  'refused.atLeast': '{name} must be {limit} or more. It stays at {kept}.',
  'refused.tooLarge': '{name} is too large to compute with. It stays at {kept}.',
  'refused.notANumber': 'That is not a number. {name} stays at {kept}.',
  'refused.other': '{name} must be {allowed}. It stays at {kept}.',
};
