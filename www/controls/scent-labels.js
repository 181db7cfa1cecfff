/**
 * Where the numbers and the caption of a scent stand under the track: no two collide, none leaves the track.
 *
 * @typedef {import('./scent.js').Scent} Scent
 * @typedef {{ x: number, text: string }} Label `x`: its left edge, in px from the track's left end
 * @typedef {{ numbers: readonly Label[], caption: (Label & { row: 0 | 1 }) | null }} Labels `row` 1 is under the numbers
 */

/** What is left free between two labels, in px. */
export const gap = 8;

/**
 * @param {Pick<Scent, 'marks' | 'captions'>} scent
 * @param {number} width of the track, in px
 * @param {(text: string) => number} measure the width of a text, in px
 * @returns {Labels}
 */
export function placeLabels({ marks, captions }, width, measure) {
  const numbers = placeNumbers(marks, width, measure);
  const ends = numbers.map(({ x, text }) => ({ from: x, to: x + measure(text) }));
  const [first, last] = [ends.at(0), ends.at(-1)];
  if (!first || !last) return { numbers, caption: fitting([...captions.all, ...captions.least], 0, width) };

  const isPair = captions.between.length > 0;
  const [right, left] = isPair ? [captions.between, captions.between] : [captions.above, captions.below];
  const caption = (isPair && numbers.length === 2 ? besideNumbers(captions.between, first.to, last.from) : null)
    ?? besideNumbers(right, last.to, width) ?? besideNumbers(left, 0, first.from);
  if (caption) return { numbers, caption };
  // No room beside the numbers: under them.
  const middle = (first.from + last.to) / 2;
  for (const text of [...right, ...captions.least]) {
    const size = measure(text);
    if (size <= width) return { numbers, caption: { x: clamped(middle - size / 2, 0, width - size), text, row: 1 } };
  }
  return { numbers, caption: null };

  /** @param {readonly string[]} wordings @param {number} from @param {number} to @returns {Labels['caption']} */
  function besideNumbers(wordings, from, to) {
    const start = from > 0 ? from + gap : 0;
    const end = to < width ? to - gap : width;
    for (const text of wordings) {
      const size = measure(text);
      // It stands by its number: right after it, or right before it, or in the middle between two.
      if (size <= end - start) return { x: from === 0 ? end - size : to === width ? start : (start + end - size) / 2, text, row: 0 };
    }
    return null;
  }

  /** @param {readonly string[]} wordings @param {number} from @param {number} to @returns {Labels['caption']} */
  function fitting(wordings, from, to) {
    const text = wordings.find((one) => measure(one) <= to - from);
    return text === undefined ? null : { x: from, text, row: 0 };
  }
}

/**
 * Each number under its mark, as near as the track's ends and its neighbors let it. Where there is no room for all, those
 * in the middle are left out: their marks stay.
 * @param {Scent['marks']} marks
 * @param {number} width
 * @param {(text: string) => number} measure
 * @returns {Label[]}
 */
function placeNumbers(marks, width, measure) {
  let shown = marks.map(({ place, number }) => ({ middle: place * width, text: number, size: measure(number) }));
  const needed = () => shown.reduce((sum, { size }) => sum + size, gap * Math.max(0, shown.length - 1));
  while (shown.length > 0 && needed() > width) shown = shown.toSpliced(Math.floor(shown.length / 2), 1);
  /** @type {Label[]} */
  const labels = [];
  let from = 0;
  shown.forEach(({ middle, text, size }, i) => {
    // What those to the right need at least is theirs.
    const rest = shown.slice(i + 1).reduce((sum, other) => sum + other.size + gap, 0);
    labels.push({ x: clamped(middle - size / 2, from, width - rest - size), text });
    from = labels[i].x + size + gap;
  });
  return labels;
}

/** @param {number} value @param {number} least @param {number} most */
function clamped(value, least, most) {
  return Math.min(Math.max(value, least), Math.max(least, most));
}
