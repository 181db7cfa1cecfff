/**
 * What a slider's track tells beforehand: where the gear shimmies as this one value varies, the others as they are. The
 * engine says where (linear theory in closed form); here it becomes places on the track, numbers and words.
 *
 * @typedef {import('../pkg/shimmy.js').UnstableInterval} UnstableInterval
 * @typedef {import('../words/voice.js').Voice} Voice
 * @typedef {import('./quantity.js').Quantity} Quantity
 * @typedef {{
 *   intervals: readonly UnstableInterval[], isOnlyLinear: boolean, isOnlySmall?: boolean, isDivergent: boolean, leavesOut?: 'friction' | 'both' | null,
 * }} Unstable what linear theory finds over a slider's range. `isOnlyLinear`: the gear itself may do otherwise, as in its freeplay;
 *   `leavesOut`: for its friction, or for both; `isOnlySmall`: a wide swing does otherwise, for a cycle reaches beyond the boundary.
 *   `isDivergent`: where all of the range is unstable, the wheel does not swing but turns aside
 * @typedef {{ place: number, number: string }} Mark a boundary: its place on the track, 0 … 1, and its number
 * @typedef {{ above: readonly string[], below: readonly string[], between: readonly string[], all: readonly string[], least: readonly string[] }} Captions
 *   what to write right of the last mark, left of the first, between a pair, and where there is none; the fullest wording
 *   first. `least`: what is to be said even where none of these has room
 * @typedef {{ hatches: readonly { from: number, to: number }[], marks: readonly Mark[], captions: Captions, inWords: string }} Scent
 *   `inWords`: the same for who cannot see the track
 * @typedef {{ value: number, isStableAbove: boolean, kind: UnstableInterval['fromKind'] }} Boundary
 */

/**
 * @param {Unstable} unstable
 * @param {Quantity} quantity
 * @param {Voice} voice
 * @returns {Scent}
 */
export function scentOf(unstable, quantity, voice) {
  const { intervals } = unstable;
  const boundaries = boundariesOf(intervals);
  const safe = boundaries.map(({ value, isStableAbove }) => quantity.rounded(value, isStableAbove ? 'up' : 'down'));
  const phrases = phrasesOf(unstable, voice);
  return {
    hatches: intervals.map(({ from, to }) => ({ from: quantity.placeOf(from), to: quantity.placeOf(to) })),
    marks: boundaries.map(({ value }, i) => ({ place: quantity.placeOf(value), number: quantity.number(safe[i], voice) })),
    captions: captionsOf(intervals, boundaries, safe.map((value) => quantity.number(value, voice)), phrases),
    inWords: inWords(intervals, boundaries, safe.map((value) => quantity.write(value, voice)), phrases),
  };
}

/** Where stability changes, ascending. @param {readonly UnstableInterval[]} intervals @returns {Boundary[]} */
function boundariesOf(intervals) {
  return intervals.flatMap(({ from, to, fromKind, toKind }) => [
    ...(fromKind === 'range' ? [] : [{ value: from, isStableAbove: false, kind: fromKind }]),
    ...(toKind === 'range' ? [] : [{ value: to, isStableAbove: true, kind: toKind }]),
  ]);
}

/**
 * The words: what a side of a boundary is, told of a place.
 * @param {Unstable} unstable
 * @param {Voice} voice
 */
function phrasesOf({ isOnlyLinear, isOnlySmall, isDivergent, leavesOut }, voice) {
  const theories = /** @type {const} */ ({ friction: ['scent.frictionless', 'scent.frictionless.short'], both: ['scent.both', 'scent.both.short'], gap: ['scent.linear', 'scent.linear.short'] });
  const [whole, short] = theories[leavesOut ?? 'gap'];
  /** @param {boolean} isStable @param {UnstableInterval['fromKind']} kind of the boundary that it is told of */
  const state = (isStable, kind) => {
    if (isOnlyLinear || isOnlySmall) return voice.say(isStable ? 'scent.stable' : 'scent.unstable');
    if (isStable) return voice.say('scent.dies-out');
    return voice.say(kind === 'divergence' || (kind === 'range' && isDivergent) ? 'scent.turns-aside' : 'scent.shimmies');
  };
  const theory = (/** @type {string} */ caption) => (isOnlyLinear ? voice.say(whole, { caption }) : isOnlySmall ? voice.say('scent.small', { caption }) : caption);
  const wordings = (/** @type {string} */ caption) =>
    isOnlyLinear ? [theory(caption), voice.say(short, { caption })] : isOnlySmall ? [theory(caption)] : [caption];
  return { voice, state, theory, wordings, least: isOnlyLinear ? [voice.say('scent.linear.shortest')] : isOnlySmall ? [voice.say('scent.small.shortest')] : [] };
}

/** Whether two boundaries are the ends of one stretch, stable or not. @param {readonly Boundary[]} boundaries */
function isPair(boundaries) {
  return boundaries.length === 2 && boundaries[0].isStableAbove !== boundaries[1].isStableAbove;
}

/**
 * @param {readonly UnstableInterval[]} intervals
 * @param {readonly Boundary[]} boundaries
 * @param {readonly string[]} numbers of the boundaries
 * @param {ReturnType<typeof phrasesOf>} phrases
 * @returns {Captions}
 */
function captionsOf(intervals, boundaries, numbers, { voice, state, wordings, least }) {
  const [first, last] = [boundaries.at(0), boundaries.at(-1)];
  if (!first || !last) {
    const all = intervals.length > 0 ? wordings(voice.say('scent.all', { state: state(false, 'range') })) : [];
    return { above: [], below: [], between: [], all, least: all.length > 0 ? least : [] };
  }
  // Of one boundary or a pair it is plain which is meant.
  const isMany = boundaries.length > 2;
  return {
    above: wordings(voice.say(isMany ? 'scent.said.above' : 'scent.above', { state: state(last.isStableAbove, last.kind), value: numbers[numbers.length - 1] })),
    below: wordings(voice.say(isMany ? 'scent.said.below' : 'scent.below', { state: state(!first.isStableAbove, first.kind), value: numbers[0] })),
    between: isPair(boundaries) ? wordings(voice.say('scent.between', { state: state(first.isStableAbove, first.kind) })) : [],
    all: [],
    least,
  };
}

/**
 * @param {readonly UnstableInterval[]} intervals
 * @param {readonly Boundary[]} boundaries
 * @param {readonly string[]} values of the boundaries, with their unit
 * @param {ReturnType<typeof phrasesOf>} phrases
 */
function inWords(intervals, boundaries, values, { voice, state, theory }) {
  const [first] = boundaries;
  if (!first) return theory(voice.say('scent.all', { state: state(intervals.length === 0, 'range') }));
  if (boundaries.length === 1) return theory(voice.say('scent.said.above', { state: state(first.isStableAbove, first.kind), value: values[0] }));
  if (isPair(boundaries)) return theory(voice.say('scent.said.between', { state: state(first.isStableAbove, first.kind), from: values[0], to: values[1] }));
  let at = 0;
  return theory(intervals.map(({ fromKind, toKind }) => {
    const from = fromKind === 'range' ? null : values[at++];
    const to = toKind === 'range' ? null : values[at++];
    if (from && to) return voice.say('scent.said.between', { state: state(false, fromKind), from, to });
    return from ? voice.say('scent.said.above', { state: state(false, fromKind), value: from })
      : voice.say('scent.said.below', { state: state(false, toKind), value: to ?? '' });
  }).join('; '));
}
