/** What takes the run elsewhere: a hand on the wheel lets go of it first. */
export const handsOff = new Set([
  'on', 'back', 'seek', 'start', 'kick', 'rest', 'motion', 'startFrom', 'undo', 'redo', 'resetAll', 'pin', 'open', 'next', 'previous', 'comeBack', 'object',
]);

/**
 * Commands of the clock and of the hand on the wheel.
 *
 * @param {import('../app.js').App} app
 * @returns {Record<string, import('../app.js').Command>}
 */
export function clockCommands(app) {
  const { clock, store } = app;
  const look = () => { app.isLookDue = true; };
  const seek = (/** @type {number} */ time) => {
    app.session?.seek(time);
    app.notes = [];
    look();
  };
  const stepBy = (/** @type {number} */ steps) => {
    clock.pause();
    if (app.session) seek(app.session.time + steps * clock.step);
  };
  return {
    toggle: () => {
      if (clock.isPlaying) clock.pause();
      else clock.play();
      look();
    },
    play: () => clock.play(),
    pause: () => {
      clock.pause();
      look();
    },
    on: () => stepBy(1),
    back: () => stepBy(-1),
    seek,
    start: () => {
      app.notes = [];
      app.session?.restart();
      app.setRate();
      look();
    },
    kick: () => {
      app.session?.kick();
      look();
    },
    rest: () => {
      app.session?.rest();
      look();
    },
    /** @param {number} angle ψ in rad */
    hold: (angle) => app.session?.hold(angle),
    release: () => {
      if (!app.session?.isHeld) return;
      app.session.letGo();
      app.occasion++;
      look();
    },
    /** As if no hand had been there. */
    letBe: () => {
      app.session?.letBe();
      look();
    },
    /** @param {{ mode: import('../run/clock.js').Mode, slow?: number | null }} rate */
    rate: ({ mode, slow = store.state.clock.slow }) => store.update({ clock: { mode, slow } }),
  };
}
