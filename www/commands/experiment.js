import { openingObject, openingRun } from '../opening.js';
import { keepRun } from '../story/player.js';
import { mostGhosts } from '../run/ghosts.js';
import { linksThatHold } from '../run/links.js';

/**
 * Commands that change the experiment: values, links, ghosts, undo.
 *
 * @param {import('../app.js').App} app
 * @returns {Record<string, import('../app.js').Command>}
 */
export function experimentCommands(app) {
  const { store } = app;
  const walk = (/** @type {'undo' | 'redo'} */ direction) => () => {
    store[direction]();
    app.notes = [];
    app.settled();
  };
  return {
    settle: () => app.settled(),
    undo: walk('undo'),
    redo: walk('redo'),
    resetAll: () => {
      if (!app.engine) return;
      keepRun(app);
      store.follow({ object: openingObject });
      const links = linksThatHold(app.engine, openingObject, app.usual);
      store.update({ parameters: app.usual, links, run: { ...openingRun }, clock: { mode: 'slow', slow: null }, story: null });
    },
    /** @param {string} name of a value that follows others */
    toggleLink: (name) => app.session?.toggleLink(name),
    pin: () => {
      if (store.state.ghosts.length < mostGhosts) app.session?.pin();
      else app.notes = [{ text: app.voice.say('clock.pin.full', { count: mostGhosts }), isAlert: false }];
    },
    /** @param {number} index */
    unpin: (index) => app.session?.unpin(index),
    unpinAll: () => store.update({ ghosts: [] }),
  };
}
