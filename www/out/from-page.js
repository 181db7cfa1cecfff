import { chosenView } from './views.js';
import { valuesLine } from './values-line.js';
import { inkOver } from '../present/pen-layers.js';
import { mannerOf } from '../stage/manner.js';

/**
 * @typedef {import('../app.js').App} App
 * @typedef {import('./sheet.js').Wish} Wish
 * @typedef {import('../view/canvas.js').Canvas} Canvas
 */

/**
 * What a file is made from: the run since something was last done to it, which is what is seen, to where the timeline
 * ends; for a picture the view as it stands on the page, with what a pen drew.
 * @param {App} app with an engine and a session
 * @param {Wish} wish
 * @param {HTMLElement} host the element in which stage and lens are
 * @param {import('../style/theme.js').Theme} theme
 * @param {string} address of the page with its state
 * @returns {import('./file-of.js').Material | null} null before the engine is there
 */
export function materialOf(app, { view }, host, theme, address) {
  const { engine, session, table, voice, state, quantities } = app;
  if (!engine || !session || !table) return null;
  const { model, parameters, initial, duration } = session.sinceChange(app.duration);
  const shown = chosenView(view, state);
  const canvas = /** @type {Canvas | null} */ (shown ? host.querySelector(shown.element) : null);
  return {
    engine, table, duration, link: address,
    experiment: { object: model, parameters, run: { initial } },
    ...(shown && canvas?.paint && {
      picture: { size: canvas.size, paint: canvas.paint, over: inkOver(canvas) ?? undefined },
      caption: {
        title: `${shown.title(voice)} · ${voice.say(`verdict.${mannerOf(session.outlook)}`)}`, note: (shown.note && host.querySelector(shown.note)?.textContent) ?? '',
        values: valuesLine(quantities, state.parameters, voice), link: address,
      },
      theme,
    }),
  };
}
