import { linksThatHold } from '../run/links.js';
import { answer, comeBack, isAnswered, leave, openStory, told, walk } from '../story/player.js';

/**
 * Commands of the stories and of the choice of an object.
 *
 * @param {import('../app.js').App} app
 * @returns {Record<string, import('../app.js').Command>}
 */
export function storyCommands(app) {
  const { store } = app;
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
    /** @param {string} object another object, with the values and the start that both have */
    object: (object) => {
      const { engine, state } = app;
      if (!engine || object === state.object) return;
      const usual = app.usualOf(object);
      const parameters = Object.fromEntries(Object.entries(usual).map(([name, value]) => [name, state.parameters[name] ?? value]));
      leave(app);
      store.open({
        object, parameters, links: linksThatHold(engine, object, parameters), run: { initial: { ...state.run.initial } }, ghosts: [], story: null, predict: null,
      });
      app.settled();
    },
  };
}
