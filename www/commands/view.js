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
    /** @param {number} magnification */
    magnify: (magnification) => app.session?.magnify(magnification),
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
    /** @param {import('../store.js').State['language']} language */
    language: (language) => store.update({ language }),
    /** @param {import('../store.js').State['theme']} theme */
    theme: (theme) => store.update({ theme }),
  };
}
