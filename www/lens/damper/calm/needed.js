/**
 * Which command calms a gear: the least above which every one does. A command that calms need not be all: below it there may be
 * islands that calm too, which nobody should rely on.
 *
 * @typedef {import('../../../pkg/shimmy.js').Basins} Basins
 * @typedef {import('../../../pkg/shimmy.js').BasinsSpec} BasinsSpec
 * @typedef {{ gear: { model: string, parameters: Record<string, number>, initial: Record<string, number> }, command: { from: number, to: number }, velocity: number }} Asked
 * @typedef {{ command: number | null }} Needed null where none in the range does
 */

/** Commands that are tried over the range, and then between the last that does not calm and the next. */
const [coarse, fine] = [25, 13];
/** As finely it is told, upward. */
const grain = 0.01;

/**
 * @param {Asked} asked
 * @param {(spec: BasinsSpec) => Promise<Basins>} follow
 * @returns {Promise<Needed>}
 */
export async function commandFor({ gear, command, velocity }, follow) {
  const last = async (/** @type {number} */ from, /** @type {number} */ to, /** @type {number} */ count) => {
    const step = (to - from) / (count - 1);
    // Cells' middles are the commands; the other axis is a row of one, whose middle is the speed.
    const x = { parameter: 'damper.command', from: Math.max(0, from - step / 2), to: to + step / 2, count };
    const first = x.from + (x.to - x.from) / (2 * count);
    const { kind, kinds } = await follow({ ...gear, x, y: { parameter: 'velocity', from: 0.999 * velocity, to: 1.001 * velocity, count: 1 }, refine: false });
    const at = (/** @type {number} */ i) => first + (i * (x.to - x.from)) / count;
    const calm = kinds.indexOf('rest');
    const place = kind.findLastIndex((one) => one !== calm);
    return { below: place < 0 ? null : at(place), above: place < 0 ? at(0) : place + 1 < count ? at(place + 1) : null };
  };
  const wide = await last(command.from, command.to, coarse);
  if (wide.above === null) return { command: null };
  if (wide.below === null) return { command: command.from };
  const near = await last(wide.below, wide.above, fine);
  const found = near.above ?? wide.above;
  return { command: Math.min(command.to, Number((Math.ceil(found / grain - 1e-9) * grain).toFixed(6))) };
}
