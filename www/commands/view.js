/**
 * Commands that change how the experiment is looked at, and nothing of it.
 *
 * @param {import('../app.js').App} app
 * @returns {Record<string, import('../app.js').Command>}
 */
export function viewCommands(app) {
  const { store } = app;
  return {
    fit: () => app.session?.fit(),
    /** @param {number | null} factor by which angles and tire are drawn larger; null leaves it to each run */
    magnify: (factor) => {
      const { magnification: _, ...views } = store.state.views;
      store.update({ views: factor === null ? views : { ...views, magnification: String(factor) } });
    },
    /** @param {string} lens */
    lens: (lens) => store.update({ lens }),
    /** @param {{ of: string, shows: string }} choice what a lens, or the timeline, shows */
    view: ({ of, shows }) => store.update({ views: { ...store.state.views, [of]: shows } }),
    drawer: () => {
      app.isDrawerOpen = !app.isDrawerOpen;
    },
    closeNotes: () => {
      app.notes = [];
    },
    /** What is heard is told when it is first heard. */
    sound: () => {
      const { sound, voice } = app;
      const isFirst = !sound.wasOn;
      sound.toggle();
      if (sound.failure) app.notes = [{ text: voice.say('sound.failed', { reason: sound.failure }), isAlert: true }];
      else if (isFirst) app.notes = [{ text: voice.say('sound.heard'), isAlert: false }];
    },
    /** @param {import('../store.js').State['language']} language */
    language: (language) => store.update({ language }),
    /** @param {import('../store.js').State['theme']} theme */
    theme: (theme) => store.update({ theme }),
  };
}
