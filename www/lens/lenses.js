/**
 * The lenses: what one looks at beside the gear. A new lens is a file here, its line in this list, and its import in
 * elements.js; its element is called `shimmy-<name>-lens`. Those that are not `ready` are shown dimmed, with the reason.
 *
 * @typedef {HTMLElement & {
 *   voice: import('../words/voice.js').Voice | null, shows: string, settings?: Readonly<Record<string, string>>, isVeiled: boolean, outlook: import('../engine/engine.js').Outlook | null,
 *   draw: (scene: import('../run/scene.js').Scene, theme: import('../style/theme.js').Theme) => void,
 * }} LensElement `shows`: which of its views, '' for the first; it asks for another by the command `view`. `settings`: what else is kept by name in the state's `views`. `isVeiled`: nothing of the future is shown. What the engine
 *   sees ahead comes to its properties `outlook`, `energy`, `ghosts`, `frequency` a few times a second, frames to `draw`
 *
 * @type {readonly { name: 'phase' | 'forces' | 'stability' | 'cycles' | 'damper' | 'landing' | 'compare', ready: boolean }[]}
 */
export const lenses = [
  { name: 'phase', ready: true },
  { name: 'forces', ready: true },
  { name: 'stability', ready: true },
  { name: 'cycles', ready: true },
  { name: 'damper', ready: true },
  { name: 'landing', ready: true },
  { name: 'compare', ready: true },
];
