/**
 * Commands of the knobs that change no value.
 *
 * @param {import('../app.js').App} app
 * @returns {Record<string, import('../app.js').Command>}
 */
export function controlCommands(app) {
  return {
    /** @param {import('../controls/unit.js').VelocityUnit} velocityUnit */
    velocityUnit: (velocityUnit) => app.store.update({ velocityUnit }),
  };
}
