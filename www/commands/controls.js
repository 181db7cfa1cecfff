/**
 * Commands of the controls. A knob sets its value by itself, to hear at once whether it is refused.
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
    /**
     * Sets two values at once, as a point in a plane is dragged: clamped to the plane by whoever asks, so a refusal is left be.
     * @param {{ values: Record<string, number>, gesture: string | null }} point in SI
     */
    point: ({ values, gesture }) => {
      app.session?.setPoint(values, gesture);
    },
    /** @param {import('../controls/unit.js').VelocityUnit} velocityUnit */
    velocityUnit: (velocityUnit) => app.store.update({ velocityUnit }),
  };
}
