/** What this browser remembers between visits: the experiment as its link, the language, the theme, the speed's unit. */

const place = 'shimmy';

/** @typedef {{ link: string, language: string, theme: string, velocityUnit: string }} Kept */

/** @param {Kept} kept */
export function keep(kept) {
  try {
    localStorage.setItem(place, JSON.stringify(kept));
  } catch {
    // A browser that forbids storage (private window, full disk) forgets; the page works on.
  }
}

/** @returns {Partial<Kept>} */
export function recall() {
  try {
    const kept = JSON.parse(localStorage.getItem(place) ?? '{}');
    return typeof kept === 'object' && kept && Object.values(kept).every((value) => typeof value === 'string') ? kept : {};
  } catch {
    return {};
  }
}
