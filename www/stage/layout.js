/** The layout in force, as style/layout.css has it, for drawings that must know. */

const phone = matchMedia('(max-width: 699px), (max-height: 639px)');
const projector = matchMedia('(min-width: 1000px) and (max-width: 1099px) and (min-height: 640px)');

/** @returns {import('./gear/scene.js').LayoutName} */
export function layoutName() {
  return phone.matches ? 'phone' : projector.matches ? 'projector' : 'desktop';
}

/**
 * Calls `listener` when the layout changes.
 * @param {() => void} listener
 * @returns {() => void} ends that
 */
export function watchLayout(listener) {
  for (const query of [phone, projector]) query.addEventListener('change', listener);
  return () => {
    for (const query of [phone, projector]) query.removeEventListener('change', listener);
  };
}
