/**
 * The lenses: what one looks at beside the gear. A new lens is a file here and a line in this list.
 * Those that are not `ready` are shown dimmed, with the reason.
 * @type {{ name: 'phase' | 'forces' | 'stability' | 'cycles' | 'damper' | 'landing' | 'compare', ready: boolean }[]}
 */
export const lenses = [
  { name: 'phase', ready: true },
  { name: 'forces', ready: false },
  { name: 'stability', ready: false },
  { name: 'cycles', ready: false },
  { name: 'damper', ready: false },
  { name: 'landing', ready: false },
  { name: 'compare', ready: false },
];
