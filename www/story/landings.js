/**
 * The landings of the thesis as stories open them: the gear with its damper, rolling out under the lens *Landing*.
 *
 * @typedef {import('./story.js').AtlasEntry} AtlasEntry
 * @typedef {import('./story.js').Setting} Setting
 */

import { landingObject } from '../lens/landing/gear.js';
import { usualRoll, writeRoll } from '../lens/landing/settings.js';

/** What of a run with a landing this page can set. */
const known = ['model', 'parameters', 'initial', 'damper', 'touchdownVelocity', 'deceleration', 'finalVelocity', 'liftFraction', 'duration'];

/** Table 7.4 is shown by the first of its landings. @type {NonNullable<AtlasEntry['run']>} */
const firstLanding = {
  model: 'torsional', parameters: { dampingConstant: 20 }, initial: { torsionAngle: 0.01 }, damper: { model: 'current-dependent-bouc-wen', leverArm: 0.1, command: 0 }, touchdownVelocity: 80, deceleration: 3, finalVelocity: 5,
};

/** @param {AtlasEntry} entry @returns {Setting | null} null for what is no landing, or one with more than this page can set */
export function landingOf({ id, view, run }) {
  const isTable = id === 'Table 7.4';
  if (!isTable && view !== 'landing-roll') return null;
  const landing = isTable ? firstLanding : run;
  if (!landing || Object.keys(landing).some((key) => !known.includes(key))) return null;
  return settingOf(landing, isTable ? 'table' : 'roll');
}

/** The setting of a landing. @param {NonNullable<AtlasEntry['run']>} run @param {'roll' | 'beside' | 'table'} view @returns {Setting} */
export function settingOf({ model, parameters, initial, damper, touchdownVelocity, deceleration, finalVelocity, liftFraction }, view) {
  const given = Object.fromEntries(Object.entries({ touchdownVelocity, deceleration, finalVelocity, liftFraction, torsionAngle: initial?.torsionAngle }).filter(([, value]) => typeof value === 'number'));
  const roll = { ...usualRoll, ...given };
  const { model: name, parameters: own, ...values } = damper ?? { model: 'none', parameters: null };
  return {
    object: landingObject(model, name),
    parameters: {
      ...parameters, velocity: roll.touchdownVelocity, touchdownVelocity: roll.touchdownVelocity, deceleration: roll.deceleration, finalVelocity: roll.finalVelocity, liftFraction: roll.liftFraction,
      ...Object.fromEntries(Object.entries(values).flatMap(([key, value]) => (typeof value === 'number' ? [[`damper.${key}`, value]] : []))),
      ...Object.fromEntries(Object.entries(own ?? {}).map(([key, value]) => [`damper.parameters.${key}`, value])),
    },
    initial: { torsionAngle: roll.torsionAngle }, clock: { mode: 'strobe', slow: null }, lens: 'landing', views: { landing: view, landingRoll: writeRoll(roll) },
    knobs: ['dampingConstant', ...(damper ? ['damper.command'] : []), 'casterLength', 'freeplayAngle'], duration: (roll.touchdownVelocity - roll.finalVelocity) / roll.deceleration,
  };
}
