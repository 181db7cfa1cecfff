import { fitted } from '../object/fittings.js';
import { linksThatHold } from '../run/links.js';
import { answer, comeBack, isAnswered, keepRun, leave, openStory, told, walk } from '../story/player.js';

/**
 * Commands of the stories, and of the choice of an object and of what is fitted to it.
 *
 * @param {import('../app.js').App} app
 * @returns {Record<string, import('../app.js').Command>}
 */
export function storyCommands(app) {
  const { store } = app;
  /** @param {string} object @param {Readonly<Record<string, number>>} start of which it takes what it has */
  const change = (object, start) => {
    const { engine, state } = app;
    const table = app.models.find(({ name }) => name === object);
    if (!engine || !table || object === state.object) return;
    const parameters = Object.fromEntries(Object.entries(app.usualOf(object)).map(([name, value]) => [name, state.parameters[name] ?? value]));
    const initial = Object.fromEntries(table.state.flatMap(({ name }) => (name in start ? [[name, start[name]]] : [])));
    leave(app);
    keepRun(app);
    store.open({ object, parameters, links: linksThatHold(engine, object, parameters), run: { initial }, ghosts: [], story: null, predict: null });
    app.settled();
  };
  return {
    /** @param {string} name of a story */
    open: (name) => openStory(app, name),
    /** What is next: where a step asks a question, first the guess and the answer, then the next step. */
    next: () => {
      if (app.isVeiled) app.run('reveal');
      else if (told(app)?.step.asks && !isAnswered(app)) app.run('ask');
      else walk(app, 1);
    },
    previous: () => walk(app, -1),
    /** Has the question of the step guessed at, and sets the values that answer it. */
    ask: () => {
      app.run(app.state.predict ? 'predictAgain' : 'predict');
      answer(app);
    },
    comeBack: () => comeBack(app),
    /** The story ends, and all stays as it is. */
    endStory: () => store.update({ story: null }),
    /** @param {string} gear another object, with the values, the start and the fittings that both have */
    object: (gear) => {
      const object = fitted(app.state.object, { gear });
      change(app.models.some(({ name }) => name === object) ? object : gear, app.state.run.initial);
    },
    /** What is fitted to the gear becomes another: the run goes on from where it is. @param {Partial<import('../object/fittings.js').Fittings>} fittings */
    fitting: (fittings) => change(fitted(app.state.object, fittings), app.session?.stateByName ?? {}),
  };
}
