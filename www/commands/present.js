import { outcomeOf } from '../present/outcome.js';

/**
 * What stands for a command while the future is veiled: to play is to reveal, and time is not moved.
 *
 * @type {Readonly<Record<string, string | null>>}
 */
const whileVeiled = { toggle: 'reveal', play: 'reveal', freeze: null, on: null, back: null, seek: null };

/** @param {string} name @param {boolean} isVeiled @returns {string | null} the command that is carried out; null for none */
export function carriedOut(name, isVeiled) {
  return isVeiled && Object.hasOwn(whileVeiled, name) ? whileVeiled[name] : name;
}

/**
 * Commands of whoever shows the page to others: predict and reveal, freeze, pen, big.
 *
 * @param {import('../app.js').App} app
 * @returns {Record<string, import('../app.js').Command>}
 */
export function presentCommands(app) {
  const { clock, store, ink } = app;
  /** Whether the run went on before it was frozen to be predicted. */
  let wasPlaying = false;
  const ask = () => {
    wasPlaying = clock.isPlaying;
    clock.pause();
    app.isDrawerOpen = false;
    store.update({ predict: { guess: null, outcome: null } });
    app.isLookDue = true;
  };
  const leave = () => {
    const isUnanswered = app.isVeiled;
    store.update({ predict: null });
    // What was veiled has not been looked at.
    if (isUnanswered) app.session?.unveil();
    app.settled();
    if (isUnanswered && wasPlaying) clock.play();
  };
  return {
    predict: () => (store.state.predict ? leave() : ask()),
    predictAgain: ask,
    /** @param {import('../store.js').Guess} guess */
    guess: (guess) => {
      if (app.isVeiled) store.update({ predict: { guess, outcome: null } });
    },
    reveal: () => {
      const { session } = app;
      const { predict } = store.state;
      if (!session || !predict || predict.outcome) return;
      session.unveil();
      store.update({ predict: { ...predict, outcome: outcomeOf(session.outlook, session.seen.present.amplitude) } });
      app.settled();
      app.setRate();
      clock.play();
    },
    freeze: () => app.commands.toggle(),
    /** Taken up, the run is frozen under it: on a run that goes on ink fades at once. It goes on when it is let go on. */
    pen: () => {
      app.isDrawing = !app.isDrawing;
      if (app.isDrawing) clock.pause();
    },
    /** @param {{ view: string, points: import('../present/stroke.js').Point[] }} stroke */
    penStroke: ({ view, points }) => ink.add(view, points),
    penUndo: () => ink.undo(),
    penClear: () => ink.clear(),
    penPin: () => {
      ink.isPinned = !ink.isPinned;
    },
    big: () => store.update({ isBig: !store.state.isBig }),
    /** Closes what is open, one thing at a time. */
    close: () => {
      if (app.isDrawing) app.isDrawing = false;
      else if (app.isDrawerOpen) app.isDrawerOpen = false;
      else if (store.state.predict) leave();
      else app.notes = [];
    },
  };
}
