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
     * Sets values at once: those of a point that is dragged in a plane, or those of a case. Whoever asks has them from a range
     * or a list that the engine has taken, so a refusal is left be.
     * @param {{ values: Record<string, number>, gesture: string | null }} point in SI
     */
    point: ({ values, gesture }) => {
      app.session?.setPoint(values, gesture);
    },
    /**
     * Puts the gear on a motion that a lens knows: a cycle, or beside one.
     * @param {{ values: Record<string, number>, state: Record<string, number>, gesture?: string | null }} motion in SI; a gesture goes on until `settle`
     */
    motion: ({ values, state, gesture = null }) => {
      app.session?.setMotion(values, state, gesture);
      if (gesture === null) app.settled();
    },
    /**
     * Begins the run anew from another start.
     * @param {{ state: Record<string, number>, gesture?: string | null }} start in SI; a gesture goes on until `settle`
     */
    startFrom: ({ state, gesture = null }) => {
      app.notes = [];
      app.session?.startFrom(state, gesture);
      if (gesture === null) app.settled();
    },
    /** @param {import('../controls/unit.js').VelocityUnit} velocityUnit */
    velocityUnit: (velocityUnit) => app.store.update({ velocityUnit }),
  };
}
