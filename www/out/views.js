/**
 * The views on the screen that can leave it as pictures.
 *
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {Pick<import('../store.js').State, 'lens' | 'views'>} Looked
 * @typedef {{ name: string, element: string, title: (voice: Voice) => string, note?: string }} Shown `element`: its canvas, a
 *   selector; `note`: likewise what is said of it beside the picture and goes with it
 */

/** @param {Looked} state @returns {Shown[]} */
export function viewsOf({ lens, views }) {
  return [
    { name: 'gear', element: '.gear shimmy-canvas', title: (voice) => voice.say('stage.name') },
    { name: 'time', element: 'shimmy-timeline shimmy-canvas', title: (voice) => voice.say('timeline.name') },
    ...(lens === 'stability' ? stabilityViews(views) : lens === 'cycles' ? cyclesViews(views) : lens === 'damper' ? damperViews(views) : lens === 'landing' ? landingViews(views) : [{ name: lens, element: '#lens-panel shimmy-canvas', title: titled(`lens.${lens}`) }]),
  ];
}

/** @param {string} name @param {Looked} state */
export function chosenView(name, state) {
  return viewsOf(state).find((view) => view.name === name) ?? null;
}

/** The views of the lens *Stability* that are elements of their own; Routh's array is no picture. @type {Readonly<Record<string, Shown[]>>} */
const panels = {
  modes: [{ name: 'modes', element: '#lens-panel .phasors shimmy-canvas', title: titled('stability.view.modes') }],
  routh: [],
  beside: [{ name: 'planes', element: '#lens-panel .planes-beside shimmy-canvas', title: titled('beside.title') }],
  histories: [{ name: 'histories', element: '#lens-panel .both-histories shimmy-canvas', title: titled('stability.view.histories') }],
};

/** @param {Looked['views']} views @returns {Shown[]} */
function stabilityViews({ stability }) {
  if (Object.hasOwn(panels, stability ?? '')) return panels[stability];
  if (stability === 'locus') return [{ name: 'locus', element: '#lens-panel shimmy-canvas', title: titled('stability.view.locus') }];
  const plane = { name: 'plane', element: '#lens-panel shimmy-plane shimmy-canvas', title: titled('stability.title'), note: '#lens-panel .share .full' };
  return [
    ...(stability === 'roots' ? [] : [plane]),
    { name: 'roots', element: '#lens-panel .roots shimmy-canvas', title: titled('roots.title') },
    { name: 'history', element: '#lens-panel .history shimmy-canvas', title: titled('history.title') },
  ];
}

/** The views of the lens *Cycles*; the first is the usual one. @type {Readonly<Record<string, Shown[]>>} */
const cyclePanels = {
  cycle: [
    { name: 'cycle', element: '#lens-panel .cycle-orbit', title: titled('cycle.title') },
    { name: 'multipliers', element: '#lens-panel .multipliers', title: titled('cycle.multipliers') },
  ],
  branch: [
    { name: 'bifurcation', element: '#lens-panel .branch-plane shimmy-canvas', title: titled('cycles.view.branch') },
    { name: 'cycle', element: '#lens-panel .branch-orbit', title: titled('cycle.title') },
    { name: 'multipliers', element: '#lens-panel .multipliers', title: titled('cycle.multipliers') },
  ],
  methods: [{ name: 'three-methods', element: '#lens-panel .methods-plot shimmy-canvas', title: titled('cycles.view.methods') }],
  folds: [
    { name: 'folds', element: '#lens-panel .swing-map shimmy-canvas', title: titled('cycles.view.folds') },
    { name: 'bifurcation', element: '#lens-panel .folds-branch', title: titled('cycles.view.branch') },
  ],
  tables: [],
  basins: [{ name: 'basins', element: '#lens-panel .basins-plane shimmy-canvas', title: titled('cycles.view.basins') }],
  freeplay: [
    { name: 'swings', element: '#lens-panel .swing-map shimmy-canvas', title: titled('gap.title') },
    { name: 'bifurcation', element: '#lens-panel .gap-branch', title: titled('cycles.view.freeplay') },
  ],
};

/** @param {Looked['views']} views @returns {Shown[]} */
function cyclesViews({ cycles, cycleOrbit }) {
  const [orbit, circle] = cyclePanels.cycle;
  // The circle and the orbit change places where that is chosen.
  if ((cycles ?? 'cycle') === 'cycle' && cycleOrbit === 'multipliers') return [{ ...circle, element: orbit.element }, { ...orbit, element: circle.element }];
  return Object.hasOwn(cyclePanels, cycles ?? '') ? cyclePanels[cycles] : cyclePanels.cycle;
}

/** The views of the lens *Landing*: of many landings and of the table each is taken by itself. @param {Looked['views']} views @returns {Shown[]} */
function landingViews({ landing = 'roll' }) {
  if (landing !== 'roll') return [];
  return [
    { name: 'runway', element: '#lens-panel .roll-runway shimmy-canvas', title: titled('landing.runway'), note: '#lens-panel .roll-words' },
    { name: 'roll', element: '#lens-panel .roll-history shimmy-canvas', title: titled('landing.history') },
    { name: 'branches', element: '#lens-panel .roll-under shimmy-canvas', title: titled('landing.under') },
  ];
}

/** The views of the lens *Damper*; the first is the usual one, tables take themselves along. @type {Readonly<Record<string, Shown[]>>} */
const damperPanels = {
  loops: [
    { name: 'loops', element: '#lens-panel .damper-plots', title: titled('damper.view.loops') },
    { name: 'damper-model', element: '#lens-panel .damper-schematic', title: titled('damper.model') },
  ],
  models: [{ name: 'models', element: '#lens-panel .damper-plots', title: titled('damper.view.models') }],
  energy: [{ name: 'energy', element: '#lens-panel .damper-plots', title: titled('damper.view.energy'), note: '#lens-panel .damper-reading' }],
  identify: [
    { name: 'fit', element: '#lens-panel .identify-loops', title: titled('identify.fit') },
    { name: 'errors', element: '#lens-panel .identify-errors', title: titled('identify.error') },
    { name: 'population', element: '#lens-panel .identify-population', title: titled('identify.population') },
  ],
  calm: [{ name: 'calm', element: '#lens-panel .calm-map shimmy-canvas', title: titled('damper.view.calm'), note: '#lens-panel .calm-answer span' }],
  tables: [],
};

/** @param {Looked['views']} views @returns {Shown[]} */
function damperViews({ damper }) {
  return Object.hasOwn(damperPanels, damper ?? '') ? damperPanels[damper] : damperPanels.loops;
}

/** @param {string} key @returns {Shown['title']} */
function titled(key) {
  return (voice) => voice.say(/** @type {import('../words/voice.js').Key} */ (key));
}
