import assert from 'node:assert/strict';
import test from 'node:test';
import { shimmy, SHIMMY, STATES } from './module.mjs';

test('on the limit cycle the tire feeds in what damper and tread take out', () => {
  const { orbit, frequency } = shimmy.outlook(SHIMMY);
  const initial = Object.fromEntries(STATES.map((state) => [state, orbit[state][0]]));
  const energy = shimmy.energy({ ...SHIMMY, initial });
  assert.ok(energy);
  assert.deepEqual(Object.keys(energy), ['duration', 'tire', 'damper', 'treadWidth', 'friction', 'mrDamper', 'kinetic', 'spring', 'stored']);
  assert.ok(Math.abs(energy.duration * Number(frequency) - 1) < 1e-6);
  assert.ok(Math.abs(energy.tire / (energy.damper + energy.treadWidth) - 1) < 1e-6, JSON.stringify(energy));
  // Half the square of the largest rate, over a period, is what a pure sine would lose.
  const rate = Math.max(...orbit.torsionRate.map(Math.abs));
  assert.ok(Math.abs(energy.damper / (20 * 0.5 * rate ** 2 * energy.duration) - 1) < 0.05);
});

test('a growing swing takes in more than it loses, and stores the rest', () => {
  const energy = shimmy.energy(SHIMMY);
  assert.ok(energy && energy.tire > energy.damper + energy.treadWidth && energy.stored > 0);
  assert.ok(Math.abs(energy.tire - energy.damper - energy.treadWidth - energy.stored) < 1e-7 * energy.tire);
  assert.equal(energy.stored, energy.kinetic + energy.spring);
});

test('a duration counts where it is given; at rest there is no cycle', () => {
  assert.equal(shimmy.energy({ ...SHIMMY, duration: 0.1 })?.duration, 0.1);
  assert.equal(shimmy.energy({ model: 'torsional' }), null);
});
