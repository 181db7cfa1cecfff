/**
 * The views on the screen that can leave it as pictures.
 *
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {Pick<import('../store.js').State, 'lens'>} Looked
 * @typedef {{ name: string, element: string, title: (voice: Voice) => string }} Shown `element`: its canvas, a selector
 */

/** @param {Looked} state @returns {Shown[]} */
export function viewsOf({ lens }) {
  return [
    { name: 'gear', element: '.gear shimmy-canvas', title: (voice) => voice.say('stage.name') },
    { name: 'time', element: 'shimmy-timeline shimmy-canvas', title: (voice) => voice.say('timeline.name') },
    { name: lens, element: '#lens-panel shimmy-canvas', title: (voice) => voice.say(/** @type {import('../words/voice.js').Key} */ (`lens.${lens}`)) },
  ];
}

/** @param {string} name @param {Looked} state */
export function chosenView(name, state) {
  return viewsOf(state).find((view) => view.name === name) ?? null;
}
