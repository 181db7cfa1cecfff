/**
 * Opens stories and walks them. A story that is opened puts its whole setting on the page; what was there before is kept,
 * and comes back as it was, to the instant.
 *
 * @typedef {import('../app.js').App} App
 * @typedef {import('../store.js').State} State
 * @typedef {import('./story.js').Story} Story
 * @typedef {import('./story.js').Step} Step
 * @typedef {{ state: State, isPlaying: boolean, scales: import('../run/session.js').Session['scales'] }} Left what a visitor had
 */

import { lenses } from '../lens/lenses.js';
import { settlingTime } from '../run/fit.js';
import { linksThatHold } from '../run/links.js';
import { isSameExperiment, isSameRecord } from '../store.js';
import { objectOf, parametersOf } from './story.js';

/** The story that is told, and where in it; null where none is. @param {App} app */
export function told({ stories, state }) {
  const story = state.story && stories.find(({ name, isReady }) => name === state.story?.name && isReady);
  if (!story || !state.story) return null;
  const at = Math.min(state.story.step, story.steps.length - 1);
  return { story, at, step: story.steps[at] };
}

/**
 * Opens a story at a step.
 * @param {App} app @param {string} name @param {number} [at]
 */
export function openStory(app, name, at = 0) {
  const story = app.stories.find((one) => one.name === name);
  const step = story?.steps[at];
  if (!app.engine || !app.session || !story?.isReady || !step) return;
  leave(app);
  show(app, story, at, false);
}

/**
 * One step on or back: within the story, then to its neighbor of the same kind. Without a story the first one opens.
 * @param {App} app @param {1 | -1} by
 */
export function walk(app, by) {
  const now = told(app);
  if (!now) {
    if (by > 0) openStory(app, app.stories[0]?.name ?? '');
    return;
  }
  const next = neighbor(app, by);
  if (next) show(app, next.story, next.at, by > 0 && goesOn(app, next));
}

/**
 * Where a step on or back leads to; null at the end.
 * @param {App} app @param {1 | -1} by
 * @returns {{ story: Story, at: number } | null}
 */
export function neighbor(app, by) {
  const now = told(app);
  if (!now) return null;
  const at = now.at + by;
  if (at >= 0 && at < now.story.steps.length) return { story: now.story, at };
  const alike = app.stories.filter(({ kind, isReady }) => kind === now.story.kind && isReady);
  const story = alike[alike.indexOf(now.story) + by];
  return story ? { story, at: by > 0 ? 0 : story.steps.length - 1 } : null;
}

/** Whether the values that answer the question of a step are set. @param {App} app */
export function isAnswered(app) {
  return Object.entries(told(app)?.step.asks ?? {}).every(([name, value]) => app.state.parameters[name] === value);
}

/** Answers the question of a step: sets the values that it asks about. @param {App} app */
export function answer(app) {
  for (const [name, value] of Object.entries(told(app)?.step.asks ?? {})) app.session?.set(name, value, 'answer');
  app.settled();
}

/** Keeps what there is, where a visitor made it: a story as it was opened need not be kept. @param {App} app */
export function leave(app) {
  const { session, store, clock } = app;
  if (!session) return;
  const isAsTold = told(app) !== null && app.asTold !== null && isSameExperiment(app.asTold, store.state);
  keepRun(app);
  if (!isAsTold || !app.left) app.left = { state: store.state, isPlaying: clock.isPlaying, scales: session.scales };
}

/** Back to what there was before the first story. @param {App} app */
export function comeBack(app) {
  const { left, session, store, clock } = app;
  if (!left || !session) return;
  const { language, theme } = store.state;
  keepRun(app);
  store.open({ ...left.state, language, theme });
  session.scales = left.scales;
  app.left = null;
  app.asTold = null;
  if (left.isPlaying) clock.play();
  else clock.pause();
  // Values that a story showed go with it.
  app.isDrawerOpen = false;
  app.notes = [];
  app.settled();
}

/** The run of the state is what it has come to: undo brings it back so. @param {App} app */
export function keepRun({ session, store }) {
  if (!session) return;
  const { parameters: start, changes, time, initial } = session.recipe;
  store.keepRun({ initial, start, changes, time });
}

/** @param {App} app @param {{ story: Story, at: number }} next */
function goesOn(app, { story, at }) {
  const now = told(app);
  const { asTold, state } = app;
  if (!story.steps[at].goesOn || now?.story !== story || !app.engine || !asTold) return false;
  const { parameters, run, object, ghosts } = state;
  const wanted = parametersOf(story.steps[at].state, app.models);
  return object === asTold.object && run === asTold.run && ghosts === asTold.ghosts
    && (isSameRecord(parameters, asTold.parameters) || isSameRecord(parameters, wanted));
}

/**
 * Puts a step on the page.
 * @param {App} app @param {Story} story @param {number} at @param {boolean} isGoingOn
 */
function show(app, story, at, isGoingOn) {
  const { engine, session, store, clock } = app;
  if (!engine || !session) return;
  const { state } = story.steps[at];
  const object = objectOf(state);
  const parameters = parametersOf(state, app.models);
  const ghosts = (state.ghosts ?? []).map((ghost) => ({
    object, parameters: { ...parameters, ...ghost.parameters }, initial: { ...state.initial, ...ghost.initial }, from: 0,
  }));
  app.isDrawerOpen = state.drawer ?? false;
  app.notes = [];
  store.open({
    object, parameters,
    run: isGoingOn ? store.state.run : { initial: { ...state.initial } },
    links: linksThatHold(engine, object, parameters),
    ghosts: ghosts.length > 0 || !isGoingOn ? ghosts : store.state.ghosts,
    clock: state.clock ?? { mode: 'slow', slow: null },
    lens: lenses.some(({ name, ready }) => ready && name === state.lens) ? state.lens : lenses[0].name,
    views: state.views ?? {},
    story: { name: story.name, step: at },
    predict: null,
  });
  app.asTold = store.state;
  app.setRate();
  if (app.isStill) session.seek(settlingTime(session.outlook.envelope));
  else clock.play();
  app.settled();
}
