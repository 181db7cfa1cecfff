/**
 * Commands of the knobs that change no value.
 *
 * @param {import('../app.js').App} app
 * @returns {Record<string, import('../app.js').Command>}
 */
export function controlCommands(app) {
  return {
    /** Opens what is to be said of a parameter, or closes it. @param {string | null} name */
    explain: (name) => {
      app.explained = app.explained === name ? null : name;
    },
    /** @param {import('../controls/unit.js').VelocityUnit} velocityUnit */
    velocityUnit: (velocityUnit) => app.store.update({ velocityUnit }),
  };
}
