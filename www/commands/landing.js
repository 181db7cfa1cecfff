import { gearOf, gearWith, isLive, rollNow } from '../lens/landing/gear.js';
import { rollNames, writeRoll } from '../lens/landing/settings.js';
import { fitted } from '../object/fittings.js';
import { linksThatHold } from '../run/links.js';
import { leave } from '../story/player.js';

/**
 * Commands of landings.
 *
 * @typedef {import('../lens/landing/settings.js').RollValues} RollValues
 *
 * @param {import('../app.js').App} app
 * @returns {Record<string, import('../app.js').Command>}
 */
export function landingCommands(app) {
  const { store } = app;
  const isThere = (/** @type {string} */ object) => app.models.some(({ name }) => name === object);
  const rollHere = () => rollNow(app.state, app.state.views);
  return {
    /** Another landing: of the gear that lands on the stage its values, else what the lens looks at. @param {RollValues} roll */
    landing: (roll) => {
      const { state, session } = app;
      const values = Object.fromEntries(rollNames.map((name) => [name, roll[name]]).filter(([name]) => /** @type {string} */ (name) in state.parameters));
      if (isLive(state)) session?.setPoint(values, 'landing');
      // It lands anew, turned otherwise.
      if (isLive(state) && state.run.initial.torsionAngle !== roll.torsionAngle) store.update({ run: { initial: { ...state.run.initial, torsionAngle: roll.torsionAngle } } }, 'landing');
      store.update({ views: { ...state.views, landingRoll: writeRoll(roll) } });
      app.settled();
    },
    /** The gear touches down on the stage, with another damping and current where they are given. @param {{ dampingConstant: number, current: number } | undefined} values */
    land: (values) => {
      const { engine, state, clock } = app;
      if (!engine) return;
      const roll = rollHere();
      const gear = gearOf(state);
      const wanted = values && isThere(gearWith(gear, values).model) ? gearWith(gear, values) : { ...gear, parameters: { ...gear.parameters, ...(values && { dampingConstant: values.dampingConstant }) } };
      const landing = fitted(wanted.model, { roll: 'landing' });
      const object = isThere(landing) ? landing : wanted.model;
      /** @type {Record<string, number>} */
      const own = { ...wanted.parameters, velocity: roll.touchdownVelocity, ...roll };
      const parameters = Object.fromEntries(Object.entries(app.usualOf(object)).map(([name, usual]) => [name, own[name] ?? usual]));
      leave(app);
      store.open({
        object, parameters, links: linksThatHold(engine, object, parameters), run: { initial: { torsionAngle: roll.torsionAngle } }, ghosts: [], story: null, predict: null,
        clock: { mode: 'strobe', slow: null }, lens: 'landing', views: { ...state.views, landing: 'roll', landingRoll: writeRoll(roll) },
      });
      app.setRate();
      if (!app.isStill) clock.play();
      app.settled();
    },
  };
}
