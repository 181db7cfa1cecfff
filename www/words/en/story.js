/** Words of the story strip, in English. */
export const story = {
  'story.title': 'What to try',
  'story.shimmies': 'Nothing shakes this wheel but its own tire. Drag the damping up until it dies out.',
  'story.dies-out': 'Damper and tread take out more than the tire brings in. Drag the damping down until it shimmies.',
  'story.rattles': 'Inside the gap no spring holds the wheel, and there the tire swings it. Close the gap.',
  'story.grows': 'It swings wider than this model is trusted for. Drag the damping up.',
  'story.rests': 'Nothing keeps it swinging. Kick the wheel and see what becomes of the swing.',
};
