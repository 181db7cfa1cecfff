import { fitted, fittingsOf } from '../object/fittings.js';
import { linksThatHold } from '../run/links.js';
import { keepRun, leave } from '../story/player.js';

/**
 * Commands of the lens *Damper*.
 *
 * @param {import('../app.js').App} app
 * @returns {Record<string, import('../app.js').Command>}
 */
export function damperCommands(app) {
  const { store } = app;
  return {
    /**
     * Puts a damper with its values on the gear, in place of the one that is there; the run goes on from where it is. What would
     * preload the gear stays out. An object that takes no damper makes way for the first that does.
     * @param {{ model: string, parameters: Readonly<Record<string, number>> }} damper
     */
    fitDamper: ({ model, parameters: found }) => {
      const { engine, session, state, models } = app;
      const table = engine?.dampers().find(({ name }) => name === model);
      if (!engine || !session || !table) return;
      const known = (/** @type {string} */ gear) => models.find(({ name }) => name === fitted(gear, { damper: model }));
      const listed = known(state.object) ?? known(fittingsOf(models[0].name).gear);
      if (!listed) return;
      const own = Object.fromEntries(Object.entries(found).flatMap(([name, value]) => (name in table.onGear ? [] : [[`damper.parameters.${name}`, value]])));
      if (listed.name === state.object) {
        session.setPoint(own, null);
        app.settled();
        return;
      }
      const parameters = Object.fromEntries(Object.entries(app.usualOf(listed.name)).map(([name, value]) =>
        [name, name.startsWith('damper.parameters.') ? own[name] ?? value : state.parameters[name] ?? value]));
      const now = session.stateByName;
      const initial = Object.fromEntries(listed.state.flatMap(({ name }) => (name in now && !table.state.some((one) => one.name === name) ? [[name, now[name]]] : [])));
      leave(app);
      keepRun(app);
      store.open({ object: listed.name, parameters, links: linksThatHold(engine, listed.name, parameters), run: { initial }, ghosts: [], story: null, predict: null });
      app.settled();
    },
  };
}
